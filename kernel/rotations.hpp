// Rotations of angular momenta: one in the plane (about z), three in space (about x, y, z).
#pragma once

#include <Eigen/Core>

namespace plumbline {

template <int dim>
inline constexpr int rotation_count = dim*(dim - 1) / 2;

// The two axes that turn into each other under rotation k: a x b has component a_i b_j - a_j b_i there.
template <int dim>
constexpr int rotation_axis(int k, int which) {
  return dim == 2 ? which : (k + 1 + which) % 3;
}
template <int dim>
using Spin = Eigen::Array<double, rotation_count<dim>, 1>;

template <int dim>
Spin<dim> cross(const Eigen::Matrix<double, dim, 1>& a, const Eigen::Matrix<double, dim, 1>& b) {
  Spin<dim> c;
  for (int k = 0; k < rotation_count<dim>; ++k) {
    const int i = rotation_axis<dim>(k, 0), j = rotation_axis<dim>(k, 1);
    c[k] = a[i] * b[j] - a[j] * b[i];
  }
  return c;
}

}  // namespace plumbline
