#include "cases/harness/run/estimate.hpp"

#include <cmath>
#include <memory>

#include "cases/harness/description/cannot_run.hpp"
#include "cases/harness/files/signals.hpp"
#include "cases/harness/run/budget.hpp"
#include "cases/harness/run/experiment.hpp"

namespace plumbline {
namespace {

std::unique_ptr<Simulation> stepped_once(const Case& entry, const Settings& settings, Scene scene) {
  try {
    auto simulation = std::make_unique<Simulation>(std::move(scene), settings.text("integrator"),
                                                   step_control(settings));
    simulation->step(HUGE_VAL);
    return simulation;
  } catch (const CannotWork& parts) {
    throw cannot_run(entry, settings, parts);
  }
}

}  // namespace

RunEstimate estimate_run(const Case& entry, const Settings& settings) {
  if (!entry.trials.empty()) return {.seconds = 1};          // nothing is known of a trial before it is made
  require_memory(foreseen_size(entry, settings), settings);  // a problem may fill its bodies as soon as it is made
  const auto problem = entry.problem(settings);
  require_end(problem->end_time());
  if (settings.is_set("dt")) require_steps(problem->end_time(), settings.number("dt"), settings);
  Scene scene = problem->unprepared();
  const SceneSize size = size_of(scene);
  require_memory(size, settings);
  const auto simulation = stepped_once(entry, settings, std::move(scene));
  throw_if_interrupted();
  constexpr double rate = 1e7;  // particle-steps per second of one slow core
  RunEstimate estimate;
  estimate.points = simulation->points();
  estimate.steps = std::ceil(problem->end_time() / simulation->last_dt());
  require_steps(problem->end_time(), simulation->last_dt(), settings);
  estimate.cells = size.cells;
  estimate.bytes = size.bytes();
  const double prepared = std::ceil(problem->preparation() / simulation->last_dt());
  estimate.seconds = static_cast<double>(estimate.points) * (prepared + estimate.steps) / rate;
  return estimate;
}

}  // namespace plumbline
