#include "cases/harness/commands/bench_timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "cases/harness/files/signals.hpp"
#include "cases/harness/run/machine.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {
namespace {

constexpr double shortest_repeat = 0.05;  // s: many slices of time of a busy machine
constexpr long longest_round = 50;        // steps: the flow stays the one that has developed
constexpr double no_end = std::numeric_limits<double>::max();

StepControl control_with(int threads) {
  StepControl control;
  control.threads = threads;
  return control;
}

void take_steps(Simulation& simulation, long steps) {
  for (long k = 0; k < steps; ++k) {
    simulation.step(no_end);
    throw_if_interrupted();
  }
}

Checkpoint developed(const BenchFlow& flow, int threads) {
  Simulation simulation(flow_scene(flow), flow.integrator, control_with(threads));
  take_steps(simulation, bench_warm_up);
  return simulation.save();
}

// Seconds a step over rounds of `steps` steps that start from the same state and together last long enough.
double time_of_step(Simulation& simulation, const Checkpoint& state, long steps) {
  double time = 0;
  long taken = 0;
  for (; taken == 0 || time < shortest_repeat; taken += steps) {
    simulation.restore(state);
    take_steps(simulation, 1);  // sorts from scratch
    time += seconds([&] { take_steps(simulation, steps); });
  }
  return time / static_cast<double>(taken);
}

StepTiming timed(const BenchFlow& flow, const Checkpoint& state, int threads) {
  const std::optional<double> before = allocated_bytes();
  Simulation simulation(flow_scene(flow), flow.integrator, control_with(threads));
  simulation.restore(state);
  take_steps(simulation, 1);  // makes the buffers
  const std::optional<double> after = allocated_bytes();
  const double one = seconds([&] { take_steps(simulation, 1); });
  const long steps = std::clamp(std::lround(std::ceil(shortest_repeat / one)), 2L, longest_round);
  std::vector<double> times;
  for (int k = 0; k < bench_repeats; ++k) times.push_back(time_of_step(simulation, state, steps));
  std::sort(times.begin(), times.end());
  StepTiming timing;
  timing.threads = threads;
  timing.points = simulation.points();
  timing.steps = simulation.steps();
  timing.fastest = times.front();
  timing.median = times[times.size() / 2];
  timing.slowest = times.back();
  timing.stored_bytes = 8.0 * simulation.scene().bodies.front().points.doubles_per_point() + sizeof(int);
  if (before && after) timing.allocated_bytes = (*after - *before) / static_cast<double>(timing.points);
  timing.energy_drift = simulation.ledger().energy.relative_drift(false);
  return timing;
}

}  // namespace

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<StepTiming> time_flow(const BenchFlow& flow, const std::vector<int>& threads) {
  constexpr long many = 100000;  // points that are worth a second thread, also beside other work
  const int most = *std::max_element(threads.begin(), threads.end());
  const Checkpoint state = developed(flow, flow.points >= many ? most : 1);
  std::vector<StepTiming> timings;
  for (const int t : threads) timings.push_back(timed(flow, state, t));
  return timings;
}

}  // namespace plumbline
