// Densities that two maps have smoothed, from points to nodes and back, sharpened before points read them off: twice
//   rho_i <- rho_i - sum_d (F_d(i + 1/2) - F_d(i - 1/2)),  F = s max(0, min(theta |d|, s d-, s d+, theta rho_least)),
// d the difference across the face, s its sign, d- and d+ those across the faces beside it: what a map smooths to leading
// order, limited so that no axis makes an extremum (Boris, Book 1973, doi 10.1016/0021-9991(73)90147-2). rho_least is the
// least of the four densities that the differences are of: within a kernel of a free edge the mapped densities are the
// kernel's, not the gas's, and theta <= 1 / (2 dim) of it leaves every node what it has. Behind a wall stand mirror images,
// beyond a body nothing. Forces of a gas do not see it: they take V_p p_p = (gamma - 1) m_p e_p. [Read-off 1]
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/neighbours.hpp"

namespace plumbline {

template <int dim>
class ReadOff {
 public:
  // theta: of the shape, see Sharpening, at most 1 / (2 dim); 0: densities stay as they are.
  ReadOff(const Grid<dim>& grid, double theta) : grid_(grid), theta_(theta) {}

  // Of the touched nodes, ghosts of walls excepted.
  void apply(const VelocityField<dim>& field, std::vector<double>& density, int threads) {
    if (theta_ == 0) return;
    for (int pass = 0; pass < 2; ++pass) {
      before_ = density;
      for_touched_beside(grid_, field, threads, [&](int i, const RowNeighbours<dim>& beside) {
        const auto at = static_cast<std::size_t>(i);
        if (!(field.mass[at] > least_mass)) return;
        for (int d = 0; d < dim; ++d) {
          const Neighbour sides[] = {beside(i, d, 0), beside(i, d, 1)};
          for (int side = 0; side < 2; ++side) density[at] -= outward_flux(field, i, d, side, sides);
        }
      });
    }
  }

 private:
  double at(int node) const { return node < 0 ? 0.0 : before_[static_cast<std::size_t>(node)]; }

  // F through the face on one side of node i, away from it; sides: its neighbours along d.
  double outward_flux(const VelocityField<dim>& field, int i, int d, int side, const Neighbour (&sides)[2]) const {
    const Neighbour there = sides[side];
    if (there.node < 0) return 0;
    const double own = at(i), other = at(there.node), before = at(sides[1 - side].node);
    const double beyond = at(neighbour(grid_, field, there.node, d, there.mirrored ? 1 - side : side).node);
    const double change = other - own, sign = change < 0 ? -1 : 1, least = std::min({before, own, other, beyond});
    return sign * std::max(0.0, std::min({theta_ * std::abs(change), sign * (own - before), sign * (beyond - other),
                                          theta_ * least}));
  }

  Grid<dim> grid_;
  double theta_;
  std::vector<double> before_;
};

}  // namespace plumbline
