#include "cases/harness/estimate.hpp"

#include <cmath>

#include "cases/harness/experiment.hpp"

namespace plumbline {

RunEstimate estimate_run(const Case& entry, const Settings& settings) {
  const auto problem = entry.problem(settings);
  Simulation simulation(problem->scene(), settings.text("integrator"), step_control(settings));
  simulation.step(HUGE_VAL);
  constexpr double rate = 1e7;  // point-steps per second of one slow core
  RunEstimate estimate;
  estimate.points = simulation.points();
  estimate.steps = std::ceil(problem->end_time() / simulation.last_dt());
  const GridSpec& grid = simulation.scene().grid;
  estimate.cells = static_cast<double>(grid.cells[0]) * grid.cells[1] * grid.cells[2];
  const double points = static_cast<double>(estimate.points);
  estimate.bytes = points * 8 * simulation.scene().bodies.front().points.doubles_per_point() +
                   estimate.cells * 8 * (2 + 6 * grid.dim);
  estimate.seconds = points * estimate.steps / rate;
  return estimate;
}

}  // namespace plumbline
