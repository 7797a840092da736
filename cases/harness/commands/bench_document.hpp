// The parts of the bench, and the JSON that tells of them.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cases/harness/commands/bench_timing.hpp"
#include "cases/harness/results/documents.hpp"

namespace plumbline {

// What the machine can do at best, measured when first asked for.
class MachineLimits {
 public:
  double copy_bytes_per_s(double bytes, int threads);  // arrays of the next power of two, at least 64 KiB
  double flops_per_s(int threads);
  Json document() const;  // everything that was measured

 private:
  std::map<std::pair<int, int>, double> copies_;  // by threads and exponent of two
  std::map<int, double> flops_;
};

// An entry of "kernels". part: matrix, target or scale.
Json kernel_entry(const std::string& part, const BenchFlow& flow, const StepTiming& timing, MachineLimits& limits);

}  // namespace plumbline
