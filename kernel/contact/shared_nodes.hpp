// Nodes that carry mass of two fields.
#pragma once

#include <algorithm>

#include "kernel/velocity_field.hpp"

namespace plumbline {

// A node counts where both masses exceed this part of the largest nodal mass: below it rounding of sums decides.
inline constexpr double least_shared = 1e-13;

// Two bodies' mass at a node between each other, kg; 0 where one has none. A field's masses are those of this step where it is
// touched alone.
template <int dim>
double reduced_mass(const Grid<dim>& grid, const VelocityField<dim>& a, const VelocityField<dim>& b, int node) {
  const int row = node / grid.row_length(), k = node - row * grid.row_length();
  for (const VelocityField<dim>* field : {&a, &b}) {
    const auto [first, last] = field->touched[static_cast<std::size_t>(row)];
    if (k < first || k >= last || !(field->mass[static_cast<std::size_t>(node)] > least_mass)) return 0;
  }
  const double first = a.mass[static_cast<std::size_t>(node)], second = b.mass[static_cast<std::size_t>(node)];
  return first * second / (first + second);
}

// Whether a node lies beyond a wall: it mirrors another and has no motion of its own.
template <int dim>
bool beyond_wall(const Grid<dim>& grid, int node) {
  for (int d = 0; d < dim; ++d) {
    const int index = grid.index(node, d);
    if (index < Grid<dim>::ghosts && grid.wall(d, 0) != Wall::free) return true;
    if (index >= grid.nodes(d) - Grid<dim>::ghosts && grid.wall(d, 1) != Wall::free) return true;
  }
  return false;
}

// What of a direction a node may move along: nothing into a wall that it stands on, nothing at all where that holds it.
template <int dim>
Eigen::Matrix<double, dim, 1> along_walls(const Grid<dim>& grid, int node, Eigen::Matrix<double, dim, 1> direction) {
  for (int d = 0; d < dim; ++d) {
    const int index = grid.index(node, d);
    const bool low = index == Grid<dim>::ghosts, high = index == grid.nodes(d) - 1 - Grid<dim>::ghosts;
    if (!low && !high) continue;
    const Wall wall = grid.wall(d, low ? 0 : 1);
    if (wall == Wall::no_slip) direction.setZero();
    if (wall == Wall::symmetry) direction[d] = 0;
  }
  return direction;
}

// visit(node) for each node touched by both fields, in the order of the nodes.
template <int dim, class Visit>
void for_shared_nodes(const Grid<dim>& grid, const VelocityField<dim>& a, const VelocityField<dim>& b, Visit&& visit) {
  double largest = 0;
  a.for_touched(grid, [&](std::size_t i) { largest = std::max(largest, a.mass[i]); });
  b.for_touched(grid, [&](std::size_t i) { largest = std::max(largest, b.mass[i]); });
  const double least = least_shared * largest;
  for (int row = 0; row < grid.rows(); ++row) {
    const auto [first_a, last_a] = a.touched[static_cast<std::size_t>(row)];
    const auto [first_b, last_b] = b.touched[static_cast<std::size_t>(row)];
    const int base = row * grid.row_length();
    for (int k = std::max(first_a, first_b); k < std::min(last_a, last_b); ++k) {
      const auto i = static_cast<std::size_t>(base + k);
      if (a.mass[i] > least && b.mass[i] > least && !beyond_wall(grid, base + k)) visit(base + k);
    }
  }
}

}  // namespace plumbline
