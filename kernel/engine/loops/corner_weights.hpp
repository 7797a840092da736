// The weights of packs of points whose parallelograms carry tents at their four corners, over a square block of nodes.
// [CPDI 2] [CPDI 3]
#pragma once

#include "kernel/engine/loops/node_block.hpp"
#include "kernel/pack.hpp"
#include "kernel/shapes/cpdi.hpp"

namespace plumbline {

struct PackVector {
  Pack x, y;
  Pack square() const { return x * x + y * y; }
};
struct PackMatrix {
  Pack xx, xy, yx, yy;  // row by row

  PackMatrix operator*(const PackMatrix& o) const {
    return {xx * o.xx + xy * o.yx, xx * o.xy + xy * o.yy, yx * o.xx + yy * o.yx, yx * o.xy + yy * o.yy};
  }
  PackMatrix operator-(const PackMatrix& o) const { return {xx - o.xx, xy - o.xy, yx - o.yx, yy - o.yy}; }
  PackMatrix times(const Pack& factor) const { return {factor * xx, factor * xy, factor * yx, factor * yy}; }
  PackMatrix transposed() const { return {xx, yx, xy, yy}; }
  PackMatrix inverse() const {
    const Pack per_area = 1.0 / (xx * yy - xy * yx);
    return {per_area * yy, -per_area * xy, -per_area * yx, per_area * xx};
  }
  Pack dot(const PackMatrix& o) const { return xx * o.xx + xy * o.xy + yx * o.yx + yy * o.yy; }
};

// Points and their domains, in cells.
struct Parallelograms {
  PackVector place;  // from the first ghost nodes
  PackMatrix edges;  // half of each, a column for each, as squeezed there

  PackVector corner(int c) const {
    const double first = Domains<2>::sign(c, 0), second = Domains<2>::sign(c, 1);
    return {place.x + first * edges.xx + second * edges.xy, place.y + first * edges.yx + second * edges.yy};
  }
  // How far the corners lie from the points.
  PackVector reach() const { return {abs(edges.xx) + abs(edges.xy), abs(edges.yx) + abs(edges.yy)}; }

  // D_p = sum N (x_i - x_p) (x_i - x_p)^T, m^2: of the corners, and of the tents within their cells. [CPDI 4]
  PackMatrix inertia(double h) const {
    PackMatrix d = edges * edges.transposed();
    for (int c = 0; c < Domains<2>::corners; ++c) {
      const PackVector at = corner(c), above{at.x - floor(at.x), at.y - floor(at.y)};
      d.xx += 0.25 * above.x * (1.0 - above.x);
      d.yy += 0.25 * above.y * (1.0 - above.y);
    }
    return d.times(h * h);
  }
};

// What a nodal field of vectors is at points: sum N f and sum f grad N^T.
struct PackJet {
  PackVector value;
  PackMatrix gradient;
};
// sum N f, sum N f (x_i - x_p)^T, and sum N |f|^2 - |sum N f|^2.
struct PackMoments {
  PackVector value;
  PackMatrix moment;
  Pack spread;
};

// Of points whose corners do not leave the block. Arrays that a loop does not read are not computed.
template <int side>
struct DomainWeights {
  static constexpr int nodes = side * side;

  Pack n[nodes];  // N_i
  // Its differences along both edges, sum_c s_ck N_i(x_c) / 4: grad N_i = sum_k r^k of them.
  Pack first[nodes], second[nodes];
  Pack x[side], y[side];  // of x_i - x_p, m
  PackMatrix duals;       // r^k, 1/m, row by row

  [[gnu::always_inline]] inline DomainWeights(const Parallelograms& at, const NodeBlock<side>& block, double h)
      : duals(at.edges.inverse().times(1 / h)) {
    Pack along[corners][side], up[corners][side];
    for (int c = 0; c < corners; ++c) {
      const PackVector corner = at.corner(c);
      tents(corner.x - block.x, 1.0, along[c]);
      tents(0.25 * (corner.y - block.y), 0.25, up[c]);
    }
    for (int k = 0; k < side; ++k) {
      x[k] = (block.x + k - at.place.x) * h;
      y[k] = (block.y + k - at.place.y) * h;
    }
    for (int i = 0; i < nodes; ++i) {
      const auto here = [&](int c) { return along[c][i % side] * up[c][i / side]; };
      const Pack rising = here(3) - here(0), falling = here(1) - here(2);
      n[i] = (here(0) + here(3)) + (here(1) + here(2));
      first[i] = rising + falling;
      second[i] = rising - falling;
    }
  }

  [[gnu::always_inline]] inline PackVector value(const BlockVelocity<side>& of) const {
    PackVector sum{of.base[0], of.base[1]};
    for (int i = 0; i < nodes; ++i) {
      sum.x += n[i] * of.u[i][0];
      sum.y += n[i] * of.u[i][1];
    }
    return sum;
  }
  [[gnu::always_inline]] inline PackJet jet(const BlockVelocity<side>& of) const {
    PackMatrix by{0.0, 0.0, 0.0, 0.0};  // along both edges
    for (int i = 0; i < nodes; ++i) {
      by.xx += first[i] * of.u[i][0];
      by.xy += second[i] * of.u[i][0];
      by.yx += first[i] * of.u[i][1];
      by.yy += second[i] * of.u[i][1];
    }
    return {value(of), by * duals};
  }
  [[gnu::always_inline]] inline PackMoments moments(const BlockVelocity<side>& of) const {
    Pack square = 0.0, mean[2], moment[2][2];
    for (int i = 0; i < nodes; ++i) square += n[i] * of.square[i];
    for (int d = 0; d < 2; ++d) {
      mean[d] = moment[d][0] = moment[d][1] = 0.0;
      for (int b = 0; b < side; ++b) {
        Pack row = 0.0;
        for (int a = 0; a < side; ++a) {
          const Pack share = n[a + side * b] * of.u[a + side * b][d];
          row += share;
          moment[d][0] += share * x[a];
        }
        mean[d] += row;
        moment[d][1] += row * y[b];
      }
      square -= mean[d] * mean[d];
      mean[d] += of.base[d];
    }
    return {{mean[0], mean[1]}, {moment[0][0], moment[0][1], moment[1][0], moment[1][1]}, square};
  }

 private:
  static constexpr int corners = Domains<2>::corners;

  // Of a place from the first node on, times `one`: what each node's tent is there, times `one`. The shares of the cells that
  // it has passed add up.
  [[gnu::always_inline]] static inline void tents(const Pack& at, double one, Pack (&n)[side]) {
    Pack below = one;
    for (int k = 0; k + 1 < side; ++k) {
      const Pack passed = min(max(at - k * one, Pack(0.0)), Pack(one));
      n[k] = below - passed;
      below = passed;
    }
    n[side - 1] = below;
  }
};

}  // namespace plumbline
