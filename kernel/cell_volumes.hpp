// How much of space belongs to each node.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/grid.hpp"

namespace plumbline {

// Along direction d: integral of N_i, with the ghosts' share at their mirrors: h inside, h/2 on a wall. Along the radius of
// an axisymmetric grid the integral of N_i r, m^2: what uniform points put on the node is then exactly in proportion.
// [EC-APIC 2] Three Gauss points on quarters of a cell are exact for cubic shapes and for boxes of half a cell.
template <class Shape, int dim>
std::vector<double> line_volumes(const Grid<dim>& grid, int d) {
  constexpr int beyond = 3;  // cells that a ghost node of an open side reaches
  const bool radial = grid.axisymmetric() && d == 0;
  const bool walled[2] = {grid.wall(d, 0) != Wall::free, grid.wall(d, 1) != Wall::free};
  const double low = walled[0] ? 0 : -beyond, high = grid.cells(d) + (walled[1] ? 0 : beyond);
  std::vector<double> volume(static_cast<std::size_t>(grid.nodes(d)));
  const double abscissa = std::sqrt(0.6), weight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  const int last = grid.nodes(d) - 1, ghosts = Grid<dim>::ghosts;
  for (double start = low; start < high - 0.125; start += 0.25) {
    for (int k = 0; k < 3; ++k) {
      const double x = start + 0.125 * (1 + (k - 1) * abscissa);
      double local, n[Shape::support];
      const int anchor = Shape::anchor(x, grid.cells(d) + 2 * beyond, local);
      Shape::weights(local, n);
      const double r = radial ? std::abs(grid.origin(d) + x * grid.h()) : 1;
      for (int j = 0; j < Shape::support; ++j) {
        int node = anchor + Shape::first + j + ghosts;
        if (node < ghosts && walled[0]) node = 2 * ghosts - node;
        if (node > last - ghosts && walled[1]) node = 2 * (last - ghosts) - node;
        if (node < 0 || node > last) continue;
        volume[static_cast<std::size_t>(node)] += 0.25 * grid.h() * weight[k] * n[j] * r;
      }
    }
  }
  return volume;
}

// 1 / |cell_i| for each node of the flat arrays, m^-dim; axisymmetric per radian, m^-3. Zero where no space is.
template <class Shape, int dim>
std::vector<double> inverse_cell_volumes(const Grid<dim>& grid) {
  std::vector<double> inverse(static_cast<std::size_t>(grid.node_count()), 1.0);
  for (int d = 0; d < dim; ++d) {
    const std::vector<double> along = line_volumes<Shape>(grid, d);
    for (int i = 0; i < grid.node_count(); ++i) {
      const double v = along[static_cast<std::size_t>(grid.index(i, d))];
      inverse[static_cast<std::size_t>(i)] *= v > 0 ? 1 / v : 0.0;
    }
  }
  return inverse;
}

}  // namespace plumbline
