#include "cases/harness/run/judged_at_end.hpp"

#include <algorithm>

#include "cases/harness/run/experiment.hpp"

namespace plumbline {

std::vector<Measure> measures_at_end(const Problem& problem, const Simulation& simulation) {
  std::vector<std::string> seen;
  if (const auto* at_end = dynamic_cast<const JudgedAtEnd*>(&problem)) seen = at_end->seen_on_the_way();
  std::vector<Measure> all = problem.measures(simulation);
  std::erase_if(all, [&](const Measure& m) { return std::find(seen.begin(), seen.end(), m.name) != seen.end(); });
  return all;
}

std::vector<Measure> measures_of_start(const Problem& problem, const Settings& settings) {
  Simulation simulation(problem.scene(), settings.text("integrator"), step_control(settings));
  Checkpoint state = simulation.save();
  state.time = problem.end_time();
  simulation.restore(state);
  return measures_at_end(problem, simulation);
}

}  // namespace plumbline
