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
    if (in_bins && at.bins_hold) {
      follow(body, at, stale);
    } else {
      find_lowest(body, lowest_);
      if (in_bins) sort(body, stale);
      build(lowest_, at, in_bins);
    }
    at.bins_hold = in_bins;
  }

  // Weights of where the points stand now, in the order they have.
  Weights<dim> here(const Body& body) const {
    Weights<dim> at;
    at.release();
    std::vector<int> lowest;
    find_lowest(body, lowest);
    build(lowest, at, false);
    return at;
  }

  // lowest: of each point the lowest node it reaches.
  void build(std::span<const int> lowest, Weights<dim>& at, bool in_bins) const {
    at.bins.build(lowest, space_.grid.stride(dim - 1), block_height(), in_bins);
  }

 private:
  static constexpr int stretch = 4096;  // points that one thread takes at a time

  // Layers; points reach support - 1 beyond their own.
  int block_height() const { return std::max(dim == 1 ? 64 : 4, space_.shape.support); }

  void find_lowest(const Body& body, std::vector<int>& lowest) const {
    const int points = body.points.points();
    lowest.resize(static_cast<std::size_t>(points));
    std::vector<char> outside(static_cast<std::size_t>(1 + points / stretch));
    for_each_piece(static_cast<int>(outside.size()), space_.threads, [&](int piece) {
      const PointRange range{piece * stretch, std::min((piece + 1) * stretch, points)};
      outside[static_cast<std::size_t>(piece)] = !space_.loops->find_lowest(body.points, range, lowest.data());
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

  // From any order.
  void sort(Body& body, std::span<const ColumnId> stale) {
    const std::span<const int> order = bin_sort_.sort(lowest_, body.id, space_.grid.node_count());
    find_runs(order, runs_);
    reorder(body, runs_, stale);
    take(runs_, lowest_);
  }

  // From the order of the bins: only points that have come to another bin are looked at.
  void follow(Body& body, Weights<dim>& at, std::span<const ColumnId> stale) {
    const int chunks = at.bins.chunk_count();
    movers_of_.resize(std::max(movers_of_.size(), static_cast<std::size_t>(chunks)));
    std::vector<char> outside(static_cast<std::size_t>(chunks));
    for_each_piece(chunks, space_.threads, [&](int k) {
      const auto c = static_cast<std::size_t>(k);
      movers_of_[c].clear();
      outside[c] = !space_.loops->find_movers(body.points, at.bins, at.bins.chunks()[c], movers_of_[c]);
    });
    if (std::find(outside.begin(), outside.end(), 1) != outside.end()) stop_outside(body);
    movers_.clear();
    for (std::size_t c = 0; c < outside.size(); ++c) {
      movers_.insert(movers_.end(), movers_of_[c].begin(), movers_of_[c].end());
    }
    if (movers_.empty()) return;
    bin_sort_.sort_again(at.bins, movers_, body.id, space_.grid.node_count());
    reorder(body, bin_sort_.runs(), stale);
    at.bins.build(bin_sort_.node(), bin_sort_.start(), space_.grid.stride(dim - 1), block_height());
  }

  void reorder(Body& body, std::span<const PointRun> runs, std::span<const ColumnId> stale) {
    if (runs.size() < 3 && runs.front().from <= 0) return;  // as they were
    body.points.reorder(runs, stale, space_.threads);
    take(runs, body.id);
  }
  void take(std::span<const PointRun> runs, std::vector<int>& values) {
    spare_.resize(values.size());
    copy_runs(runs, values.data(), spare_.data(), static_cast<int>(values.size()));
    std::swap(spare_, values);
  }

  const Space& space_;
  BinSort bin_sort_;
  std::vector<std::vector<Mover>> movers_of_;  // of each chunk; scratch, as are the others
  std::vector<Mover> movers_;
  std::vector<PointRun> runs_;
  std::vector<int> lowest_, spare_;
};

}  // namespace plumbline
