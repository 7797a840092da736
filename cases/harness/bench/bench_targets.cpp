#include "cases/harness/bench/bench_targets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace plumbline {

Json target_entry(const std::string& name, const std::string& unit, double measured, std::optional<double> low,
                  std::optional<double> high) {
  const bool met = (!low || measured >= *low) && (!high || measured <= *high);
  return {{"name", name},        {"unit", unit},          {"measured", measured},
          {"low", or_null(low)}, {"high", or_null(high)}, {"met", met}};
}

std::vector<Json> scale_targets(const Json& kernels) {
  struct Costs {
    double least = HUGE_VAL, most = 0;
    long smallest = 0, largest = 0;
  };
  std::map<int, Costs> by_threads;
  for (const Json& kernel : kernels) {
    const long points = kernel.at("points").get<long>();
    if (kernel.at("part") != "scale" || points < 9000) continue;  // whole cells: 1e4 may be a little less
    const double cost = 1 / kernel.at("particle_steps_per_s").get<double>();
    Costs& costs = by_threads[kernel.at("threads").get<int>()];
    if (costs.smallest == 0) costs.smallest = points;
    costs.largest = points;
    costs.least = std::min(costs.least, cost);
    costs.most = std::max(costs.most, cost);
  }
  std::vector<Json> targets;
  for (const auto& [threads, costs] : by_threads) {
    if (costs.largest == costs.smallest) continue;
    targets.push_back(
        target_entry(fmt::format("max over min cost of a particle-step, {:.0e} to {:.0e} points, {} thread{}",
                                 static_cast<double>(costs.smallest), static_cast<double>(costs.largest), threads,
                                 threads == 1 ? "" : "s"),
                     "1", costs.most / costs.least, {}, 1.5));
  }
  return targets;
}

}  // namespace plumbline
