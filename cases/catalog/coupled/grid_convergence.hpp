// What a number would be on ever finer grids, where no exact answer exists, and how uncertain that of the finest is.
#pragma once

#include <utility>
#include <vector>

namespace plumbline {

// f(h) = limit + slope h^order fitted to all levels by least squares, the order known from theory.
//   uncertainty = 1.25 |f(h_1) - limit| + sigma + |f_1 - f(h_1)|                                                [GCI 1]
// of the value f_1 on the finest grid h_1, sigma the standard deviation of the fit with n - 2 degrees of freedom. It is
// meant to cover the exact value of the equations in 95 of 100 cases (Roache's safety factor 1.25).
// L. Eca, M. Hoekstra, J. Comput. Phys. 262 (2014) 104, doi 10.1016/j.jcp.2014.01.006.
struct GridConvergence {
  double finest = 0, limit = 0, slope = 0, uncertainty = 0;
};

// levels: (h, value), h > 0, at least three with different h, in any order. Throws std::invalid_argument else.
GridConvergence grid_convergence(std::vector<std::pair<double, double>> levels, double order);

}  // namespace plumbline
