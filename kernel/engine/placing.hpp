// Where the points of a body stand on the grid, and their order: by bins.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "kernel/engine/discretisation.hpp"
#include "kernel/inadmissible.hpp"

namespace plumbline {

template <class Geometry>
class Placing {
 public:
  using Space = Discretisation<Geometry>;
  static constexpr int dim = Geometry::dim;

  explicit Placing(const Space& space) : space_(space) {}

  // Sorts the points into bins, chains excepted, and finds their weights; sorting false: they keep their order. Columns in
  // `stale` hold nothing that will be read and are not moved. Throws InadmissibleState where a point left the grid.
  void locate(Body& body, Weights<dim>& at, bool sorting, std::span<const ColumnId> stale) {
    const bool in_bins = sorting && !body.chain;
    at.release();
    find_lowest(body, at);
    if (in_bins && !in_order(body, at)) sort(body, at, stale);
    build(at, in_bins);
    at.bins_hold = in_bins;
  }

  // Weights of where the points stand now, in the order they have.
  Weights<dim> here(const Body& body) const {
    Weights<dim> at;
    at.lowest.resize(static_cast<std::size_t>(body.points.points()));
    at.release();
    find_lowest(body, at);
    build(at, false);
    return at;
  }

  void build(Weights<dim>& at, bool in_bins) const {
    at.bins.build(at.lowest, space_.grid.stride(dim - 1), block_height, in_bins);
  }

 private:
  static constexpr int block_height = dim == 1 ? 64 : 4;  // layers; a stencil reaches 3 beyond its own
  static constexpr int stretch = 4096;                    // points that one thread takes at a time

  void find_lowest(const Body& body, Weights<dim>& at) const {
    const int points = body.points.points();
    std::vector<char> outside(static_cast<std::size_t>(1 + points / stretch));
    for_each_piece(static_cast<int>(outside.size()), space_.threads, [&](int piece) {
      const PointRange range{piece * stretch, std::min((piece + 1) * stretch, points)};
      outside[static_cast<std::size_t>(piece)] = !space_.loops->find_lowest(body.points, range, at.lowest.data());
    });
    if (std::find(outside.begin(), outside.end(), 1) == outside.end()) return;
    for (int d = 0; d < dim; ++d) {
      const double* position = body.points(column::position, d);
      for (int p = 0; p < points; ++p) {
        const double x = space_.grid.logical(position[p], d);
        if (x >= -on_side && x <= space_.grid.cells(d) + on_side) continue;
        throw InadmissibleState("a point left the grid", body.name, body.id[static_cast<std::size_t>(p)],
                                column::position.name(), position[p]);
      }
    }
  }

  // By lowest node, and by number where that is the same.
  static bool in_order(const Body& body, const Weights<dim>& at) {
    for (std::size_t p = 1; p < at.lowest.size(); ++p) {
      const int step = at.lowest[p] - at.lowest[p - 1];
      if (step < 0 || (step == 0 && body.id[p] < body.id[p - 1])) return false;
    }
    return true;
  }

  void sort(Body& body, Weights<dim>& at, std::span<const ColumnId> stale) {
    const int nodes = space_.grid.node_count();
    const std::span<const int> order = at.bins_hold ? bin_sort_.sort_again(at.bins, at.lowest, body.id, nodes)
                                                    : bin_sort_.sort(at.lowest, body.id, nodes);
    body.points.reorder(order, stale, space_.threads);
    const auto reorder = [&](std::vector<int>& values) {
      spare_.resize(values.size());
      for_each_index(static_cast<int>(order.size()), space_.threads, [&](int k) {
        const auto at_k = static_cast<std::size_t>(k);
        spare_[at_k] = values[static_cast<std::size_t>(order[at_k])];
      });
      std::swap(spare_, values);
    };
    reorder(body.id);
    reorder(at.lowest);
  }

  const Space& space_;
  BinSort bin_sort_;
  std::vector<int> spare_;
};

}  // namespace plumbline
