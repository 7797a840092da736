// Structure of arrays: each component of each column is one contiguous array of doubles.
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
    return data_[static_cast<std::size_t>(id.index())].data() + static_cast<std::size_t>(component) * stride();
  }
  const double* operator()(const ColumnId& id, int component = 0) const {
    return data_[static_cast<std::size_t>(id.index())].data() + static_cast<std::size_t>(component) * stride();
  }

  // All components one after another: points() * components(id) values.
  std::span<double> values(const ColumnId& id) { return data_[static_cast<std::size_t>(id.index())]; }
  std::span<const double> values(const ColumnId& id) const { return data_[static_cast<std::size_t>(id.index())]; }

  // Point k becomes what point order[k] was. `order` is a permutation of 0 ... points()-1.
  void reorder(std::span<const int> order);

  // Doubles stored per point, over all columns.
  int doubles_per_point() const;

 private:
  std::size_t stride() const { return static_cast<std::size_t>(points_); }
  int points_;
  std::vector<std::vector<double>> data_;  // by ColumnId::index()
};

}  // namespace plumbline
