// The weights of a point whose parallelogram carries tents at its four corners, and sums over the nodes that these reach. All
// corners are worked on side by side: a nodal field is first interpolated at each, then taken from there. [CPDI 2] [CPDI 3]
#pragma once

#include <Eigen/Core>
#include <algorithm>

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

// Vectors and matrices of the plane as numbers by themselves: packed ones would be put together and taken apart again.
struct Two {
  double x, y;
  double square() const { return x * x + y * y; }
};
struct Square {
  double xx, xy, yx, yy;  // row by row

  Square operator*(const Square& o) const {
    return {xx * o.xx + xy * o.yx, xx * o.xy + xy * o.yy, yx * o.xx + yy * o.yx, yx * o.xy + yy * o.yy};
  }
  Square operator-(const Square& o) const { return {xx - o.xx, xy - o.xy, yx - o.yx, yy - o.yy}; }
  Square times(double factor) const { return {factor * xx, factor * xy, factor * yx, factor * yy}; }
  Square transposed() const { return {xx, yx, xy, yy}; }
  Square inverse() const {
    const double per_area = 1 / (xx * yy - xy * yx);
    return {per_area * yy, -per_area * xy, -per_area * yx, per_area * xx};
  }
  double dot(const Square& o) const { return xx * o.xx + xy * o.xy + yx * o.yx + yy * o.yy; }
};

class CornerWeights {
 public:
  // x, y: in cells from the first node lines; edges: a column each, in cells, as squeezed there. Corners count to the nearest of
  // `cells`.
  [[gnu::always_inline]] inline CornerWeights(const Two& place, const Square& edges, const CellRange& cells,
                                              int row_length, double h)
      : h_(h),
        row_(row_length),
        edges_(edges.times(h)) {
    const Corners at[2] = {(place.x + 1) + first_sign * edges.xx + second_sign * edges.xy,  // from the ghost nodes
                           (place.y + 1) + first_sign * edges.yx + second_sign * edges.yy};
    CornerIndices index[2];
    for (int d = 0; d < 2; ++d) {
      index[d] = __builtin_convertvector(at[d], CornerIndices);
      index[d] = index[d] < cells.first[d] ? CornerIndices{} + cells.first[d] : index[d];
      index[d] = index[d] > cells.last[d] ? CornerIndices{} + cells.last[d] : index[d];
      above_[d] = at[d] - __builtin_convertvector(index[d], Corners);
      lowest_[d] = least(index[d]);
    }
    node_ = index[0] + index[1] * row_;
  }

  int lowest(int d) const { return lowest_[d]; }

  // D_p = sum N (x_i - x_p) (x_i - x_p)^T, m^2: of the tents within their cells, and of the corners. [CPDI 4]
  [[gnu::always_inline]] inline Square inertia() const { return inertia(edges_, above_[0], above_[1], h_); }
  // The same of a place and edges, for which no node is wanted.
  [[gnu::always_inline]] static inline Square inertia_at(const Two& place, const Square& edges, double h) {
    const Corners x = (place.x + 1) + first_sign * edges.xx + second_sign * edges.xy;
    const Corners y = (place.y + 1) + first_sign * edges.yx + second_sign * edges.yy;
    return inertia(edges.times(h), x - __builtin_convertvector(__builtin_convertvector(x, CornerIndices), Corners),
                   y - __builtin_convertvector(__builtin_convertvector(y, CornerIndices), Corners), h);
  }
  // The dual vectors r^k of the edges, 1/m, row by row.
  [[gnu::always_inline]] inline Square duals() const { return edges_.inverse(); }

  // What a nodal field of vectors is at the point: sum N f, sum f grad N^T.
  struct Jet {
    Two value;
    Square gradient;
  };
  // And sum N f (x_i - x_p)^T, and sum N |f|^2 - |sum N f|^2 as a sum of squares.
  struct Moments {
    Two value;
    Square moment;
    double spread;
  };

  [[gnu::always_inline]] inline Two value(const double* nodes) const {
    const At all = at(nodes);
    return {sum(interpolated(all, 0)) / 4, sum(interpolated(all, 1)) / 4};
  }
  [[gnu::always_inline]] inline Jet jet(const double* nodes) const {
    const At all = at(nodes);
    const Corners u = interpolated(all, 0), v = interpolated(all, 1);
    return {{sum(u) / 4, sum(v) / 4}, across(u, v) * duals()};
  }
  [[gnu::always_inline]] inline Moments moments(const double* nodes) const {
    const At all = at(nodes);
    const Corners variance[2] = {above_[0] * (1 - above_[0]), above_[1] * (1 - above_[1])};
    Corners u[2], square = {};
    double mean[2], moment[2][2];
    for (int d = 0; d < 2; ++d) {
      const Corners below_x = all.of[0][1][d] - all.of[0][0][d], above_x = all.of[1][1][d] - all.of[1][0][d];
      const Corners below = all.of[0][0][d] + above_[0] * below_x,
                    along = all.of[1][0][d] + above_[0] * above_x - below;
      u[d] = below + above_[1] * along;
      mean[d] = sum(u[d]) / 4;
      moment[d][0] = h_ / 4 * sum(variance[0] * (below_x + above_[1] * (above_x - below_x)));
      moment[d][1] = h_ / 4 * sum(variance[1] * along);
      const Corners off = u[d] - mean[d];
      square += off * off + variance[1] * along * along +
                variance[0] * ((1 - above_[1]) * below_x * below_x + above_[1] * above_x * above_x);
    }
    const Square corners = across(u[0], u[1]) * edges_.transposed();
    return {
        {mean[0], mean[1]},
        {corners.xx + moment[0][0], corners.xy + moment[0][1], corners.yx + moment[1][0], corners.yy + moment[1][1]},
        sum(square) / 4};
  }

  // Adds m N to masses and m N (v + C (x_i - x_p)) to momenta. [York 3.15, 3.16] [EC-APIC 1]
  template <bool with_mass>
  [[gnu::always_inline]] inline void spread_motion(double m, const Two& v, const Square& c, double* masses,
                                                   double* momenta) const {
    const NodePair step[2] = {NodePair{c.xx, c.yx} * h_, NodePair{c.xy, c.yy} * h_};
    const Square turned = c * edges_;
    const NodePair first{turned.xx, turned.yx}, second{turned.xy, turned.yy}, own{v.x, v.y};
    const Corners share = {m / 4, m / 4, m / 4, m / 4};
    const Corners low[2] = {share * (1 - above_[0]), share * above_[0]}, high[2] = {1 - above_[1], above_[1]};
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
      const NodePair here = own + Domains<2>::sign(k, 0) * first + Domains<2>::sign(k, 1) * second -
                            above_[0][k] * step[0] - above_[1][k] * step[1];
#pragma GCC unroll 4
      for (int n = 0; n < 4; ++n) {
        const int a = n & 1, b = n >> 1, i = node_[k] + a + b * row_;
        const double w = low[a][k] * high[b][k];
        if constexpr (with_mass) masses[i] += w;
        add(momenta + 2 * i, w * (here + a * step[0] + b * step[1]));
      }
    }
  }
  // Adds N base + flux grad N.
  [[gnu::always_inline]] inline void spread_force(const Two& base, const Square& flux, double* forces) const {
    const Square across = flux * duals().transposed();
    const NodePair first = NodePair{across.xx, across.yx} / 4, second = NodePair{across.xy, across.yy} / 4;
    const NodePair own = NodePair{base.x, base.y} / 4;
    const Corners low[2] = {1 - above_[0], above_[0]}, high[2] = {1 - above_[1], above_[1]};
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
      const NodePair force = own + Domains<2>::sign(k, 0) * first + Domains<2>::sign(k, 1) * second;
#pragma GCC unroll 4
      for (int n = 0; n < 4; ++n) {
        const int a = n & 1, b = n >> 1;
        add(forces + 2 * (node_[k] + a + b * row_), low[a][k] * high[b][k] * force);
      }
    }
  }
  // visit(node, N) for each corner and node.
  template <class Visit>
  [[gnu::always_inline]] inline void for_nodes(Visit&& visit) const {
    for (int k = 0; k < 4; ++k) {
      const double x = above_[0][k], y = above_[1][k];
      visit(node_[k], (1 - x) * (1 - y) / 4);
      visit(node_[k] + 1, x * (1 - y) / 4);
      visit(node_[k] + row_, (1 - x) * y / 4);
      visit(node_[k] + row_ + 1, x * y / 4);
    }
  }

 private:
  using NodePair [[gnu::vector_size(2 * sizeof(double))]] = double;
  static constexpr Corners first_sign = {-1, 1, -1, 1}, second_sign = {-1, -1, 1, 1};
  // Of both rows and both columns of the nodes of each corner's cell: component d of the field.
  struct At {
    Corners of[2][2][2];
  };

  [[gnu::always_inline]] static inline Square inertia(const Square& edges, const Corners& x, const Corners& y,
                                                      double h) {
    Square d = edges * edges.transposed();
    d.xx += h * h / 4 * sum(x * (1 - x));
    d.yy += h * h / 4 * sum(y * (1 - y));
    return d;
  }
  [[gnu::always_inline]] static inline int least(const CornerIndices& of) {
    return std::min(std::min(of[0], of[1]), std::min(of[2], of[3]));
  }
  [[gnu::always_inline]] static inline void add(double* node, const NodePair& value) {
    NodePair at;
    __builtin_memcpy(&at, node, sizeof at);
    at += value;
    __builtin_memcpy(node, &at, sizeof at);
  }
  // Both nodes of a row stand one behind the other: one read for each corner, then turned.
  [[gnu::always_inline]] inline At at(const double* nodes) const {
    At all;
#pragma GCC unroll 2
    for (int row = 0; row < 2; ++row) {
      Corners read[4];
#pragma GCC unroll 4
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
    const Corners below = all.of[0][0][d] + above_[0] * (all.of[0][1][d] - all.of[0][0][d]);
    const Corners above = all.of[1][0][d] + above_[0] * (all.of[1][1][d] - all.of[1][0][d]);
    return below + above_[1] * (above - below);
  }
  // Half the differences of corner values u, v along each edge, a column for each.
  [[gnu::always_inline]] static inline Square across(const Corners& u, const Corners& v) {
    return {sum(first_sign * u) / 4, sum(second_sign * u) / 4, sum(first_sign * v) / 4, sum(second_sign * v) / 4};
  }

  double h_;
  int row_, lowest_[2];
  Square edges_;        // m, a column for each
  CornerIndices node_;  // the lowest of each corner's cell, in the flat arrays
  Corners above_[2];    // how far above it the corner stands along each axis, cells
};

}  // namespace plumbline
