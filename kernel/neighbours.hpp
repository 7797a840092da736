// The nodes beside a node, where walls mirror and bodies end.
#pragma once

#include <algorithm>
#include <array>

#include "kernel/velocity_field.hpp"

namespace plumbline {

struct Neighbour {
  int node = -1;          // -1: none that carries mass
  bool mirrored = false;  // it stands for its image behind a wall
};

// Of the node at `column` of a row along d, `index` its index there; side: 0 below, 1 above. Divisions take longer than all
// else here: the caller has row and index.
template <int dim>
Neighbour neighbour(const Grid<dim>& grid, const VelocityField<dim>& field, int row, int column, int index, int d,
                    int side) {
  const int outwards = side == 0 ? -1 : 1;
  const int wall = side == 0 ? Grid<dim>::ghosts : grid.nodes(d) - 1 - Grid<dim>::ghosts;
  const bool mirrored = index == wall && grid.wall(d, side) != Wall::free;
  const int step = mirrored ? -outwards : outwards;
  if (index + step < 0 || index + step >= grid.nodes(d)) return {};
  if (dim == 1 || d == 0) {
    column += step;
  } else if constexpr (dim > 1) {
    row += d == 1 ? step : step * grid.nodes(1);
  }
  const auto [first, last] = field.touched[static_cast<std::size_t>(row)];
  const int node = row * grid.row_length() + column;
  if (column < first || column >= last || !(field.mass[static_cast<std::size_t>(node)] > least_mass)) return {};
  return {node, mirrored};
}

// Of node i.
template <int dim>
Neighbour neighbour(const Grid<dim>& grid, const VelocityField<dim>& field, int i, int d, int side) {
  const int row = i / grid.row_length();
  return neighbour(grid, field, row, i - row * grid.row_length(), grid.index(i, d), d, side);
}

// The same of the nodes of one row, most of which are plain: all their neighbours are touched and, like they, off the walls.
template <int dim>
class RowNeighbours {
 public:
  RowNeighbours(const Grid<dim>& grid, const VelocityField<dim>& field, int row)
      : grid_(grid),
        field_(field),
        row_(row) {
    for (int d = 1; d < dim; ++d) index_[static_cast<std::size_t>(d)] = grid.row_index(row, d);
    const auto walled = [&](int d, int side) { return grid.wall(d, side) != Wall::free; };
    const auto least = [&](int d) { return walled(d, 0) ? Grid<dim>::ghosts + 2 : 1; };
    const auto most = [&](int d) { return grid.nodes(d) - (walled(d, 1) ? Grid<dim>::ghosts + 3 : 2); };
    auto [from, to] = field.touched[static_cast<std::size_t>(row)];
    from = std::max(from + 1, least(0));
    to = std::min(to - 1, most(0) + 1);
    if constexpr (dim > 1) {
      for (int d = 1; d < dim; ++d) {
        const int step = d == 1 ? 1 : grid.nodes(1);
        const int k = index_[static_cast<std::size_t>(d)];
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

  // Index along d of node i of the row.
  int index(int i, int d) const {
    return dim == 1 || d == 0 ? i - row_ * grid_.row_length() : index_[static_cast<std::size_t>(d)];
  }

  // Of node i of the row, as neighbour().
  Neighbour operator()(int i, int d, int side) const {
    if (!plain(i)) return neighbour(grid_, field_, row_, index(i, 0), index(i, d), d, side);
    const int node = side == 0 ? i - grid_.stride(d) : i + grid_.stride(d);
    return field_.mass[static_cast<std::size_t>(node)] > least_mass ? Neighbour{node, false} : Neighbour{};
  }

 private:
  const Grid<dim>& grid_;
  const VelocityField<dim>& field_;
  int row_;
  std::array<int, 3> index_{};  // from the second direction on
  int first_ = 0, last_ = 0;    // the plain nodes; none: equal
};

// visit(i, beside) for each touched node, with the neighbours of its row; visits of different rows may run side by side.
template <int dim, class Visit>
void for_touched_beside(const Grid<dim>& grid, const VelocityField<dim>& field, int threads, Visit&& visit) {
  for_each_piece(grid.rows(), threads, [&](int row) {
    const RowNeighbours<dim> beside(grid, field, row);
    field.for_touched_in(grid, row, [&](std::size_t i) { visit(static_cast<int>(i), beside); });
  });
}

// Beside a node along an axis: the node to read there, 1 where it carries mass (else 0, and it may be the node itself), and the
// sign of what is odd in a wall, -1 for an image.
struct Side {
  int node;
  double share;
  double sign;
};

// 1 where a node carries mass, else 0.
inline double carries(double mass) { return mass > least_mass ? 1.0 : 0.0; }

// dividend / divisor; of no divisor, which is not negative, zero. Branches would keep compilers from packing a loop.
inline double ratio(double dividend, double divisor) { return dividend / std::max(divisor, 1e-300); }

// visit(i, d, side below, side above) for each touched node and axis, the axes of a node in their order; visits of different
// rows may run side by side. Of the plain nodes in loops that compilers pack if visit is inlined and has no branches.
template <int dim, class Visit>
void for_sides(const Grid<dim>& grid, const VelocityField<dim>& field, int threads, Visit&& visit) {
  const double* const mass = field.mass.data();
  for_each_piece(grid.rows(), threads, [&](int row) {
    const RowNeighbours<dim> beside(grid, field, row);
    field.for_touched_in(grid, row, [&](std::size_t at) {
      const int i = static_cast<int>(at);
      if (beside.plain(i)) return;
      for (int d = 0; d < dim; ++d) {
        const auto side = [&](int which) {
          const Neighbour there = beside(i, d, which);
          return Side{there.node < 0 ? i : there.node, there.node < 0 ? 0.0 : 1.0, there.mirrored ? -1.0 : 1.0};
        };
        visit(i, d, side(0), side(1));
      }
    });
    const auto [first, last] = beside.plain_nodes();
    for (int i = first; i < last; ++i) {
      for (int d = 0; d < dim; ++d) {
        const int below = i - grid.stride(d), above = i + grid.stride(d);
        visit(i, d, Side{below, carries(mass[below]), 1.0}, Side{above, carries(mass[above]), 1.0});
      }
    }
  });
}

}  // namespace plumbline
