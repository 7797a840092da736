#include "cases/catalog/solid/collision.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/measures.hpp"
#include "cases/harness/description/settings.hpp"
#include "kernel/contact/contact.hpp"
#include "kernel/contact/pair_potential.hpp"

namespace plumbline {

BodyMotion motion_of(const Body& body, int dim) {
  BodyMotion motion;
  const double* mass = body.points(column::mass);
  for (int p = 0; p < body.points.points(); ++p) motion.mass += mass[p];
  for (int d = 0; d < dim; ++d) {
    const double *x = body.points(column::position, d), *v = body.points(column::velocity, d);
    double place = 0, momentum = 0;
    for (int p = 0; p < body.points.points(); ++p) {
      place += mass[p] * x[p];
      momentum += mass[p] * v[p];
    }
    motion.position[static_cast<std::size_t>(d)] = place / motion.mass;
    motion.velocity[static_cast<std::size_t>(d)] = momentum / motion.mass;
  }
  return motion;
}

double highest_point(const Body& body, int d) {
  const double* x = body.points(column::position, d);
  return *std::max_element(x, x + body.points.points());
}

double lowest_point(const Body& body, int d) {
  const double* x = body.points(column::position, d);
  return *std::min_element(x, x + body.points.points());
}

double spacings_apart(const Settings& settings) {
  const ContactEntry* law = find_named(contacts(), settings.text("contact"));
  return law && law->by_pairs ? pair_reach - 1 : -0.15;
}

double friction_work(const Simulation& simulation) {
  return -simulation.ledger().energy.flow(Flow::contact) - contact_energy(simulation.scene());
}

void EnergyWatch::observe(const Simulation& simulation) {
  if (!started_) start_ = last_ = simulation.ledger().initial_stores.total();
  started_ = true;
  const double energy = simulation.ledger().stores.total() + contact_energy(simulation.scene());
  rise_ = larger(rise_, (energy - last_) / start_);
  highest_ = larger(highest_, energy / start_);
  last_ = energy;
}

void EnergyWatch::history(Archive& archive) {
  archive("started", started_);
  archive("start", start_);
  archive("last", last_);
  archive("rise", rise_);
  archive("highest", highest_);
}

void MomentumWatch::observe(const Simulation& simulation) {
  const Account& account = simulation.ledger().momentum[d_];
  error_ = larger(error_, std::abs(account.store() - account.initial()) / account.scale());
}

void MomentumWatch::history(Archive& archive) { archive("error", error_); }

void PushWatch::observe(const Body& body, int dim, double time) {
  const BodyMotion motion = motion_of(body, dim);
  observe(time, motion.mass * motion.velocity[static_cast<std::size_t>(d_)]);
}

void PushWatch::observe(double time, double momentum) {
  times_.push_back(time);
  momenta_.push_back(momentum);
}

void PushWatch::history(Archive& archive) {
  archive("times", times_);
  archive("momenta", momenta_);
}

double PushWatch::time_of(double share) const {
  const double given = momenta_.back() - momenta_.front();
  if (given == 0) return std::nan("");
  for (std::size_t k = 1; k < times_.size(); ++k) {
    const double before = (momenta_[k - 1] - momenta_.front()) / given, now = (momenta_[k] - momenta_.front()) / given;
    if (now < share) continue;
    return times_[k - 1] + (times_[k] - times_[k - 1]) * (share - before) / (now - before);
  }
  return std::nan("");
}

std::vector<double> values_of(const StudyResult& study, const std::string& measure) {
  if (study.levels.empty()) throw std::runtime_error("the study has no runs");
  std::vector<double> values;
  for (const StudyLevel& level : study.levels) {
    const Measure* found = level.run.find(measure);
    if (!found || !found->value) throw std::runtime_error("a run has no value of " + measure);
    values.push_back(*found->value);
  }
  return values;
}

double least_rise(const std::vector<double>& values) {
  double least = HUGE_VAL;
  for (std::size_t k = 1; k < values.size(); ++k) least = smaller(least, values[k] - values[k - 1]);
  return least;
}

std::vector<CaseGate> conservation_gates(const std::string& study, const std::vector<double>& levels, Tier tier) {
  std::vector<CaseGate> all;
  for (const double level : levels) {
    const std::string at = "-" + to_text(level);
    all.push_back(gate(study + "/energy-rise" + at, value_at("energy_rise", level), at_most(1e-13),
                       theory("no step of the midpoint rule raises the energy of a linear elastic body, contact "
                              "included; sums over points round at 1e-15"))
                      .in(tier));
    all.push_back(gate(study + "/momentum-kept" + at, value_at("momentum_error", level), at_most(1e-12),
                       identity("equal and opposite impulses at each node"))
                      .in(tier));
  }
  return all;
}

}  // namespace plumbline
