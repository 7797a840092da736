#include "kernel/engine/loops/list_loops.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "kernel/enclosed_volumes.hpp"
#include "kernel/engine/loops/list_survey.hpp"
#include "kernel/engine/loops/list_to_nodes.hpp"
#include "kernel/engine/loops/list_to_points.hpp"
#include "kernel/engine/loops/list_volumes.hpp"
#include "kernel/shapes/quadratic.hpp"

namespace plumbline {

template <class G>
ListLoops<G>::ListLoops(const GridSpec& grid, const Transfer& transfer, MakeListed<dim> make)
    : grid_(grid),
      spec_(grid),
      transfer_(transfer),
      make_(make),
      shape_(make(grid_)),
      traits_(shape_->traits()) {}

template <class G>
std::vector<double> ListLoops<G>::inverse_volumes() const {
  return inverse_listed_volumes<dim>(spec_, make_);
}

// With the nodes' quadratic splines in place of the shape; the sum over all nodes is the same.
template <class G>
void ListLoops<G>::find_enclosed_volumes(const Columns& chain, const std::vector<std::array<double, 2>>& corners,
                                         std::vector<double>& volume) const {
  if constexpr (dim == 2)
    enclosed_volumes<Quadratic>(grid_, chain, corners, volume);
  else
    throw std::logic_error("only in two dimensions does a chain of points enclose a gas");
}

// Points are listed from where they stand on the grid: one may have moved off it before anybody looks.
template <class G>
auto ListLoops<G>::reach(const Columns& points, const Places<dim>& places, PointRange range) const -> Reach {
  const auto count = static_cast<std::size_t>(range.last - range.first);
  Reach found{range, {}, {}};
  Places<dim> on_grid = places;
  for (int d = 0; d < dim; ++d) {
    std::vector<double>& x = found.x[static_cast<std::size_t>(d)];
    x.resize(count);
    const double low = grid_.origin(d), high = low + grid_.cells(d) * grid_.h();
    for (int p = range.first; p < range.last; ++p) {
      const double at = places.x[d][p];
      x[static_cast<std::size_t>(p - range.first)] = at >= low ? std::min(at, high) : low;
    }
    on_grid.x[d] = x.data() - range.first;
  }
  shape_->list(points, on_grid, range, *found.nodes);
  if ((*found.nodes).points() != static_cast<int>(count))
    throw std::logic_error("a shape lists the nodes of another number of points than it was asked for");
  return found;
}

template <class G>
auto ListLoops<G>::reach(const Columns& points, PointRange range) const -> Reach {
  Places<dim> here;
  for (int d = 0; d < dim; ++d) {
    here.x[d] = place_of_weights(points, d);
    if (traits_.boxes) here.half_size[d] = points(column::half_size, d);
  }
  return reach(points, here, range);
}

// The block starts further inside where it would leave the grid.
template <class G>
int ListLoops<G>::lowest_node(Entries entries) const {
  int lowest = 0;
  for (int d = 0; d < dim; ++d) {
    int low = grid_.nodes(d), high = -1;
    for (const auto& [node, n, gradient] : entries) {
      if (node < 0 || node >= grid_.node_count()) throw std::logic_error("a shape lists a node that the grid lacks");
      low = std::min(low, grid_.index(node, d));
      high = std::max(high, grid_.index(node, d));
    }
    if (high - low >= traits_.support) throw std::logic_error("a point reaches further than its shape's support");
    lowest += std::clamp(low, 0, grid_.nodes(d) - traits_.support) * grid_.stride(d);
  }
  return lowest;
}

template <class G>
bool ListLoops<G>::on_grid(const Columns& points, int p) const {
  for (int d = 0; d < dim; ++d) {
    const double x = grid_.logical(points(column::position, d)[p], d);
    if (!(x >= -on_side && x <= grid_.cells(d) + on_side)) return false;
  }
  return true;
}

template <class G>
bool ListLoops<G>::find_lowest(const Columns& points, PointRange range, int* lowest) const {
  const Reach here = reach(points, range);
  bool inside = true;
  for (int p = range.first; p < range.last; ++p) {
    inside = inside && on_grid(points, p);
    lowest[p] = lowest_node(here.of(p));
  }
  return inside;
}

template <class G>
double ListLoops<G>::inertia(const Columns& points, int d, int p) const {
  return inertia_of(reach(points, {p, p + 1}), p)(d, d);
}

template class ListLoops<Line>;
template class ListLoops<Plane>;
template class ListLoops<Axisymmetric>;
template class ListLoops<Solid>;

}  // namespace plumbline
