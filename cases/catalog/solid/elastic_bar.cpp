#include "cases/catalog/solid/elastic_bar.hpp"

#include <cmath>
#include <utility>

#include "cases/catalog/solid/collision.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/fill_solid.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/run/judged_at_end.hpp"
#include "kernel/materials/linear_elastic.hpp"

namespace plumbline {
namespace {

std::size_t number_of_point(const Body& body, int p) {
  return static_cast<std::size_t>(body.id[static_cast<std::size_t>(p)]);
}

class ElasticBarProblem final : public Problem, public JudgedAtEnd {
 public:
  ElasticBarProblem(ElasticBar bar, const Settings& settings) : settings_(settings), bar_(std::move(bar)) {
    h_ = bar_.length / settings.number("cells");
    const Body body = points();
    for (int p = 0; p < body.points.points(); ++p) start_.push_back(body.points(column::position)[p]);
  }

  double end_time() const override { return bar_.end_time; }

  Scene scene() const override {
    Scene scene;
    scene.grid = grid();
    Body body = points();
    const bool affine = settings_.text("transfer") == "apic" && bar_.velocity_gradient;
    if (affine) body.points.add(column::affine);
    for (int p = 0; p < body.points.points(); ++p) {
      const double x = start_[static_cast<std::size_t>(p)];
      const BarSample at = bar_.exact(x, 0);
      body.points(column::velocity)[p] = at.velocity.value;
      body.points(column::strain)[p] = at.stress.value / bar_.youngs_modulus;
      if (affine) body.points(column::affine)[p] = bar_.velocity_gradient(x);
    }
    scene.bodies.push_back(std::move(body));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override {
    energy_.observe(simulation);
    const Body& body = simulation.scene().bodies.front();
    double square = 0, size = 0;
    for (int p = 0; p < body.points.points(); ++p) {
      const double x = start_of(body, p);
      const double exact = bar_.exact(x, simulation.time()).displacement.value;
      const double error = body.points(column::position)[p] - x - exact, volume = body.points(column::volume)[p];
      square += volume * error * error;
      size += volume * exact * exact;
    }
    largest_ = larger(largest_, std::sqrt(size));
    history_.time.push_back(simulation.time());
    history_.mean_velocity.push_back(motion_of(body, 1).velocity[0]);
    history_.displacement_error.push_back(std::sqrt(square));
    history_.energy.push_back(simulation.ledger().stores.total());
  }
  void history(Archive& archive) override {
    archive("energy", energy_);
    archive("largest", largest_);
    archive("time", history_.time);
    archive("mean_velocity", history_.mean_velocity);
    archive("displacement_error", history_.displacement_error);
    archive("total_energy", history_.energy);
  }

  std::vector<std::string> seen_on_the_way() const override {
    std::vector<std::string> names{"displacement.worst", "energy_rise", "energy_lost"};
    if (!bar_.further) return names;
    for (const Measure& m : bar_.further({})) names.push_back(m.name);
    return names;
  }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const Body& body = simulation.scene().bodies.front();
    const auto exact = [&](double x) { return bar_.exact(x, simulation.time()); };
    std::vector<Measure> all = bar_norms(body, start_, exact, [&](int p) { return stress_of(body, p); });
    double bound = 0;
    for (int p = 0; p < body.points.points(); ++p) {
      const double unsure = exact(start_of(body, p)).displacement.bound;
      bound += body.points(column::volume)[p] * unsure * unsure;
    }
    Measure worst;
    worst.name = "displacement.worst";
    worst.unit = "m^1.5";
    for (const double error : history_.displacement_error) worst.error = larger(worst.error, error);
    worst.scale = largest_;
    worst.reference_bound = std::sqrt(bound);
    all.push_back(worst);
    all.push_back(scalar_measure("energy_rise", energy_.largest_rise(), 0, 0, "1"));
    all.push_back(scalar_measure("energy_lost", 1 - energy_.kept(), 0, 0, "1"));
    if (bar_.further) {
      for (Measure& m : bar_.further(history_)) all.push_back(std::move(m));
    }
    return all;
  }

  Profile profile(const Simulation& simulation) const override {
    Profile profile;
    profile.abscissa = "x";
    profile.columns = {{"x", "m", "place in the unstretched bar", {}},
                       {"displacement", "m", "displacement", {}},
                       {"displacement_reference", "m", "exact displacement", {}},
                       {"velocity", "m/s", "velocity", {}},
                       {"velocity_reference", "m/s", "exact velocity", {}},
                       {"stress", "Pa", "stress", {}},
                       {"stress_reference", "Pa", "exact stress", {}}};
    const Body& body = simulation.scene().bodies.front();
    std::vector<int> place(start_.size());
    for (int p = 0; p < body.points.points(); ++p) place[number_of_point(body, p)] = p;
    for (std::size_t k = 0; k < start_.size(); ++k) {
      const int p = place[k];
      const BarSample exact = bar_.exact(start_[k], simulation.time());
      const double row[] = {start_[k],
                            body.points(column::position)[p] - start_[k],
                            exact.displacement.value,
                            body.points(column::velocity)[p],
                            exact.velocity.value,
                            stress_of(body, p),
                            exact.stress.value};
      for (std::size_t c = 0; c < profile.columns.size(); ++c) profile.columns[c].values.push_back(row[c]);
    }
    return profile;
  }

 private:
  double start_of(const Body& body, int p) const { return start_[number_of_point(body, p)]; }
  double stress_of(const Body& body, int p) const { return bar_.youngs_modulus * body.points(column::strain)[p]; }

  // Node lines at the ends of the unstretched bar.
  GridSpec grid() const {
    GridSpec grid;
    grid.h = h_;
    const int margin_cells = whole(std::ceil(bar_.margin / h_)) + 2;
    grid.cells[0] = settings_.integer("cells") + (bar_.fixed ? 1 : 2) * margin_cells;
    grid.origin[0] = bar_.fixed ? 0 : -margin_cells * h_;
    grid.walls[0] = {bar_.fixed ? Wall::symmetry : Wall::free, Wall::free};
    return grid;
  }

  Body points() const {
    auto material = std::make_shared<LinearElastic>();
    material->youngs_modulus = bar_.youngs_modulus;
    material->density = bar_.density;
    return fill_solid("bar", material, {.low = {0, 0, 0}, .high = {bar_.length, 0, 0}}, bar_.density,
                      settings_.integer("ppc"), grid());
  }

  Settings settings_;
  ElasticBar bar_;
  double h_ = 0, largest_ = 0;
  std::vector<double> start_;  // X by the point's number
  EnergyWatch energy_;
  ElasticBar::History history_;
};

}  // namespace

std::vector<Measure> bar_norms(const Body& body, const std::vector<double>& start,
                               const std::function<BarSample(double x)>& exact,
                               const std::function<double(int p)>& stress) {
  std::vector<FieldSample> displacements, velocities, stresses;
  for (int p = 0; p < body.points.points(); ++p) {
    const double x = start[number_of_point(body, p)], here = body.points(column::position)[p];
    const BarSample right = exact(x);
    const auto add = [&](std::vector<FieldSample>& to, double computed, const reference::Bounded& value) {
      to.push_back({body.points(column::volume)[p], here, computed, value.value, value.bound});
    };
    add(displacements, here - x, right.displacement);
    add(velocities, body.points(column::velocity)[p], right.velocity);
    add(stresses, stress(p), right.stress);
  }
  std::vector<Measure> all = field_norms("displacement", "m", displacements);
  for (Measure& m : field_norms("velocity", "m/s", velocities)) all.push_back(std::move(m));
  for (Measure& m : field_norms("stress", "Pa", stresses)) all.push_back(std::move(m));
  return all;
}

std::unique_ptr<Problem> elastic_bar_problem(ElasticBar bar, const Settings& settings) {
  return std::make_unique<ElasticBarProblem>(std::move(bar), settings);
}

}  // namespace plumbline
