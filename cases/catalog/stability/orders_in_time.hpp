// Orders of accuracy in the step alone, by the harness's estimator.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {

// Runs to time t in 2^k times `steps` steps, k = 0 ... halvings; error_of says how far off each quantity is then, of
// numbers of order one. `bound`: of the exact solution.
std::map<std::string, MeasuredOrder> orders_in_time(const std::vector<std::string>& quantities, double t, int steps,
                                                    int halvings, double bound,
                                                    const std::function<std::vector<double>(int steps)>& error_of);

}  // namespace plumbline
