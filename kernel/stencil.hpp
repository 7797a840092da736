// The nodes that the points of one bin reach, and sums over them by tensor products, one direction after another.
#pragma once

#include <cstddef>

#include "kernel/geometry.hpp"

namespace plumbline {

// Where the stencil of a bin lies in the flat nodal arrays: its lowest node, and the step from node to node.
template <int dim>
struct Footprint {
  int lowest = 0;
  int stride[dim] = {};
};

// What a field on the nodes is at the points: sum N f, sum grad N f, and sum D^-1 N (x_i - x_p) f. [EC-APIC 5]
template <int dim, class Number>
struct Jet {
  Number value, gradient[dim], affine[dim];
};

// What a scalar on the nodes is at the points up to second moments, r = x_i - x_p: sum N f, sum D^-1 N f r, sum N f r and
// sum N f r r^T D^-1.
template <int dim, class Number>
struct Moments {
  Number value, affine[dim], moment[dim], turn[dim][dim];
};

// Weights of one point, or of a pack of points of one bin, in each direction.
template <int dim, class Shape, class Number>
class Stencil {
 public:
  static constexpr int support = Shape::support;
  static constexpr int nodes = dim == 1 ? support : dim == 2 ? support * support : support * support * support;

  // local: coordinate from the anchor node per direction, half: half size of the point's box where the shape has boxes,
  // both in cells; h in m.
  [[gnu::always_inline]] inline Stencil(const Number (&local)[dim], const Number (&half)[dim], double h) : h_(h) {
    for (int d = 0; d < dim; ++d) {
      local_[d] = local[d];
      half_[d] = half[d];
      if constexpr (Shape::boxes) {
        Shape::weights(local[d], half[d], n_[d]);
        Shape::gradients(local[d], half[d], g_[d]);
        Shape::affine_weights(local[d], half[d], a_[d]);
      } else {
        Shape::weights(local[d], n_[d]);
        Shape::gradients(local[d], g_[d]);
        Shape::affine_weights(local[d], a_[d]);
      }
      for (int k = 0; k < support; ++k) {
        g_[d][k] *= 1 / h;
        a_[d][k] *= 1 / h;
        moment_[d][k] = n_[d][k] * ((static_cast<double>(k + Shape::first) - local[d]) * h);
      }
    }
  }

  [[gnu::always_inline]] inline Stencil(const Number (&local)[dim], double h) requires(!Shape::boxes)
      : Stencil(local, local, h) {}

  // The jet of the field at(offset), offset from the lowest node. Parts that are not used are not computed.
  template <class At>
  [[gnu::always_inline]] inline Jet<dim, Number> gather(const Footprint<dim>& footprint, At&& at) const {
    return gather_along<dim - 1>(footprint, at, 0);
  }

  // The same of an array with one value for each node of the stencil in turn.
  template <class At>
  [[gnu::always_inline]] inline Jet<dim, Number> gather_array(At&& at) const {
    Footprint<dim> own;
    own.lowest = 0;
    own.stride[0] = 1;
    for (int d = 1; d < dim; ++d) own.stride[d] = own.stride[d - 1] * support;
    return gather(own, [&](std::size_t k) { return at(static_cast<int>(k)); });
  }

  // The moments of an array with one scalar for each node of the stencil in turn.
  template <class At>
  [[gnu::always_inline]] inline Moments<dim, Number> moments_of_array(At&& at) const {
    Number square[dim][support];  // D^-1 N r^2
    for (int d = 0; d < dim; ++d) {
      for (int k = 0; k < support; ++k) {
        square[d][k] = a_[d][k] * ((static_cast<double>(k + Shape::first) - local_[d]) * h_);
      }
    }
    return moments_along<dim - 1>(at, square, 0);
  }

  // D_p along d: sum N (x_i - x_p)_d^2, m^2. [EC-APIC 5]
  Number inertia(int d) const {
    if constexpr (Shape::boxes)
      return Shape::inertia(local_[d], half_[d]) * (h_ * h_);
    else
      return Shape::inertia(local_[d]) * (h_ * h_);
  }

  // Adds to sums[node * step], for each node of the stencil in turn, N base + sum_d slope_d dN/dx_d.
  [[gnu::always_inline]] inline void spread_gradient(const Number& base, const Number (&slope)[dim], Number* sums,
                                                     int step) const {
    spread_along<dim - 1>(g_, base, slope, sums, step);
  }
  // Adds s grad N: component d to sums[node * step + d].
  [[gnu::always_inline]] inline void spread_divergence(const Number& s, Number* sums, int step) const {
    for (int d = 0; d < dim; ++d) spread_product<dim - 1>(d, s, sums + d, step);
  }
  // The same with N (x_i - x_p)_d in place of dN/dx_d.
  [[gnu::always_inline]] inline void spread_moment(const Number& base, const Number (&slope)[dim], Number* sums,
                                                   int step) const {
    spread_along<dim - 1>(moment_, base, slope, sums, step);
  }
  // Adds N base.
  [[gnu::always_inline]] inline void spread(const Number& base, Number* sums, int step) const {
    spread_value<dim - 1>(base, sums, step);
  }

 private:
  template <int d>
  static constexpr int block() {  // nodes of the stencil in the directions below d
    return d == 0 ? 1 : d == 1 ? support : support * support;
  }

  template <int d, class At>
  [[gnu::always_inline]] inline Jet<dim, Number> gather_along(const Footprint<dim>& footprint, At& at,
                                                              int offset) const {
    Jet<dim, Number> sums;
    sums.value = 0.0;
    for (int k = 0; k <= d; ++k) sums.gradient[k] = sums.affine[k] = 0.0;
    for (int j = 0; j < support; ++j) {
      const int here = offset + j * footprint.stride[d];
      if constexpr (d == 0) {
        const Number f = at(static_cast<std::size_t>(footprint.lowest + here));
        sums.value += n_[0][j] * f;
        sums.gradient[0] += g_[0][j] * f;
        sums.affine[0] += a_[0][j] * f;
      } else {
        const Jet<dim, Number> below = gather_along<d - 1>(footprint, at, here);
        sums.value += n_[d][j] * below.value;
        sums.gradient[d] += g_[d][j] * below.value;
        sums.affine[d] += a_[d][j] * below.value;
        for (int k = 0; k < d; ++k) {
          sums.gradient[k] += n_[d][j] * below.gradient[k];
          sums.affine[k] += n_[d][j] * below.affine[k];
        }
      }
    }
    return sums;
  }

  template <int d, class At>
  [[gnu::always_inline]] inline Moments<dim, Number> moments_along(At& at, const Number (&square)[dim][support],
                                                                   int offset) const {
    Moments<dim, Number> sums;
    sums.value = 0.0;
    for (int k = 0; k <= d; ++k) {
      sums.affine[k] = sums.moment[k] = 0.0;
      for (int l = 0; l <= d; ++l) sums.turn[k][l] = 0.0;
    }
    for (int j = 0; j < support; ++j) {
      const int here = offset + j * block<d>();
      Moments<dim, Number> below;
      if constexpr (d == 0)
        below.value = at(here);
      else
        below = moments_along<d - 1>(at, square, here);
      sums.value += n_[d][j] * below.value;
      sums.affine[d] += a_[d][j] * below.value;
      sums.moment[d] += moment_[d][j] * below.value;
      sums.turn[d][d] += square[d][j] * below.value;
      for (int k = 0; k < d; ++k) {
        sums.affine[k] += n_[d][j] * below.affine[k];
        sums.moment[k] += n_[d][j] * below.moment[k];
        sums.turn[d][k] += moment_[d][j] * below.affine[k];
        sums.turn[k][d] += a_[d][j] * below.moment[k];
        for (int l = 0; l < d; ++l) sums.turn[k][l] += n_[d][j] * below.turn[k][l];
      }
    }
    return sums;
  }

  template <int d>
  [[gnu::always_inline]] inline void spread_along(const Number (&other)[dim][support], const Number& base,
                                                  const Number (&slope)[dim], Number* sums, int step) const {
    for (int j = 0; j < support; ++j) {
      const Number here = n_[d][j] * base + other[d][j] * slope[d];
      if constexpr (d == 0) {
        sums[j * step] += here;
      } else {
        Number below[dim];
        for (int k = 0; k < d; ++k) below[k] = n_[d][j] * slope[k];
        spread_along<d - 1>(other, here, below, sums + j * block<d>() * step, step);
      }
    }
  }

  // Adds s N with dN/dx in place of N along `slope`.
  template <int d>
  [[gnu::always_inline]] inline void spread_product(int slope, const Number& s, Number* sums, int step) const {
    for (int j = 0; j < support; ++j) {
      const Number here = (d == slope ? g_[d][j] : n_[d][j]) * s;
      if constexpr (d == 0) {
        sums[j * step] += here;
      } else {
        spread_product<d - 1>(slope, here, sums + j * block<d>() * step, step);
      }
    }
  }

  template <int d>
  [[gnu::always_inline]] inline void spread_value(const Number& base, Number* sums, int step) const {
    for (int j = 0; j < support; ++j) {
      const Number here = n_[d][j] * base;
      if constexpr (d == 0) {
        sums[j * step] += here;
      } else {
        spread_value<d - 1>(here, sums + j * block<d>() * step, step);
      }
    }
  }

  double h_;
  Number local_[dim], half_[dim], n_[dim][support], g_[dim][support], a_[dim][support], moment_[dim][support];
};

}  // namespace plumbline
