// The nodes beside a node, where walls mirror and bodies end.
#pragma once

#include <algorithm>

#include "kernel/velocity_field.hpp"

namespace plumbline {

struct Neighbour {
  int node = -1;          // -1: none that carries mass
  bool mirrored = false;  // it stands for its image behind a wall
};

// Of node i along d; side: 0 below, 1 above.
template <int dim>
Neighbour neighbour(const Grid<dim>& grid, const VelocityField<dim>& field, int i, int d, int side) {
  const int k = grid.index(i, d), step = side == 0 ? -1 : 1;
  const int wall = side == 0 ? Grid<dim>::ghosts : grid.nodes(d) - 1 - Grid<dim>::ghosts;
  const bool mirrored = k == wall && grid.wall(d, side) != Wall::free;
  const int there = k + (mirrored ? -step : step);
  if (there < 0 || there >= grid.nodes(d)) return {};
  const int node = i + (there - k) * grid.stride(d), row = node / grid.row_length();
  const int column = node - row * grid.row_length();
  const auto [first, last] = field.touched[static_cast<std::size_t>(row)];
  if (column < first || column >= last || !(field.mass[static_cast<std::size_t>(node)] > least_mass)) return {};
  return {node, mirrored};
}

// The same of the nodes of one row, most of which are plain: all their neighbours are touched and, like they, off the walls.
template <int dim>
class RowNeighbours {
 public:
  RowNeighbours(const Grid<dim>& grid, const VelocityField<dim>& field, int row) : grid_(grid), field_(field) {
    const auto walled = [&](int d, int side) { return grid.wall(d, side) != Wall::free; };
    const auto least = [&](int d) { return walled(d, 0) ? Grid<dim>::ghosts + 2 : 1; };
    const auto most = [&](int d) { return grid.nodes(d) - (walled(d, 1) ? Grid<dim>::ghosts + 3 : 2); };
    auto [from, to] = field.touched[static_cast<std::size_t>(row)];
    from = std::max(from + 1, least(0));
    to = std::min(to - 1, most(0) + 1);
    if constexpr (dim > 1) {
      for (int d = 1; d < dim; ++d) {
        const int k = grid.row_index(row, d), step = grid.stride(d) / grid.row_length();
        if (k < least(d) || k > most(d)) return;
        for (const int beside : {row - step, row + step}) {
          from = std::max(from, field.touched[static_cast<std::size_t>(beside)].first);
          to = std::min(to, field.touched[static_cast<std::size_t>(beside)].second);
        }
      }
    }
    first_ = row * grid.row_length() + from;
    last_ = row * grid.row_length() + to;
  }

  bool plain(int i) const { return i >= first_ && i < last_; }
  // The first and one past the last of them; none: the first is not less.
  std::pair<int, int> plain_nodes() const { return {first_, last_}; }

  // Of node i of the row, as neighbour().
  Neighbour operator()(int i, int d, int side) const {
    if (!plain(i)) return neighbour(grid_, field_, i, d, side);
    const int node = side == 0 ? i - grid_.stride(d) : i + grid_.stride(d);
    return field_.mass[static_cast<std::size_t>(node)] > least_mass ? Neighbour{node, false} : Neighbour{};
  }

 private:
  const Grid<dim>& grid_;
  const VelocityField<dim>& field_;
  int first_ = 0, last_ = 0;  // the plain nodes; none: equal
};

// visit(i, beside) for each touched node, with the neighbours of its row; visits of different rows may run side by side.
template <int dim, class Visit>
void for_touched_beside(const Grid<dim>& grid, const VelocityField<dim>& field, int threads, Visit&& visit) {
  for_each_piece(grid.rows(), threads, [&](int row) {
    const RowNeighbours<dim> beside(grid, field, row);
    field.for_touched_in(grid, row, [&](std::size_t i) { visit(static_cast<int>(i), beside); });
  });
}

}  // namespace plumbline
