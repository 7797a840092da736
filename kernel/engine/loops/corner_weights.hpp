// The weights of a point whose parallelogram carries tents at its four corners, and sums over the nodes that these reach. All
// corners are worked on side by side: a nodal field is first interpolated at each, then taken from there. [CPDI 2] [CPDI 3]
#pragma once

#include <Eigen/Core>

#include "kernel/shapes/cpdi.hpp"

namespace plumbline {

// A number for each corner, in the order of Domains<2>::sign().
using Corners [[gnu::vector_size(4 * sizeof(double))]] = double;
using CornerIndices [[gnu::vector_size(4 * sizeof(int))]] = int;

[[gnu::always_inline]] inline double sum(const Corners& of) { return (of[0] + of[1]) + (of[2] + of[3]); }

// Nodes whose lowest indices are these, ghosts counted: corners in the cells from `first` to `last` along x and y.
struct CellRange {
  int first[2], last[2];
};

class CornerWeights {
 public:
  using Vec = Eigen::Vector2d;
  using Matrix = Eigen::Matrix2d;

  // x: in cells from the first node lines; edges: in cells, as squeezed there. Corners count to the nearest of `cells`.
  [[gnu::always_inline]] inline CornerWeights(const Vec& x, const Matrix& edges, const CellRange& cells, int row_length,
                                              double h)
      : h_(h),
        row_(row_length),
        edges_(edges * h) {
    CornerIndices index[2];
    for (int d = 0; d < 2; ++d) {
      const Corners at = x[d] + 1 + first_sign * edges(d, 0) + second_sign * edges(d, 1);  // from the ghost nodes
      index[d] = __builtin_convertvector(at, CornerIndices);
      index[d] = index[d] < cells.first[d] ? CornerIndices{} + cells.first[d] : index[d];
      index[d] = index[d] > cells.last[d] ? CornerIndices{} + cells.last[d] : index[d];
      above_[d] = at - __builtin_convertvector(index[d], Corners);
    }
    node_ = index[0] + index[1] * row_;
    lowest_[0] = least(index[0]);
    lowest_[1] = least(index[1]);
  }

  int lowest(int d) const { return lowest_[d]; }

  // D_p = sum N (x_i - x_p) (x_i - x_p)^T, m^2: of the tents within their cells, and of the corners. [CPDI 4]
  [[gnu::always_inline]] inline Matrix inertia() const {
    Matrix d = edges_ * edges_.transpose();
    for (int k = 0; k < 2; ++k) d(k, k) += h_ * h_ / 4 * sum(above_[k] * (1 - above_[k]));
    return d;
  }
  // The dual vectors r^k of the edges, 1/m, row by row.
  [[gnu::always_inline]] inline Matrix duals() const {
    const double area = edges_(0, 0) * edges_(1, 1) - edges_(0, 1) * edges_(1, 0);
    Matrix inverse;
    inverse << edges_(1, 1), -edges_(0, 1), -edges_(1, 0), edges_(0, 0);
    return inverse / area;
  }

  // What a nodal field of vectors is at the point: sum N f, sum f grad N^T.
  struct Jet {
    Vec value;
    Matrix gradient;
  };
  // And sum N f (x_i - x_p)^T, and sum N |f|^2 - |sum N f|^2 as a sum of squares.
  struct Moments {
    Vec value;
    Matrix moment;
    double spread;
  };

  [[gnu::always_inline]] inline Vec value(const double* nodes) const {
    const At all = at(nodes);
    Vec mean;
    for (int d = 0; d < 2; ++d) mean[d] = sum(interpolated(all, d)) / 4;
    return mean;
  }
  [[gnu::always_inline]] inline Jet jet(const double* nodes) const {
    const At all = at(nodes);
    Jet found;
    Matrix across;
    for (int d = 0; d < 2; ++d) {
      const Corners u = interpolated(all, d);
      found.value[d] = sum(u) / 4;
      across(d, 0) = sum(first_sign * u) / 4;
      across(d, 1) = sum(second_sign * u) / 4;
    }
    found.gradient = across * duals();
    return found;
  }
  [[gnu::always_inline]] inline Moments moments(const double* nodes) const {
    const At all = at(nodes);
    Moments found;
    Matrix across;
    Corners square = {};
    const Corners variance[2] = {above_[0] * (1 - above_[0]), above_[1] * (1 - above_[1])};
    for (int d = 0; d < 2; ++d) {
      const Corners below_x = all[0][1][d] - all[0][0][d], above_x = all[1][1][d] - all[1][0][d];
      const Corners below = all[0][0][d] + above_[0] * below_x, along = all[1][0][d] + above_[0] * above_x - below;
      const Corners u = below + above_[1] * along;
      found.value[d] = sum(u) / 4;
      across(d, 0) = sum(first_sign * u) / 4;
      across(d, 1) = sum(second_sign * u) / 4;
      found.moment(d, 0) = h_ / 4 * sum(variance[0] * (below_x + above_[1] * (above_x - below_x)));
      found.moment(d, 1) = h_ / 4 * sum(variance[1] * along);
      const Corners off = u - found.value[d];
      square += off * off + variance[1] * along * along +
                variance[0] * ((1 - above_[1]) * below_x * below_x + above_[1] * above_x * above_x);
    }
    found.moment += across * edges_.transpose();
    found.spread = sum(square) / 4;
    return found;
  }

  // Adds m N to masses and m N (v + C (x_i - x_p)) to momenta. [York 3.15, 3.16] [EC-APIC 1]
  template <bool with_mass>
  [[gnu::always_inline]] inline void spread_motion(double m, const Vec& v, const Matrix& c, double* masses,
                                                   double* momenta) const {
    const Vec step[2] = {h_ * c.col(0), h_ * c.col(1)};
    const Matrix turned = c * edges_;
    for (int k = 0; k < 4; ++k) {
      const double x = above_[0][k], y = above_[1][k], share = m / 4;
      const Vec here = v + sign(k, 0) * turned.col(0) + sign(k, 1) * turned.col(1) - x * step[0] - y * step[1];
      const double w[2][2] = {{share * (1 - x) * (1 - y), share * x * (1 - y)}, {share * (1 - x) * y, share * x * y}};
      for (int b = 0; b < 2; ++b) {
        for (int a = 0; a < 2; ++a) {
          const int i = node_[k] + a + b * row_;
          if constexpr (with_mass) masses[i] += w[b][a];
          add(momenta + 2 * i, w[b][a] * (here + a * step[0] + b * step[1]));
        }
      }
    }
  }
  // Adds N base + flux grad N.
  [[gnu::always_inline]] inline void spread_force(const Vec& base, const Matrix& flux, double* forces) const {
    const Matrix across = flux * duals().transpose() / 4;
    for (int k = 0; k < 4; ++k) {
      const double x = above_[0][k], y = above_[1][k];
      const Vec force = base / 4 + sign(k, 0) * across.col(0) + sign(k, 1) * across.col(1);
      const double w[2][2] = {{(1 - x) * (1 - y), x * (1 - y)}, {(1 - x) * y, x * y}};
      for (int b = 0; b < 2; ++b) {
        for (int a = 0; a < 2; ++a) add(forces + 2 * (node_[k] + a + b * row_), w[b][a] * force);
      }
    }
  }

 private:
  static constexpr Corners first_sign = {-1, 1, -1, 1}, second_sign = {-1, -1, 1, 1};
  // Of both rows and both columns of the nodes of each corner's cell: component d of the field.
  struct At {
    Corners of[2][2][2];
    const Corners (&operator[](int row) const)[2][2] { return of[row]; }
  };

  static double sign(int corner, int edge) { return Domains<2>::sign(corner, edge); }
  [[gnu::always_inline]] static inline int least(const CornerIndices& of) {
    return std::min(std::min(of[0], of[1]), std::min(of[2], of[3]));
  }
  [[gnu::always_inline]] static inline void add(double* node, const Vec& value) {
    Eigen::Map<Vec> at(node);
    at += value;
  }
  // Both nodes of a row stand one behind the other: one read for each corner, then turned.
  [[gnu::always_inline]] inline At at(const double* nodes) const {
    At all;
    for (int row = 0; row < 2; ++row) {
      Corners read[4];
      for (int k = 0; k < 4; ++k) __builtin_memcpy(&read[k], nodes + 2 * (node_[k] + row * row_), sizeof(Corners));
      const Corners x01 = __builtin_shufflevector(read[0], read[1], 0, 4, 2, 6);
      const Corners y01 = __builtin_shufflevector(read[0], read[1], 1, 5, 3, 7);
      const Corners x23 = __builtin_shufflevector(read[2], read[3], 0, 4, 2, 6);
      const Corners y23 = __builtin_shufflevector(read[2], read[3], 1, 5, 3, 7);
      all.of[row][0][0] = __builtin_shufflevector(x01, x23, 0, 1, 4, 5);
      all.of[row][1][0] = __builtin_shufflevector(x01, x23, 2, 3, 6, 7);
      all.of[row][0][1] = __builtin_shufflevector(y01, y23, 0, 1, 4, 5);
      all.of[row][1][1] = __builtin_shufflevector(y01, y23, 2, 3, 6, 7);
    }
    return all;
  }
  [[gnu::always_inline]] inline Corners interpolated(const At& all, int d) const {
    const Corners below = all[0][0][d] + above_[0] * (all[0][1][d] - all[0][0][d]);
    const Corners above = all[1][0][d] + above_[0] * (all[1][1][d] - all[1][0][d]);
    return below + above_[1] * (above - below);
  }

  double h_;
  int row_, lowest_[2];
  Matrix edges_;        // m, a column for each
  CornerIndices node_;  // the lowest of each corner's cell, in the flat arrays
  Corners above_[2];    // how far above it the corner stands along each axis, cells
};

}  // namespace plumbline
