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
  // both in cells; h in m, per_h = 1 / h.
  [[gnu::always_inline]] inline Stencil(const Number (&local)[dim], const Number (&half)[dim], double h, double per_h)
      : h_(h),
        per_h_(per_h) {
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
    }
  }

  [[gnu::always_inline]] inline Stencil(const Number (&local)[dim], double h) requires(!Shape::boxes)
      : Stencil(local, local, h, 1 / h) {}

  // The jet of the field at(offset), offset from the lowest node. Parts that are not used are not computed.
  template <class At>
  [[gnu::always_inline]] inline Jet<dim, Number> gather(const Footprint<dim>& footprint, At&& at) const {
    Jet<dim, Number> jet = gather_along<dim - 1>(footprint, at, 0);
    for (int d = 0; d < dim; ++d) {
      jet.gradient[d] *= per_h_;
      jet.affine[d] *= per_h_;
    }
    return jet;
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

  // w_d at the points, for each node of the stencil in turn: below(k), less h times how fast its cell stretches along d, and
  // face(k), the velocity of the face above it. [Pressure 4]
  template <int d, class Below, class Face>
  [[gnu::always_inline]] inline Number gather_flow(Below&& below, Face&& face) const {
    Number above[support];
    Shape::above(local_[d], above);
    return product_along<d, dim - 1>(above, below, 0) + product_along<d, dim - 1>(face, 0);
  }

  // The moments of an array with one scalar for each node of the stencil in turn.
  template <class At>
  [[gnu::always_inline]] inline Moments<dim, Number> moments_of_array(At&& at) const {
    Number a[dim][support], moment[dim][support], square[dim][support];  // D^-1 N r, N r and D^-1 N r^2
    for (int d = 0; d < dim; ++d) {
      for (int k = 0; k < support; ++k) {
        a[d][k] = a_[d][k] * per_h_;
        moment[d][k] = n_[d][k] * distance(d, k);
        square[d][k] = a[d][k] * distance(d, k);
      }
    }
    return moments_along<dim - 1>(at, {a, moment, square}, 0);
  }

  // D_p along d: sum N (x_i - x_p)_d^2, m^2. [EC-APIC 5]
  Number inertia(int d) const {
    if constexpr (Shape::boxes)
      return Shape::inertia(local_[d], half_[d]) * (h_ * h_);
    else
      return Shape::inertia(local_[d]) * (h_ * h_);
  }

  // scale N of each node of the stencil in turn.
  [[gnu::always_inline]] inline void find_weights(const Number& scale, Number (&weights)[nodes]) const {
    weights_along<dim - 1>(scale, weights);
  }
  // Adds to sums[node * step], for each node of the stencil in turn, w (base + slope . (x_i - x_p)) of weights w.
  [[gnu::always_inline]] inline void spread_moment(const Number (&weights)[nodes], const Number& base,
                                                   const Number (&slope)[dim], Number* sums, int step) const {
    Number along[support];  // the first direction's part
    for (int k = 0; k < support; ++k) along[k] = slope[0] * distance(0, k);
    spread_moment_along<dim - 1>(weights, base, slope, along, sums, step);
  }
  // Adds slope . grad N.
  [[gnu::always_inline]] inline void spread_gradient(const Number (&slope)[dim], Number* sums, int step) const {
    Number per_cell[dim];
    for (int d = 0; d < dim; ++d) per_cell[d] = slope[d] * per_h_;
    spread_gradient_along<dim - 1>(per_cell, sums, step);
  }
  // Adds s grad N: component d to sums[node * step + d].
  [[gnu::always_inline]] inline void spread_divergence(const Number& s, Number* sums, int step) const {
    const Number per_cell = s * per_h_;
    for (int d = 0; d < dim; ++d) spread_product<dim - 1>(d, per_cell, sums + d, step);
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

  // (x_i - x_p)_d of the k-th node along d, m.
  [[gnu::always_inline]] inline Number distance(int d, int k) const {
    return (static_cast<double>(k + Shape::first) - local_[d]) * h_;
  }

  // Sums begin with their first term, but where the compiler keeps the loop: there it would be compiled twice.
  template <int d>
  [[gnu::always_inline]] static inline void add(int term, Number& sum, const Number& value) {
    if ((dim < 3 || d == 0) && term == 0)
      sum = value;
    else
      sum += value;
  }

  // Gradients and affine parts per cell.
  template <int d, class At>
  [[gnu::always_inline]] inline Jet<dim, Number> gather_along(const Footprint<dim>& footprint, At& at,
                                                              int offset) const {
    Jet<dim, Number> sums;
    if constexpr (dim == 3 && d > 0) {
      sums.value = 0.0;
      for (int k = 0; k <= d; ++k) sums.gradient[k] = sums.affine[k] = 0.0;
    }
    for (int j = 0; j < support; ++j) {
      const int here = offset + j * footprint.stride[d];
      Jet<dim, Number> below;
      if constexpr (d == 0)
        below.value = at(static_cast<std::size_t>(footprint.lowest + here));
      else
        below = gather_along<d - 1>(footprint, at, here);
      add<d>(j, sums.value, n_[d][j] * below.value);
      add<d>(j, sums.gradient[d], g_[d][j] * below.value);
      add<d>(j, sums.affine[d], a_[d][j] * below.value);
      for (int k = 0; k < d; ++k) {
        add<d>(j, sums.gradient[k], n_[d][j] * below.gradient[k]);
        add<d>(j, sums.affine[k], n_[d][j] * below.affine[k]);
      }
    }
    return sums;
  }

  // The sum of an array times N, with the weights `by` in place of N along the direction `replaced`.
  template <int replaced, int d, class At>
  [[gnu::always_inline]] inline Number product_along(const Number (&by)[support], At& at, int offset) const {
    Number sum = 0.0;
    for (int j = 0; j < support; ++j) {
      const Number& weight = d == replaced ? by[j] : n_[d][j];
      if constexpr (d == 0)
        sum += weight * at(offset + j);
      else
        sum += weight * product_along<replaced, d - 1>(by, at, offset + j * block<d>());
    }
    return sum;
  }
  // The same of the last nodes along that direction, with one in place of N.
  template <int last, int d, class At>
  [[gnu::always_inline]] inline Number product_along(At& at, int offset) const {
    Number sum = 0.0;
    for (int j = d == last ? support - 1 : 0; j < support; ++j) {
      const auto below = [&] {
        if constexpr (d == 0)
          return at(offset + j);
        else
          return product_along<last, d - 1>(at, offset + j * block<d>());
      };
      sum += d == last ? Number(below()) : n_[d][j] * below();
    }
    return sum;
  }

  struct Factors {
    const Number (&a)[dim][support], (&moment)[dim][support], (&square)[dim][support];
  };

  template <int d, class At>
  [[gnu::always_inline]] inline Moments<dim, Number> moments_along(At& at, const Factors& by, int offset) const {
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
        below = moments_along<d - 1>(at, by, here);
      sums.value += n_[d][j] * below.value;
      sums.affine[d] += by.a[d][j] * below.value;
      sums.moment[d] += by.moment[d][j] * below.value;
      sums.turn[d][d] += by.square[d][j] * below.value;
      for (int k = 0; k < d; ++k) {
        sums.affine[k] += n_[d][j] * below.affine[k];
        sums.moment[k] += n_[d][j] * below.moment[k];
        sums.turn[d][k] += by.moment[d][j] * below.affine[k];
        sums.turn[k][d] += by.a[d][j] * below.moment[k];
        for (int l = 0; l < d; ++l) sums.turn[k][l] += n_[d][j] * below.turn[k][l];
      }
    }
    return sums;
  }

  template <int d>
  [[gnu::always_inline]] inline void weights_along(const Number& scale, Number* weights) const {
    for (int j = 0; j < support; ++j) {
      const Number here = n_[d][j] * scale;
      if constexpr (d == 0) {
        weights[j] = here;
      } else {
        weights_along<d - 1>(here, weights + j * block<d>());
      }
    }
  }

  template <int d>
  [[gnu::always_inline]] inline void spread_moment_along(const Number* weights, const Number& base,
                                                         const Number (&slope)[dim], const Number (&along)[support],
                                                         Number* sums, int step) const {
    for (int j = 0; j < support; ++j) {
      if constexpr (d == 0) {
        sums[j * step] += weights[j] * (base + along[j]);
      } else {
        spread_moment_along<d - 1>(weights + j * block<d>(), base + slope[d] * distance(d, j), slope, along,
                                   sums + j * block<d>() * step, step);
      }
    }
  }

  template <int d>
  [[gnu::always_inline]] inline void spread_gradient_along(const Number (&slope)[dim], Number* sums, int step) const {
    for (int j = 0; j < support; ++j) {
      if constexpr (d == 0) {
        sums[j * step] += g_[0][j] * slope[0];
      } else {
        Number below[dim];
        for (int k = 0; k < d; ++k) below[k] = n_[d][j] * slope[k];
        spread_along<d - 1>(g_[d][j] * slope[d], below, sums + j * block<d>() * step, step);
      }
    }
  }
  // Adds N base + slope . grad N in the directions up to d.
  template <int d>
  [[gnu::always_inline]] inline void spread_along(const Number& base, const Number (&slope)[dim], Number* sums,
                                                  int step) const {
    for (int j = 0; j < support; ++j) {
      const Number here = n_[d][j] * base + g_[d][j] * slope[d];
      if constexpr (d == 0) {
        sums[j * step] += here;
      } else {
        Number below[dim];
        for (int k = 0; k < d; ++k) below[k] = n_[d][j] * slope[k];
        spread_along<d - 1>(here, below, sums + j * block<d>() * step, step);
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

  double h_, per_h_;
  Number local_[dim], half_[dim];
  Number n_[dim][support], g_[dim][support], a_[dim][support];  // g_ and a_ per cell
};

}  // namespace plumbline
