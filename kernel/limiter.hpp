// What of a flow on the nodes is linear along an axis, psi, and what depends on it. How fast it closes beyond what is linear in
// it, which a limited artificial viscosity acts on:
//   K_i = sum_d (1 - psi_d) max(0, -g_d),  g_d = (u_d(i+1) - u_d(i-1)) / 2h,
//   psi_d = max(0, min(1, (r+ + r-) / 2, 2 r+, 2 r-)),  r+- = g_d(i +- 1) / g_d(i), i +- 1 the neighbours along d,
// zero where the flow is linear (van Leer's limiter, 1977, doi 10.1016/0021-9991(77)90095-X). Behind a wall stand mirror
// images; where a neighbour has no mass nothing is known to be linear. [Limiter 1]
// And how much of the sharpening stays along d where a gas expands, between all of it and the share a:
//   t_d = 1 - (1 - a) max(0, 1 - 2 (1 - x) psi_d) min(1, 32 x) where g_d > 0, elsewhere 1,
//   x = |rho(i+1) - rho(i-1)| / (rho(i+1) + rho(i-1)),                                                       [Limiter 2]
// g_d the mean of the slopes on either side by rho(j) / (rho(i) + rho(j)): the velocity of a node that carries next to nothing
// does not count. Sharpening overshoots at kinks of a velocity, and so heats gas ahead of an expansion and in its middle. Small
// waves, which change densities little, keep all of it to first order: they are sharpened as if there were no limit.
#pragma once

#include <algorithm>
#include <cmath>
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
    find_slopes(
        field, u, slopes, [](int, int) { return 1.0; }, threads);
    for_touched_beside(grid_, field, threads, [&](int i, const Beside& beside) {
      double& all = closing[static_cast<std::size_t>(i)] = 0;
      for (int d = 0; d < dim; ++d) {
        const double g = slopes[static_cast<std::size_t>(i)][d];
        if (g < 0) all -= (1 - linear_share(beside, slopes, i, d)) * g;
      }
    });
  }

  // kept = t of the velocity u, a = least; inverse_volumes: of the nodes' cells, see PointLoops; on the same nodes.
  void find_kept(const VelocityField<dim>& field, const std::vector<double>& inverse_volumes, double least,
                 const std::vector<Vec>& u, std::vector<Vec>& slopes, std::vector<Vec>& kept, int threads) const {
    const std::vector<double>& mass = field.mass_of_gas();
    const auto density = [&](int node) {
      const auto at = static_cast<std::size_t>(node);
      return mass[at] * inverse_volumes[at];
    };
    const auto share = [&](int i, int j) {
      const double own = density(i), other = density(j);
      return other > 0 ? other / (own + other) : 0.0;
    };
    find_slopes(field, u, slopes, share, threads);
    for_touched_beside(grid_, field, threads, [&](int i, const Beside& beside) {
      Vec& all = kept[static_cast<std::size_t>(i)] = Vec::Ones();
      for (int d = 0; d < dim; ++d) {
        if (!(slopes[static_cast<std::size_t>(i)][d] > 0)) continue;
        const int below = beside(i, d, 0).node, above = beside(i, d, 1).node;
        const double low = below < 0 ? 0.0 : density(below), high = above < 0 ? 0.0 : density(above);
        const double uneven = low + high > 0 ? std::abs(high - low) / (high + low) : 0.0;
        const double bent = std::max(0.0, 1 - 2 * (1 - uneven) * linear_share(beside, slopes, i, d));
        all[d] -= (1 - least) * bent * std::min(1.0, change_that_counts * uneven);
      }
    });
  }

 private:
  static constexpr double change_that_counts = 32;

  using Beside = RowNeighbours<dim>;

  // weight(i, j): of what the neighbour j says of the slope at i, not negative.
  template <class Weight>
  void find_slopes(const VelocityField<dim>& field, const std::vector<Vec>& u, std::vector<Vec>& slopes,
                   Weight&& weight, int threads) const {
    for_touched_beside(grid_, field, threads, [&](int i, const Beside& beside) {
      slopes[static_cast<std::size_t>(i)] = slope(beside, u, i, weight);
    });
  }

  // g of each direction; from one side where the other has no neighbour.
  template <class Weight>
  Vec slope(const Beside& beside, const std::vector<Vec>& u, int i, Weight&& weight) const {
    Vec g = Vec::Zero();
    for (int d = 0; d < dim; ++d) {
      double sum = 0;
      for (int side = 0; side < 2; ++side) {
        const Neighbour there = beside(i, d, side);
        if (there.node < 0) continue;
        const double value = u[static_cast<std::size_t>(there.node)][d];  // odd in a wall
        const double change = (there.mirrored ? -value : value) - u[static_cast<std::size_t>(i)][d];
        const double share = weight(i, there.node);
        g[d] += share * ((side == 0 ? -change : change) / grid_.h());
        sum += share;
      }
      if (sum > 0) g[d] /= sum;
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
