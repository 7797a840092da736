// Tensors of packs of points, as columns of full stresses and deformations hold them: a matrix of the directions of the
// plane or space, row by row, then in an axisymmetric scene the hoop's component, which stands by itself.
#pragma once

#include "kernel/pack.hpp"
#include "kernel/points/columns.hpp"

namespace plumbline {

template <int dim, bool rings>
struct PackTensor {
  static constexpr int plane = dim * dim, size = plane + (rings ? 1 : 0);
  static_assert(!rings || dim == 2);

  Pack at[size];

  PackTensor operator*(const PackTensor& o) const {
    PackTensor product;
    for (int k = 0; k < plane; ++k) {
      const int row = k / dim * dim, column = k % dim;
      product.at[k] = at[row] * o.at[column];
      for (int i = 1; i < dim; ++i) product.at[k] += at[row + i] * o.at[i * dim + column];
    }
    if constexpr (rings) product.at[plane] = at[plane] * o.at[plane];
    return product;
  }
  PackTensor transposed() const {
    PackTensor turned = *this;
    for (int k = 0; k < plane; ++k) turned.at[k] = at[k % dim * dim + k / dim];
    return turned;
  }
  // The determinant's derivatives with respect to the components: det A A^-T.
  PackTensor cofactors() const {
    PackTensor c;
    if constexpr (dim == 1) {
      c.at[0] = 1.0;
    } else if constexpr (dim == 2) {
      const Pack hoop = rings ? at[size - 1] : Pack(1.0);
      for (int k = 0; k < plane; ++k) c.at[k] = k == 0 || k == 3 ? at[3 - k] * hoop : -at[3 - k] * hoop;
      if constexpr (rings) c.at[plane] = at[0] * at[3] - at[1] * at[2];
    } else {
      for (int k = 0; k < plane; ++k) {
        const int row[] = {(k / 3 + 1) % 3 * 3, (k / 3 + 2) % 3 * 3}, column[] = {(k + 1) % 3, (k + 2) % 3};
        c.at[k] = at[row[0] + column[0]] * at[row[1] + column[1]] - at[row[0] + column[1]] * at[row[1] + column[0]];
      }
    }
    return c;
  }
  // Along the first row.
  Pack determinant() const {
    const PackTensor c = cofactors();
    Pack sum = at[0] * c.at[0];
    for (int k = 1; k < dim; ++k) sum += at[k] * c.at[k];
    return sum;
  }
  // Of all components.
  Pack sum_of_squares() const {
    Pack sum = at[0] * at[0];
    for (int k = 1; k < size; ++k) sum += at[k] * at[k];
    return sum;
  }
};

// A column of them. Number: double, or const double where the points are only read. Pointers are taken once per loop.
template <class Tensor, class Number>
class TensorColumn {
 public:
  template <class ColumnsRef>
  TensorColumn(ColumnsRef& points, const ColumnId& id) {
    for (int k = 0; k < Tensor::size; ++k) at_[k] = points(id, k);
  }
  Tensor operator[](int p) const {
    Tensor value;
    for (int k = 0; k < Tensor::size; ++k) value.at[k] = load(at_[k] + p);
    return value;
  }
  // The first `count` points from p on.
  void set(int p, const Tensor& value, int count) const {
    for (int k = 0; k < Tensor::size; ++k) store(at_[k] + p, value.at[k], count);
  }

 private:
  Number* at_[Tensor::size];
};

}  // namespace plumbline
