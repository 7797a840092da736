// The nodes a point reaches, with weights, gradients and distances, from the point's frozen anchor and local coordinate.
#pragma once

#include "kernel/geometry.hpp"

namespace plumbline {

template <int dim, class Shape>
class Stencil {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;

  // lowest: flat index of the lowest node reached; row: nodes per row; local: coordinate per direction, in cells.
  Stencil(int lowest, int row, const double (&local)[dim], double h) : lowest_(lowest), row_(row) {
    for (int d = 0; d < dim; ++d) {
      Shape::weights(local[d], n_[d]);
      Shape::gradients(local[d], g_[d]);
      Shape::affine_weights(local[d], a_[d]);
      for (int k = 0; k < Shape::support; ++k) {
        g_[d][k] /= h;
        a_[d][k] /= h;
        r_[d][k] = (k + Shape::first - local[d]) * h;
      }
    }
  }

  // Calls visit(node, N_ip, grad N_ip, x_i - x_p, D^-1 N_ip (x_i - x_p)) for each node; what is not used is not computed.
  template <class Visit>
  [[gnu::always_inline]] inline void for_nodes(Visit&& visit) const {
    if constexpr (dim == 1) {
      for (int i = 0; i < Shape::support; ++i) {
        visit(static_cast<std::size_t>(lowest_ + i), n_[0][i], Vec(g_[0][i]), Vec(r_[0][i]), Vec(a_[0][i]));
      }
    } else {
      for (int j = 0; j < Shape::support; ++j) {
        for (int i = 0; i < Shape::support; ++i) {
          visit(static_cast<std::size_t>(lowest_ + j * row_ + i), n_[0][i] * n_[1][j],
                Vec(g_[0][i] * n_[1][j], n_[0][i] * g_[1][j]), Vec(r_[0][i], r_[1][j]),
                Vec(a_[0][i] * n_[1][j], n_[0][i] * a_[1][j]));
        }
      }
    }
  }

 private:
  static constexpr int s = Shape::support;
  int lowest_, row_;
  double n_[dim][s], g_[dim][s], a_[dim][s], r_[dim][s];
};

}  // namespace plumbline
