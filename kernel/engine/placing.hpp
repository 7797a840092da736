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

  // Sorts the points into bins, chains and surfaces excepted, and finds their weights; sorting false: they keep their order. Columns in
  // `stale` hold nothing that will be read and are not moved. Throws InadmissibleState where a point left the grid.
  void locate(Body& body, Weights<dim>& at, bool sorting, std::span<const ColumnId> stale) {
    const bool in_bins = sorting && !body.chain && !body.material->surface();
    at.release();
    find_lowest(body, lowest_);
    if (!in_bins)
      at.bins.build(lowest_);
    else if (!at.bins_hold || !at.bins.hold(lowest_))
      sort(body, at, stale);
    at.bins_hold = in_bins;
  }

  // Weights of where the points stand now, in the order they have.
  Weights<dim> here(const Body& body) const {
    Weights<dim> at;
    at.release();
    std::vector<int> lowest;
    find_lowest(body, lowest);
    at.bins.build(lowest);
    return at;
  }

 private:
  static constexpr int stretch = 4096;  // points that one thread takes at a time

  // Layers; points reach support - 1 beyond their own.
  int block_height() const { return std::max(dim == 1 ? 64 : 4, space_.shape.support); }

  static int pieces(const Body& body) { return 1 + body.points.points() / stretch; }
  static PointRange piece_of(const Body& body, int piece) {
    return {piece * stretch, std::min((piece + 1) * stretch, body.points.points())};
  }

  void find_lowest(const Body& body, std::vector<int>& lowest) const {
    lowest.resize(static_cast<std::size_t>(body.points.points()));
    std::vector<char> outside(static_cast<std::size_t>(pieces(body)));
    for_each_piece(pieces(body), space_.threads, [&](int piece) {
      outside[static_cast<std::size_t>(piece)] = !space_.loops->find_lowest(body.points, piece_of(body, piece),
                                                                            lowest.data());
    });
    if (std::find(outside.begin(), outside.end(), 1) != outside.end()) stop_outside(body);
  }

  void stop_outside(const Body& body) const {
    for (int d = 0; d < dim; ++d) {
      const double* position = body.points(column::position, d);
      for (int p = 0; p < body.points.points(); ++p) {
        const double x = space_.grid.logical(position[p], d);
        if (x >= -on_side && x <= space_.grid.cells(d) + on_side) continue;
        throw InadmissibleState("a point left the grid", body.name, body.id[static_cast<std::size_t>(p)],
                                column::position.name(), position[p]);
      }
    }
  }

  void sort(Body& body, Weights<dim>& at, std::span<const ColumnId> stale) {
    const std::span<const int> order = bin_sort_.sort(lowest_, body.id, space_.grid.node_count());
    at.bins.build(bin_sort_.node(), bin_sort_.start(), space_.grid.stride(dim - 1), block_height());
    if (std::is_sorted(order.begin(), order.end())) return;  // as they were
    body.points.reorder(order, stale, space_.threads);
    spare_.resize(order.size());
    for_each_piece(pieces(body), space_.threads, [&](int piece) {
      const PointRange range = piece_of(body, piece);
      for (int p = range.first; p < range.last; ++p) {
        const auto k = static_cast<std::size_t>(p);
        spare_[k] = body.id[static_cast<std::size_t>(order[k])];
      }
    });
    std::swap(spare_, body.id);
  }

  const Space& space_;
  BinSort bin_sort_;
  std::vector<int> lowest_, spare_;  // scratch
};

}  // namespace plumbline
