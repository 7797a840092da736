// What one step asks of the machine for each point: bytes to and from memory, and floating-point operations.
#pragma once

#include <optional>

#include "cases/harness/bench/bench_flow.hpp"

namespace plumbline {

struct PointWork {
  double bytes = 0;       // read and written by one step, each column once in each pass over the points
  double operations = 0;  // sums, products, quotients and functions of one step
};

// Counted pass by pass for the integrators whose passes are known (leapfrog, energy, musl), not measured: bytes from the
// columns that a pass reads and writes, operations by computing with numbers that count (bench_trace.hpp) on the kernel's
// own shapes and stencils. Nodes are left out, as are the sums over the lanes of a bin: the counts are lower bounds.
std::optional<PointWork> work_per_point(const BenchFlow& flow);

}  // namespace plumbline
