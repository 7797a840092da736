// The finite-volume comparator beside a gas case: what a gas dynamicist's scheme gets for what it costs.
#pragma once

#include "cases/harness/description/case.hpp"
#include "reference/gas_problem.hpp"
#include "reference/riemann.hpp"

namespace plumbline {

// Errors (L1 means over the problem's domain, as `density.L1` and the others) and cost of the MUSCL-HLLC scheme at each
// number of cells along that domain. exact: at the problem's end time.
Comparator finite_volume_comparator(const reference::GasProblem& problem,
                                    const std::function<reference::Sample(double x)>& exact,
                                    const std::vector<double>& cells);

}  // namespace plumbline
