// A column's components side by side, as the Eigen vector or matrix of one point. Pointers are taken once per loop.
#pragma once

#include <Eigen/Core>

#include "kernel/points/columns.hpp"

namespace plumbline {

// Number: double, or const double where the points are only read.
template <class Value, class Number>
class Components {
 public:
  // `present` false: the column is not there and no point may be asked for.
  template <class ColumnsRef>
  Components(ColumnsRef& points, const ColumnId& id, bool present = true) {
    for (int k = 0; k < size; ++k) at_[k] = present ? points(id, k) : nullptr;
  }

  Value operator[](int p) const {
    Value value;
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < columns; ++j) value(i, j) = at_[i * columns + j][p];
    }
    return value;
  }
  void set(int p, const Value& value) {
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; j < columns; ++j) at_[i * columns + j][p] = value(i, j);
    }
  }

 private:
  static constexpr int rows = Value::RowsAtCompileTime, columns = Value::ColsAtCompileTime, size = rows * columns;
  Number* at_[size];
};

}  // namespace plumbline
