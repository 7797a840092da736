#include "cases/harness/commands/bench_document.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "cases/harness/bench/bench_targets.hpp"
#include "cases/harness/bench/bench_work.hpp"
#include "cases/harness/results/provenance.hpp"
#include "cases/harness/run/machine.hpp"

namespace plumbline {
namespace {

int exponent_for(double bytes) { return std::max(16, static_cast<int>(std::ceil(std::log2(bytes)))); }

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

}  // namespace plumbline
