// The nodes beside a node, where walls mirror and bodies end.
#pragma once

#include "kernel/velocity_field.hpp"

namespace plumbline {

template <int dim>
struct Neighbour {
  int node = -1;          // -1: none that carries mass
  bool mirrored = false;  // it stands for its image behind a wall
};

// Of node i along d; side: 0 below, 1 above.
template <int dim>
Neighbour<dim> neighbour(const Grid<dim>& grid, const VelocityField<dim>& field, int i, int d, int side) {
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

}  // namespace plumbline
