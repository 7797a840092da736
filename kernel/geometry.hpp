// A geometry is an adjoint pair: `strain` turns a velocity gradient into strain rates, `force` turns stresses into the
// nodal force of one point, and for every stress s, nodal velocity v and shape gradient g
//   s . strain(v g^T) = v . force(s, g).
// Components: normal strains, then engineering shears (twice the tensor's), so that a plain dot product is a power.
#pragma once

#include <Eigen/Core>

namespace plumbline {

// 1-D: xx.
struct Line {
  static constexpr int dim = 1, normals = 1, shears = 0, strains = 1;
  using Vec = Eigen::Matrix<double, 1, 1>;
  using Mat = Eigen::Matrix<double, 1, 1>;
  using Strain = Eigen::Matrix<double, 1, 1>;
  static Strain strain(const Mat& gradient) { return gradient; }
  static Vec force(const Strain& stress, const Vec& shape_gradient) { return stress * shape_gradient[0]; }
};

// Plane 2-D, no strain out of the plane: xx, yy, 2 xy. [York 3.23]
struct Plane {
  static constexpr int dim = 2, normals = 2, shears = 1, strains = 3;
  using Vec = Eigen::Matrix<double, 2, 1>;
  using Mat = Eigen::Matrix<double, 2, 2>;
  using Strain = Eigen::Matrix<double, 3, 1>;
  static Strain strain(const Mat& l) { return {l(0, 0), l(1, 1), l(0, 1) + l(1, 0)}; }
  static Vec force(const Strain& s, const Vec& g) { return {s[0] * g[0] + s[2] * g[1], s[2] * g[0] + s[1] * g[1]}; }
};

// Torque density of two plane vectors, z component; zero on a line.
template <int dim>
double cross(const Eigen::Matrix<double, dim, 1>& a, const Eigen::Matrix<double, dim, 1>& b) {
  if constexpr (dim == 2) {
    return a[0] * b[1] - a[1] * b[0];
  } else {
    return 0.0;
  }
}

}  // namespace plumbline
