#include "kernel/simulation.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "kernel/engine/stage_queue.hpp"
#include "kernel/integrator_traits.hpp"
#include "kernel/splitting.hpp"
#include "kernel/step_under_way.hpp"

namespace plumbline {

Simulation::Simulation(Scene scene, const std::string& integrator, StepControl control)
    : scene_(std::move(scene)),
      control_(control) {
  const IntegratorEntry* entry = find_integrator(integrator);
  if (!entry) throw std::invalid_argument("no integrator " + integrator);
  integrator_ = entry->make();
  copy_integrator_ = entry->copy;
  set_parameters(*integrator_, control_.parameters);
  if (auto missing = lacks(*entry, scene_); !missing.empty()) throw CannotWork(std::move(missing));
  if (const std::string why = splitting_refusal(scene_.shape, scene_.transfer); scene_.split > 0 && !why.empty()) {
    throw std::invalid_argument("points cannot be split with shape " + scene_.shape + " and transfer " +
                                scene_.transfer + ": " + why);
  }
  engine_ = make_engine(scene_, ledger_, engine_options(*entry, control_.threads));
  engine_->initialise();
  ledger_.open(engine_->totals());
}

void Simulation::step(double longest) {
  try {
    const auto limit = [&] { return restored_limit_ ? *restored_limit_ : engine_->step_limit(); };
    last_dt_ = std::min(longest, control_.dt ? *control_.dt : control_.cfl * limit());
    restored_limit_.reset();
    ++step_;
    const InStep here(step_, time_);
    engine_->set_time(time_);
    take_step(*integrator_, *engine_, last_dt_, control_.fusing);
    if (split_points(scene_, time_ + last_dt_, control_.threads, ledger_) > 0) engine_->points_changed();
    ledger_.close_step(engine_->totals());
    if (!engine_->survey().admissible) stop_at_inadmissible(scene_);
  } catch (InadmissibleState& state) {
    state.step = step_;
    state.time = time_;
    throw;
  }
  time_ += last_dt_;
}

void Simulation::run_until(double end, const std::function<void(const Simulation&)>& after_step) {
  // A remainder below 1e-12 of the span is rounding of the sum of steps, not a step.
  while (end - time_ > 1e-12 * end) {
    step(end - time_);
    if (after_step) after_step(*this);
  }
}

long Simulation::points() const {
  long total = 0;
  for (const Body& body : scene_.bodies) total += body.points.points();
  return total;
}

Checkpoint Simulation::save() const {
  Checkpoint checkpoint{time_,
                        step_,
                        {},
                        {},
                        {},
                        ledger_,
                        copy_integrator_(*integrator_),
                        restored_limit_ ? *restored_limit_ : engine_->step_limit()};
  for (const Body& body : scene_.bodies) {
    checkpoint.points.push_back(body.points);
    checkpoint.ids.push_back(body.id);
    checkpoint.split_from.push_back(body.split_from);
  }
  return checkpoint;
}

void Simulation::restore(const Checkpoint& checkpoint) {
  if (checkpoint.points.size() != scene_.bodies.size()) throw std::invalid_argument("checkpoint of another scene");
  for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
    const std::size_t made = checkpoint.ids[b].size() - checkpoint.split_from[b].size();
    if (made != scene_.bodies[b].id.size() - scene_.bodies[b].split_from.size()) {
      throw std::invalid_argument("checkpoint of another scene");
    }
    scene_.bodies[b].points = checkpoint.points[b];
    scene_.bodies[b].id = checkpoint.ids[b];
    scene_.bodies[b].split_from = checkpoint.split_from[b];
  }
  ledger_ = checkpoint.ledger;
  integrator_ = copy_integrator_(*checkpoint.integrator);
  time_ = checkpoint.time;
  step_ = checkpoint.step;
  restored_limit_ = checkpoint.step_limit;
  engine_->points_changed(time_);
}

}  // namespace plumbline
