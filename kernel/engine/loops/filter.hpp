// What points take where nodes leave them a part of what the grid does not carry. [Filter 1]
#pragma once

#include <algorithm>

#include "kernel/engine/loops/shape_loops.hpp"

namespace plumbline {

// What a filtered map back gives where that and what the map to the nodes took are less than nothing by rounding.
[[gnu::always_inline]] inline Pack repaid(const Pack& given, const Pack& taken) {
  constexpr double rounding = 1e-12;  // of sums of squares that cancel
  constexpr double least = 1e-300;    // J, below which numbers have hardly any digits
  return choose(taken >= 0.0 && given < -taken && given > -(1 + rounding) * taken - least, -taken, given);
}

// The nodal values of a bin: 1 - alpha_i, and with it velocities relative to the bin's base.
template <class G, class S>
struct ShapeLoops<G, S>::BinFilter {
  double most = 0;
  BinNumbers kept;
  BinVectors pushed;  // v~_i - (1 - alpha_i) v_i
  BinVectors pulled;  // (1 - alpha_i) v~_i
  BinNumbers work;    // |v~_i|^2 - 2 (1 - alpha_i) v_i . v~_i
};

template <class G, class S>
[[gnu::always_inline]] inline auto ShapeLoops<G, S>::bin_filter(const Print& print, const Field& field,
                                                                const BinVelocity& end) const -> BinFilter {
  BinFilter bin;
  for_stencil_nodes(print, [&](int k, std::size_t i) {
    const double kept = field.gas.kept[i];
    bin.kept[k] = kept;
    bin.most = std::max(bin.most, kept);
    bin.work[k] = end.square[k];
    for (int d = 0; d < dim; ++d) {
      const double start = field.start[i][d] - end.base[d];
      bin.pushed[k][d] = end.u[k][d] - kept * start;
      bin.pulled[k][d] = kept * end.u[k][d];
      bin.work[k] -= 2 * kept * start * end.u[k][d];
    }
  });
  return bin;
}

// With y_p(x) = v_p + C_p (x - x_p) and w_ip = v~_i + (1 - alpha_i) (y_p(x_i) - v_i): v_p' = sum N w, C_p' = D^-1 sum N w r^T,
// all velocities relative to the bin's base. Returns twice the energy per mass that is not kept, beyond what the map to the
// nodes lost as if alpha_i were 1, but for the affine part's: sum N (|v~|^2 + 2 (1 - alpha) (y - v) . v~) - |v_p'|^2.
template <class G, class S>
[[gnu::always_inline]] inline Pack ShapeLoops<G, S>::take_filtered(const BinFilter& bin, const PackStencil& weights,
                                                                   const Pack (&inertia)[dim], Pack (&v)[dim],
                                                                   Pack (&c)[dim][dim]) const {
  const auto kept = weights.moments_of_array([&](int k) { return bin.kept[k]; });
  Pack square = weights.gather_array([&](int k) { return bin.work[k]; }).value;
  for (int d = 0; d < dim; ++d) {
    const auto pushed = weights.gather_array([&](int k) { return bin.pushed[k][d]; });
    const auto pulled = weights.gather_array([&](int k) { return bin.pulled[k][d]; });
    Pack taken = pushed.value + v[d] * kept.value, turned[dim];
    square += 2.0 * v[d] * pulled.value;
    for (int e = 0; e < dim; ++e) {
      taken += c[d][e] * kept.moment[e];
      square += 2.0 * c[d][e] * inertia[e] * pulled.affine[e];
      turned[e] = pushed.affine[e] + v[d] * kept.affine[e];
      for (int f = 0; f < dim; ++f) turned[e] += c[d][f] * kept.turn[f][e];
    }
    v[d] = taken;
    square -= taken * taken;
    for (int e = 0; e < dim; ++e) c[d][e] = turned[e];
  }
  return square;
}

}  // namespace plumbline
