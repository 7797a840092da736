// Whole runs of cases, timed from the first step to the last as `run` does them.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/commands/bench_document.hpp"
#include "cases/harness/description/settings.hpp"

namespace plumbline {

struct TimedRun {
  std::string name, case_name, scheme;
  int cells;
  double target;  // particle-steps per second, or seconds where target_is_time
  bool target_is_time;
  std::vector<Override> overrides = {};  // of the scheme
};

// Its entry of "kernels" (part: run) and of "targets", of the median of so many runs (>= 1) on one thread.
std::pair<Json, Json> time_run(const TimedRun& run, const std::vector<std::string>& typed, int repeats);

// Seconds of a step of a scene of one point: what a step costs beside its points.
double time_empty_step();

}  // namespace plumbline
