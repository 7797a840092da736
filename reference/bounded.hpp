#pragma once
// A number with a computed bound of its own error, and the arithmetic that carries the bound along: running error
// analysis in midpoint-radius form [Higham 3.3] (N. J. Higham, Accuracy and Stability of Numerical Algorithms, 2002).
//
// Every operation returns a `bound` that holds for *all* true operands within the bounds of its arguments, its own
// rounding included. Rounding is counted double (2^-52 where IEEE 754 gives 2^-53), which also pays for the rounding
// of the bound itself; library functions are counted at 2 units in the last place, twice what the glibc manual
// ("Errors in Math Functions", x86_64 and aarch64, double) lists for sin, cos, log, log1p, expm1 and pow.
#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline::reference {

/// `value` with |value - true| <= `bound`; `bound` is absolute, >= 0, infinite where nothing can be said.
struct Bounded {
  double value = 0;
  double bound = 0;

  constexpr Bounded() = default;
  constexpr Bounded(double exact) : value(exact) {}  // implicit: a plain number is taken as exact
  constexpr Bounded(double value_, double bound_) : value(value_), bound(bound_) {}
};

namespace rounding {
inline constexpr double unit = std::numeric_limits<double>::epsilon();
inline constexpr double inflate = 1 + 4 * unit;
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// `value` computed with `ulps` units of rounding from operands that may shift it by `propagated`.
inline Bounded result(double value, double propagated, double ulps = 1) {
  const double own = ulps * unit * std::abs(value) + std::numeric_limits<double>::denorm_min();
  const double bound = (propagated + own) * inflate;
  return {value, std::isfinite(value) && bound >= 0 ? bound : infinity};
}
}  // namespace rounding

inline Bounded operator-(Bounded a) { return {-a.value, a.bound}; }

/// A sum never underflows, is exact where it is zero and where one term is zero.
inline Bounded operator+(Bounded a, Bounded b) {
  const double sum = a.value + b.value;
  const double own = a.value == 0 || b.value == 0 ? 0 : rounding::unit * std::abs(sum);
  const double bound = (a.bound + b.bound + own) * rounding::inflate;  // [Higham 3.3]
  return {sum, std::isfinite(sum) && bound >= 0 ? bound : rounding::infinity};
}
inline Bounded operator-(Bounded a, Bounded b) { return a + (-b); }

inline Bounded operator*(Bounded a, Bounded b) {
  const double spread = std::abs(a.value) * b.bound + std::abs(b.value) * a.bound + a.bound * b.bound;
  return rounding::result(a.value * b.value, spread);  // [Higham 3.3]
}

/// Infinite bound where the divisor may be zero.
inline Bounded operator/(Bounded a, Bounded b) {
  const double quotient = a.value / b.value;
  const double divisor = std::abs(b.value) - b.bound;
  if (!(divisor > 0)) return {quotient, rounding::infinity};
  return rounding::result(quotient, (a.bound + std::abs(quotient) * b.bound) / divisor);  // [Higham 3.3]
}

/// For true arguments >= 0: the part of the interval below zero is cut off.
inline Bounded sqrt(Bounded x) {
  const double at = std::max(x.value, 0.0), root = std::sqrt(at);
  if (x.bound == 0) return rounding::result(root, 0);
  const double above = std::sqrt(at + x.bound) - root;
  const double below = at > x.bound ? x.bound / (root + std::sqrt(at - x.bound)) : root;
  return rounding::result(root, std::max(above * rounding::inflate + rounding::unit * root, below));
}

/// Largest change of log x over the interval; infinite if the interval reaches zero.
inline double log_spread(Bounded x) {
  const double relative = x.bound / x.value;
  if (!(relative < 1)) return rounding::infinity;
  return relative < 1e-3 ? relative * (1 + relative) : -std::log1p(-relative);  // -log(1 - r) <= r + r^2 for r <= 1/2
}

inline Bounded log(Bounded x) { return rounding::result(std::log(x.value), log_spread(x), 2); }

inline Bounded expm1(Bounded x) {
  const double value = std::expm1(x.value);
  return rounding::result(value, (value + 1) * std::expm1(x.bound) * rounding::inflate, 2);
}

/// x^a for true x >= 0; where the interval of x reaches zero, a > 0 still has a finite bound.
inline Bounded pow(Bounded x, Bounded a) {
  const double base = std::max(x.value, 0.0), value = std::pow(base, a.value);
  const double spread = log_spread({base, x.bound});
  if (base > 0 && std::isfinite(spread)) {  // |d log(x^a)| <= |a| |d log x| + |da| |log x|
    const double log_x = a.bound > 0 ? std::abs(std::log(base)) : 0;
    const double change = (std::abs(a.value) + a.bound) * spread + a.bound * (log_x + 1e-15);
    const double factor = change < 1e-3 ? change * (1 + change) : std::expm1(change) * (1 + 1e-12);
    return rounding::result(value, value * factor, 2);
  }
  if (!(a.value > a.bound)) return {value, rounding::infinity};
  const double top = base + x.bound;
  if (top == 0) return {0, 0};
  const double high = std::pow(top * rounding::inflate, a.value) * std::exp(a.bound * std::abs(std::log(top)) + 1e-15);
  return rounding::result(value, high, 2);
}

inline Bounded sin(Bounded x) { return rounding::result(std::sin(x.value), std::min(x.bound, 2.0), 2); }
inline Bounded cos(Bounded x) { return rounding::result(std::cos(x.value), std::min(x.bound, 2.0), 2); }

inline double lowest(Bounded x) { return x.value - x.bound; }
inline double highest(Bounded x) { return x.value + x.bound; }

/// True if a < b for all true values within the bounds.
inline bool certainly_below(Bounded a, Bounded b) {
  return b.value - a.value > (a.bound + b.bound) * rounding::inflate;
}

/// a's value, with a bound that also covers everything b covers.
inline Bounded hull(Bounded a, Bounded b) {
  const double distance = std::abs(b.value - a.value) * rounding::inflate + b.bound;
  return {a.value, distance >= 0 ? std::max(a.bound, distance * rounding::inflate) : rounding::infinity};
}

/// f over the interval of x (cut off below `least`), for an f that never decreases and takes an exact double.
template <class Function>
Bounded over_interval(const Function& f, Bounded x, double least = 0) {
  const Bounded middle = f(x.value);
  if (x.bound == 0) return middle;
  const Bounded low = f(std::max(least, x.value - x.bound * rounding::inflate - std::abs(x.value) * rounding::unit));
  const Bounded high = f(x.value + x.bound * rounding::inflate + std::abs(x.value) * rounding::unit);
  return hull(hull(middle, low), high);
}

}  // namespace plumbline::reference
