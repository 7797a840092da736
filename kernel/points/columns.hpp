// Structure of arrays: each component of each column is one contiguous array of doubles. Behind the last component a few
// zeros follow, so that a pack of points may be loaded anywhere.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "kernel/points/column_names.hpp"

namespace plumbline {

class Columns {
 public:
  explicit Columns(int points = 0) : points_(points) {}

  int points() const { return points_; }

  // Adds a column of zeros; a column that is there already keeps its values.
  void add(const ColumnId& id, int components = 1);
  bool has(const ColumnId& id) const { return components(id) > 0; }
  int components(const ColumnId& id) const;

  // One component as an array of points() values. The column must exist.
  double* operator()(const ColumnId& id, int component = 0) {
    return at(id).data() + static_cast<std::size_t>(component) * stride();
  }
  const double* operator()(const ColumnId& id, int component = 0) const {
    return at(id).data() + static_cast<std::size_t>(component) * stride();
  }

  // All components one after another: points() * components(id) values.
  std::span<double> values(const ColumnId& id) { return {at(id).data(), size(id)}; }
  std::span<const double> values(const ColumnId& id) const { return {at(id).data(), size(id)}; }

  // Point k becomes what point order[k] was. `order` is a permutation of 0 ... points()-1. Columns in `stale` hold nothing
  // that will be read and stay as they are.
  void reorder(std::span<const int> order, std::span<const ColumnId> stale = {}, int threads = 1);

  // One more point behind the others for each of `of`, with the values of that point in every column.
  void append_copies(std::span<const int> of);

  // Doubles stored per point, over all columns.
  int doubles_per_point() const;

 private:
  struct Column {
    int components = 0;
    std::vector<double> values;
  };
  std::size_t stride() const { return static_cast<std::size_t>(points_); }
  std::size_t size(const ColumnId& id) const { return stride() * static_cast<std::size_t>(components(id)); }
  std::vector<double>& at(const ColumnId& id) { return columns_[static_cast<std::size_t>(id.index())].values; }
  const std::vector<double>& at(const ColumnId& id) const {
    return columns_[static_cast<std::size_t>(id.index())].values;
  }

  static constexpr int padding = 16;  // values behind the last component
  static constexpr int piece = 8192;  // points that one thread takes at a time

  int points_;
  std::vector<Column> columns_;  // by ColumnId::index()
  // Takes the next column of so many components that is reordered: of one size for all, none is ever cleared.
  std::vector<std::vector<double>> spare_;
};

}  // namespace plumbline
