// Where points stand: their lowest nodes and their inertia there.
#pragma once

#include <algorithm>

#include "kernel/engine/loops/lowest_nodes.hpp"
#include "kernel/engine/loops/shape_loops.hpp"

namespace plumbline {

template <class G, class S>
double ShapeLoops<G, S>::inertia(const Columns& points, int d, int p) const {
  const double cells = grid_.logical(points(column::position, d)[p], d);
  double half = 0;
  if constexpr (S::boxes) half = std::clamp(points(column::half_size, d)[p] / grid_.h(), S::narrowest, S::widest);
  return inertia_at(cells, half) * grid_.h() * grid_.h();
}

template <class G, class S>
Pack ShapeLoops<G, S>::pack_inertia(const Columns& points, int d, int p, int) const {
  const Pack cells = (load(points(column::position, d) + p) - grid_.origin(d)) * per_h_;
  return inertia_at(cells, box(S::boxes ? points(column::half_size, d) : nullptr, p)) * (grid_.h() * grid_.h());
}

template <class G, class S>
auto ShapeLoops<G, S>::extent(const Columns& points) const -> Extent {
  Extent grid;
  grid.per_h = per_h_;
  for (int d = 0; d < dim; ++d) {
    grid.position[d] = points(column::position, d);
    grid.origin[d] = grid_.origin(d);
    grid.cells[d] = grid_.cells(d);
    grid.ends[d] = grid_.cells(d);
    grid.stride[d] = grid_.stride(d);
  }
  return grid;
}

// The lowest node of a pack of points. inside: whether all so far stand on the grid.
template <class G, class S>
[[gnu::always_inline]] inline Pack ShapeLoops<G, S>::lowest_node(const Extent& grid, int p, int count,
                                                                 PackMask& inside) {
  Pack node = 0.0;
  for (int d = 0; d < dim; ++d) {
    const Pack x = (load(grid.position[d] + p) - grid.origin[d]) * grid.per_h;
    inside = inside && ((x >= -on_side && x <= grid.ends[d] + on_side) || !first_lanes(count));
    const Pack on_grid = min(max(x, Pack(0.0)), Pack(grid.ends[d]));
    node += (S::anchor_node(on_grid, grid.cells[d]) + (S::first + Grid<dim>::ghosts)) * grid.stride[d];
  }
  return node;
}

template <class G, class S>
bool ShapeLoops<G, S>::find_lowest(const Columns& points, PointRange range, int* lowest) const {
  const Extent grid = extent(points);
  return store_lowest_nodes(
      range, lowest, [&](int p, int count, PackMask& inside) __attribute__((always_inline)) {
        return lowest_node(grid, p, count, inside);
      });
}

}  // namespace plumbline
