// Solids that hardly compress, of which the points of a cell share a dilatation theta: see kernel/engine/mean_dilatation.hpp.
#pragma once

#include <algorithm>
#include <type_traits>

#include "kernel/materials/elastic.hpp"
#include "kernel/pack.hpp"

namespace plumbline {

namespace column {
inline const ColumnId dilatation{"dilatation", "1"};              // theta_p
inline const ColumnId dilatation_rate{"dilatation_rate", "1/s"};  // (div v)^c
inline const ColumnId mean_dilatation{"mean_dilatation", "1"};    // theta^c
}  // namespace column

// Whether lambda is more than two times mu, nu more than 1/3: what is beyond that, cells share.
inline bool hardly_compresses(const LameConstants& c) { return c.lambda > 2 * c.mu; }

// A modulus of dilatation, Pa, and the part of it that is for a point's own where cells share the rest.
struct BulkModuli {
  double whole, own;
};

// The part of an elastic law that lambda is the modulus of, in two parts: by a point's own dilatation and, in bodies whose cells share
// one, by that.
//   W = lambda_o/2 own^2 + (lambda - lambda_o)/2 theta^2,  lambda_o = min(lambda, 2 mu)               [Dilatation 3]
inline BulkModuli bulk_moduli(const LameConstants& c) { return {c.lambda, std::min(c.lambda, 2 * c.mu)}; }

// Number: Pack, of the points from p on, or double, of point p.
template <class Number = Pack>
class Bulk {
 public:
  Bulk(const BulkModuli& moduli, const Columns& points)
      : theta_(values(points, column::dilatation)),
        rate_(values(points, column::dilatation_rate)),
        mean_(values(points, column::mean_dilatation)),
        own_(theta_ ? moduli.own : moduli.whole),
        shared_(moduli.whole - own_) {}
  Bulk(const LameConstants& c, const Columns& points) : Bulk(bulk_moduli(c), points) {}

  // theta_p, and what it is after dt; 0 of points that share none.
  Number dilatation(int p, double dt = 0) const { return theta_ ? at(theta_ + p) + dt * at(rate_ + p) : Number(0.0); }
  // J/m^3 at rest. own: of the point, ln J or tr eps.
  Number energy(const Number& own, const Number& theta) const {
    return 0.5 * own_ * own * own + 0.5 * shared_ * theta * theta;
  }
  // Its derivative, Pa, with the mean dilatation of the cell `ahead` seconds later. [Dilatation 2]
  Number tension(const Number& own, int p, double ahead) const {
    if (!mean_) return own_ * own;
    return own_ * own + shared_ * (at(mean_ + p) + ahead * at(rate_ + p));
  }

 private:
  static const double* values(const Columns& points, const ColumnId& id) {
    return points.has(id) ? points(id) : nullptr;
  }
  static Number at(const double* value) {
    if constexpr (std::is_same_v<Number, double>) {
      return *value;
    } else {
      return load(value);
    }
  }

  const double *theta_, *rate_, *mean_;
  double own_, shared_;  // Pa
};

// theta_p <- theta_p + dt (div v)^c. [Dilatation 1]
inline void advance_dilatation(Columns& points, int first, int last, double dt) {
  if (!points.has(column::dilatation)) return;
  double* theta = points(column::dilatation);
  const double* rate = points(column::dilatation_rate);
  for (int p = first; p < last; ++p) theta[p] += dt * rate[p];
}

}  // namespace plumbline
