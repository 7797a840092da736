// Times the production step (ledger, stable step, checks and re-binning included) on a flow that has developed.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "cases/harness/bench/bench_flow.hpp"

namespace plumbline {

inline constexpr int bench_repeats = 5;
inline constexpr long bench_warm_up = 100;  // steps before the first that is timed

struct StepTiming {
  int threads = 1;
  long points = 0, steps = 0;                   // steps of the whole run, the first not timed
  double fastest = 0, median = 0, slowest = 0;  // seconds a step, of the repeats
  double stored_bytes = 0;                      // columns and number of a point, counted
  std::optional<double> allocated_bytes;        // per point, measured: grid, bins and buffers included
  double energy_drift = 0;                      // relative, over the whole run
  double rate(double seconds) const { return static_cast<double>(points) / seconds; }  // particle-steps/s
};

double seconds(const std::function<void()>& work);

// One developed state, from which each number of threads goes on. Throws InadmissibleState, and Interrupted if a signal
// arrives.
std::vector<StepTiming> time_flow(const BenchFlow& flow, const std::vector<int>& threads);

}  // namespace plumbline
