// How much of space belongs to each node whose shape lists the nodes that points reach.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "kernel/shapes/listed_shape.hpp"

namespace plumbline {

// Points throughout a grid, line by line along x: two Gauss points on each half of a cell in each direction; on rings on each
// quarter, since there the kinks of domains of half a cell, at quarters, do not cancel about the axis.
template <int dim>
class Probes {
 public:
  explicit Probes(const Grid<dim>& grid)
      : grid_(grid),
        per_cell_(grid.axisymmetric() ? 8 : 4),
        columns_(grid.cells(0) * per_cell_) {
    columns_.add(column::position, dim);
    columns_.add(column::half_size, dim);
    for (int d = 0; d < dim; ++d) std::fill_n(columns_(column::half_size, d), columns_.points(), 0.25 * grid.h());
  }

  int lines() const {
    int count = 1;
    for (int d = 1; d < dim; ++d) count *= grid_.cells(d) * per_cell_;
    return count;
  }
  const Columns& line(int number) {
    for (int d = 0, rest = number; d < dim; ++d) {
      double* x = columns_(column::position, d);
      for (int p = 0; d == 0 && p < columns_.points(); ++p) x[p] = place(p, d);
      if (d == 0) continue;
      std::fill_n(x, columns_.points(), place(rest % (grid_.cells(d) * per_cell_), d));
      rest /= grid_.cells(d) * per_cell_;
    }
    return columns_;
  }
  // Of space that belongs to a probe, m^dim; axisymmetric per radian, m^3.
  double volume(int p) const {
    return std::pow(grid_.h() / per_cell_, dim) *
           (grid_.axisymmetric() ? std::abs(columns_(column::position)[p]) : 1.0);
  }

 private:
  double place(int k, int d) const {
    const double piece = 2.0 / per_cell_, off = (k % 2 == 0 ? -0.5 : 0.5) / std::sqrt(3.0);
    return grid_.origin(d) + grid_.h() * piece * (k / 2 + 0.5 + off);
  }
  Grid<dim> grid_;
  int per_cell_;  // points along each direction
  Columns columns_;
};

// A grid with some cells more at its open sides, where no point stands but where its nodes' shapes do not end.
template <int dim>
class Surroundings {
 public:
  Surroundings(const GridSpec& grid, int beyond) : own_(grid), spec_(grid) {
    for (std::size_t d = 0; d < dim; ++d) {
      shift_[d] = grid.walls[d][0] == Wall::free ? beyond : 0;
      spec_.cells[d] += shift_[d] + (grid.walls[d][1] == Wall::free ? beyond : 0);
      spec_.origin[d] -= shift_[d] * grid.h;
    }
  }
  Grid<dim> grid() const { return Grid<dim>(spec_); }

  // The node of the own grid, of a ghost beyond a wall its mirror; -1 if there is none.
  int own_node(const Grid<dim>& all, int node) const {
    constexpr int ghosts = Grid<dim>::ghosts;
    int own = 0;
    for (int d = 0; d < dim; ++d) {
      const int last = own_.nodes(d) - 1;
      int index = all.index(node, d) - shift_[static_cast<std::size_t>(d)];
      if (index < ghosts && own_.wall(d, 0) != Wall::free) index = 2 * ghosts - index;
      if (index > last - ghosts && own_.wall(d, 1) != Wall::free) index = 2 * (last - ghosts) - index;
      if (index < 0 || index > last) return -1;
      own += index * own_.stride(d);
    }
    return own;
  }

 private:
  Grid<dim> own_;
  GridSpec spec_;
  std::array<int, 3> shift_{};  // cells
};

// 1 / |cell_i| for each node of the flat arrays, m^-dim; axisymmetric per radian, m^-3. Zero where no space is. |cell_i| is the
// integral of N_i over the space between walls and beyond open sides, the ghosts' share at their mirrors. [EC-APIC 2]
template <int dim>
std::vector<double> inverse_listed_volumes(const GridSpec& spec, MakeListed<dim> make) {
  const Surroundings<dim> around(spec, make(Grid<dim>(spec))->traits().support);
  const Grid<dim> all = around.grid();
  const auto shape = make(all);
  std::vector<double> whole(static_cast<std::size_t>(all.node_count()));
  Probes<dim> probes(all);
  NodeList<dim> nodes;
  for (int line = 0; line < probes.lines(); ++line) {
    const Columns& points = probes.line(line);
    Places<dim> at;
    for (int d = 0; d < dim; ++d) {
      at.x[d] = points(column::position, d);
      at.half_size[d] = points(column::half_size, d);
    }
    nodes.clear();
    shape->list(points, at, all_points(points), nodes);
    for (int p = 0; p < points.points(); ++p) {
      const double of_probe = probes.volume(p);
      for (const auto& [node, n, gradient] : nodes.of(p)) whole[static_cast<std::size_t>(node)] += n * of_probe;
    }
  }
  std::vector<double> volume(static_cast<std::size_t>(Grid<dim>(spec).node_count()));
  for (int node = 0; node < all.node_count(); ++node) {
    if (const int own = around.own_node(all, node); own >= 0)
      volume[static_cast<std::size_t>(own)] += whole[static_cast<std::size_t>(node)];
  }
  for (double& v : volume) v = v > 0 ? 1 / v : 0.0;
  return volume;
}

}  // namespace plumbline
