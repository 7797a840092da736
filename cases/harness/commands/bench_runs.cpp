#include "cases/harness/commands/bench_runs.hpp"

#include <algorithm>

#include "cases/harness/bench/bench_targets.hpp"
#include "cases/harness/run/experiment.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {

std::pair<Json, Json> time_run(const TimedRun& timed, const std::vector<std::string>& typed, int repeats) {
  const Case& entry = find_case(timed.case_name);
  std::vector<Override> overrides = timed.overrides;
  overrides.emplace_back("cells", static_cast<double>(timed.cells));
  const Settings settings = entry.settings(timed.scheme, overrides, typed);
  std::vector<double> times;
  RunResult run = run_experiment(entry, timed.scheme, settings);
  for (int k = 0; k < repeats; ++k) times.push_back(run_experiment(entry, timed.scheme, settings).wall_s);
  std::sort(times.begin(), times.end());
  const double median = times[times.size() / 2];
  const double particle_steps = static_cast<double>(run.points) * static_cast<double>(run.steps);
  Json kernel{{"name", timed.name},
              {"part", "run"},
              {"dimension", run.dim},
              {"axisymmetric", run.axisymmetric},
              {"material", name(entry.kind)},
              {"shape", settings.text("shape")},
              {"transfer", settings.text("transfer")},
              {"integrator", settings.text("integrator")},
              {"points", run.points},
              {"ppc", settings.number("ppc")},
              {"threads", 1},
              {"steps", run.steps},
              {"wall_s", median},
              {"repeats", repeats},
              {"particle_steps_per_s", particle_steps / median},
              {"fastest", particle_steps / times.front()},
              {"slowest", particle_steps / times.back()},
              {"bytes_per_point", nullptr},
              {"flops_per_point", nullptr},
              {"fraction_of_limit", nullptr},
              {"stored_bytes_per_point", 8.0 * run.doubles_per_point + sizeof(int)},
              {"energy_drift", run.ledger.energy.relative_drift(false)}};
  Json target = timed.target_is_time
                    ? target_entry(timed.name, "s", median, {}, timed.target)
                    : target_entry(timed.name, "particle-steps/s", particle_steps / median, timed.target, {});
  return {std::move(kernel), std::move(target)};
}

double time_empty_step() {
  Scene scene;
  scene.grid.cells[0] = 4;
  scene.shape = "linear";
  scene.transfer = "flip";
  auto membrane = std::make_shared<UniaxialMembrane>();
  membrane->youngs_modulus = membrane->density = 1;
  Body body = make_body("point", membrane, 1, 1);
  body.points(column::position)[0] = 2.0;
  body.points(column::mass)[0] = body.points(column::volume)[0] = 1.0;
  scene.bodies.push_back(body);
  StepControl control;
  control.dt = 1e-3;
  Simulation simulation(scene, "musl", control);
  constexpr int steps = 200000;
  const double time = seconds([&] {
    for (int k = 0; k < steps; ++k) simulation.step(1.0);
  });
  return time / steps;
}

}  // namespace plumbline
