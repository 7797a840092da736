// Densities that two maps have smoothed, from points to nodes and back, sharpened before points read them off: twice
//   rho_i <- rho_i - sum_d (F_d(i + 1/2) - F_d(i - 1/2)),  F = s max(0, min(theta |d|, s d-, s d+)),
// d the difference across the face, s its sign, d- and d+ those across the faces beside it: what a map smooths to leading
// order, limited so that no axis makes an extremum (Boris, Book 1973, doi 10.1016/0021-9991(73)90147-2). Where the axes together
// would take more than a node has, all it gives is scaled. Behind a wall stand mirror images, beyond a body nothing. Forces of
// a gas do not see it: they take V_p p_p = (gamma - 1) m_p e_p. [Read-off 1]
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/neighbours.hpp"

namespace plumbline {

template <int dim>
class ReadOff {
 public:
  // theta: of the shape, see Sharpening; 0: densities stay as they are.
  ReadOff(const Grid<dim>& grid, double theta) : grid_(grid), theta_(theta) {}

  // Of the touched nodes, ghosts of walls excepted.
  void apply(const VelocityField<dim>& field, std::vector<double>& density, int threads) {
    if (theta_ == 0) return;
    share_.resize(density.size());
    for (int pass = 0; pass < 2; ++pass) {
      before_ = density;
      field.for_touched(
          grid_, [&](std::size_t i) { share_[i] = share_given(field, static_cast<int>(i)); }, threads);
      field.for_touched(
          grid_,
          [&](std::size_t i) {
            if (!(field.mass[i] > least_mass)) return;
            for (int d = 0; d < dim; ++d) {
              for (int side = 0; side < 2; ++side) {
                const auto [to, outward] = flux(field, static_cast<int>(i), d, side);
                if (to >= 0) density[i] -= outward * share_[outward > 0 ? i : static_cast<std::size_t>(to)];
              }
            }
          },
          threads);
    }
  }

 private:
  struct Flux {
    int to;  // the node on the other side; -1: nothing stands there that could take or give
    double outward;
  };

  double beside(const VelocityField<dim>& field, int i, int d, int side) const {
    const Neighbour<dim> there = neighbour(grid_, field, i, d, side);
    return there.node < 0 ? 0.0 : before_[static_cast<std::size_t>(there.node)];
  }

  // F through the face on one side of node i, away from it.
  Flux flux(const VelocityField<dim>& field, int i, int d, int side) const {
    const Neighbour<dim> there = neighbour(grid_, field, i, d, side);
    if (there.node < 0) return {-1, 0};
    const double own = before_[static_cast<std::size_t>(i)], other = before_[static_cast<std::size_t>(there.node)];
    const double beyond = beside(field, there.node, d, there.mirrored ? 1 - side : side);
    const double change = other - own, sign = change < 0 ? -1 : 1;
    const double behind = own - beside(field, i, d, 1 - side), ahead = beyond - other;
    return {there.node, sign * std::max(0.0, std::min({theta_ * std::abs(change), sign * behind, sign * ahead}))};
  }

  // The share of what would leave node i that it has.
  double share_given(const VelocityField<dim>& field, int i) const {
    const double own = before_[static_cast<std::size_t>(i)];
    double leaves = 0;
    for (int d = 0; d < dim; ++d) {
      for (int side = 0; side < 2; ++side) leaves += std::max(0.0, flux(field, i, d, side).outward);
    }
    return leaves > own ? std::max(0.0, own / leaves) : 1.0;
  }

  Grid<dim> grid_;
  double theta_;
  std::vector<double> before_, share_;
};

}  // namespace plumbline
