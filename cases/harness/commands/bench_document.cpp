#include "cases/harness/commands/bench_document.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "cases/harness/commands/bench_work.hpp"
#include "cases/harness/results/provenance.hpp"
#include "cases/harness/run/machine.hpp"

namespace plumbline {
namespace {

int exponent_for(double bytes) { return std::max(16, static_cast<int>(std::ceil(std::log2(bytes)))); }

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

}  // namespace

double MachineLimits::copy_bytes_per_s(double bytes, int threads) {
  const int exponent = exponent_for(bytes);
  const auto [at, is_new] = copies_.try_emplace({threads, exponent});
  if (is_new) at->second = copy_rate(std::size_t{1} << exponent, threads);
  return at->second;
}

double MachineLimits::flops_per_s(int threads) {
  const auto [at, is_new] = flops_.try_emplace(threads);
  if (is_new) at->second = fma_rate(threads);
  return at->second;
}

Json MachineLimits::document() const {
  const Provenance p = build_provenance();
  Json copies = Json::array(), flops = Json::array();
  for (const auto& [key, rate] : copies_) {
    copies.push_back({{"threads", key.first}, {"bytes", std::exp2(key.second)}, {"bytes_per_s", rate}});
  }
  for (const auto& [threads, rate] : flops_) flops.push_back({{"threads", threads}, {"flops_per_s", rate}});
  Json caches = Json::array();
  for (const int level : {_SC_LEVEL1_DCACHE_SIZE, _SC_LEVEL2_CACHE_SIZE, _SC_LEVEL3_CACHE_SIZE}) {
    if (const long size = ::sysconf(level); size > 0) caches.push_back(size);
  }
  return {{"cpu", p.cpu},           {"instruction_set", p.instruction_set},
          {"compiler", p.compiler}, {"flags", p.flags},
          {"cache_bytes", caches},  {"copy", copies},
          {"multiply_add", flops}};
}

Json kernel_entry(const std::string& part, const BenchFlow& flow, const StepTiming& timing, MachineLimits& limits) {
  const double points = static_cast<double>(timing.points), rate = timing.rate(timing.median);
  const std::optional<PointWork> work = work_per_point(flow);
  std::optional<double> bandwidth, arithmetic, larger;
  if (work) {
    const double working_set = points * timing.stored_bytes;
    bandwidth = rate * work->bytes / limits.copy_bytes_per_s(working_set, timing.threads);
    arithmetic = rate * work->operations / limits.flops_per_s(timing.threads);
    larger = std::max(*bandwidth, *arithmetic);
  }
  return {{"name", flow.name()},
          {"part", part},
          {"dimension", flow.dimension},
          {"axisymmetric", flow.axisymmetric},
          {"material", "gas"},
          {"shape", flow.shape},
          {"transfer", flow.transfer},
          {"integrator", flow.integrator},
          {"points", timing.points},
          {"ppc", flow.ppc()},
          {"threads", timing.threads},
          {"steps", timing.steps},
          {"repeats", bench_repeats},
          {"particle_steps_per_s", rate},
          {"fastest", timing.rate(timing.fastest)},
          {"slowest", timing.rate(timing.slowest)},
          {"bytes_per_point", or_null(work ? std::optional(work->bytes) : std::nullopt)},
          {"flops_per_point", or_null(work ? std::optional(work->operations) : std::nullopt)},
          {"bandwidth_fraction", or_null(bandwidth)},
          {"flop_fraction", or_null(arithmetic)},
          {"fraction_of_limit", or_null(larger)},
          {"stored_bytes_per_point", timing.stored_bytes},
          {"memory_bytes_per_point", or_null(timing.allocated_bytes)},
          {"energy_drift", timing.energy_drift}};
}

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
