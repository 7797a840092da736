// The plane that separates two clouds of points best.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plumbline {

// Points of two bodies around a node, xi = (x - x_node)/h, as they are added.
template <int dim>
struct Clouds {
  using Vec = Eigen::Matrix<double, dim, 1>;
  std::vector<Vec> first, second;
};

// The direction from the first cloud to the second across the plane a . xi + b = 0 of logistic regression: the minimum of
//   1/2 lambda |a|^2 + sum_s 1/W_s sum_p w_p log(1 + exp(-+ (a . xi_p + b))),  - of the second,  W_s = sum_p w_p,  lambda = 1e-4,
//   w_p = prod_d (1 - (xi_d/reach)^2)^2 within the reach of the node, none beyond,
// a convex function with one minimum, which Newton's steps find. What lies in a cloud far from the other, or to one side of it,
// hardly turns the plane. Of length 1; zero if a cloud has no point within reach. (J. A. Nairn, C. C. Hammerquist, G. D. Smith
// 2020, doi 10.1016/j.cma.2020.112859, with other weights and another measure of fit.)                        [Touching 2]
// reach: cells, > 0.
template <int dim>
Eigen::Matrix<double, dim, 1> separating_direction(const Clouds<dim>& clouds, double reach);

extern template Eigen::Matrix<double, 1, 1> separating_direction<1>(const Clouds<1>&, double);
extern template Eigen::Matrix<double, 2, 1> separating_direction<2>(const Clouds<2>&, double);
extern template Eigen::Matrix<double, 3, 1> separating_direction<3>(const Clouds<3>&, double);

}  // namespace plumbline
