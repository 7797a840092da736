// How fast a flow closes beyond what is linear in it, on the nodes: what a limited artificial viscosity acts on.
//   K_i = sum_d (1 - psi_d) max(0, -g_d),  g_d = (u_d(i+1) - u_d(i-1)) / 2h,
//   psi_d = max(0, min(1, (r+ + r-) / 2, 2 r+, 2 r-)),  r+- = g_d(i +- 1) / g_d(i), i +- 1 the neighbours along d,
// zero where the flow is linear (van Leer's limiter, 1977, doi 10.1016/0021-9991(77)90095-X). Behind a wall stand mirror
// images; where a neighbour has no mass nothing is known to be linear. [Limiter 1]
#pragma once

#include <algorithm>
#include <vector>

#include "kernel/neighbours.hpp"

namespace plumbline {

template <int dim>
class Limiter {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  explicit Limiter(const Grid<dim>& grid) : grid_(grid) {}

  // closing = K of the velocity u, on the touched nodes with mass, ghosts of walls excepted; slopes: scratch, of the nodes.
  void apply(const VelocityField<dim>& field, const std::vector<Vec>& u, std::vector<Vec>& slopes,
             std::vector<double>& closing, int threads) const {
    for_touched_beside(grid_, field, threads,
                       [&](int i, const Beside& beside) { slopes[static_cast<std::size_t>(i)] = slope(beside, u, i); });
    for_touched_beside(grid_, field, threads, [&](int i, const Beside& beside) {
      double& all = closing[static_cast<std::size_t>(i)] = 0;
      for (int d = 0; d < dim; ++d) {
        const double g = slopes[static_cast<std::size_t>(i)][d];
        if (g < 0) all -= (1 - linear_share(beside, slopes, i, d)) * g;
      }
    });
  }

 private:
  using Beside = RowNeighbours<dim>;

  // g of each direction; from one side where the other has no neighbour.
  Vec slope(const Beside& beside, const std::vector<Vec>& u, int i) const {
    Vec g = Vec::Zero();
    for (int d = 0; d < dim; ++d) {
      int sides = 0;
      for (int side = 0; side < 2; ++side) {
        const Neighbour there = beside(i, d, side);
        if (there.node < 0) continue;
        const double value = u[static_cast<std::size_t>(there.node)][d];  // odd in a wall
        const double change = (there.mirrored ? -value : value) - u[static_cast<std::size_t>(i)][d];
        g[d] += (side == 0 ? -change : change) / grid_.h();
        ++sides;
      }
      if (sides > 1) g[d] /= 2;
    }
    return g;
  }

  // psi of direction d, whose slope is not zero.
  double linear_share(const Beside& beside, const std::vector<Vec>& slopes, int i, int d) const {
    double least = 1, mean = 0;
    for (int side = 0; side < 2; ++side) {
      const Neighbour there = beside(i, d, side);
      if (there.node < 0) return 0;
      const double r = slopes[static_cast<std::size_t>(there.node)][d] / slopes[static_cast<std::size_t>(i)][d];
      least = std::min(least, 2 * r);
      mean += r / 2;
    }
    return std::max(0.0, std::min(least, mean));
  }

  Grid<dim> grid_;
};

}  // namespace plumbline
