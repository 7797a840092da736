#pragma once
// More elementary functions with bounds. The hyperbolic ones are counted at 4 units in the last place, twice what the
// glibc manual lists for them ("Errors in Math Functions", x86_64 and aarch64, double: at most 2), the others at 2.
#include "reference/bounded.hpp"

namespace plumbline::reference {

inline Bounded abs(Bounded x) { return {std::abs(x.value), x.bound}; }

/// The derivative is at most 1.
inline Bounded atan(Bounded x) { return rounding::result(std::atan(x.value), x.bound, 2); }

/// |d angle| <= |d vector|/length; infinite bound where the vector may be zero.
inline Bounded atan2(Bounded y, Bounded x) {
  const double length = std::hypot(x.value, y.value), spread = std::hypot(x.bound, y.bound);
  const double margin = length * (1 - 4 * rounding::unit) - spread;
  if (!(margin > 0)) return {std::atan2(y.value, x.value), rounding::infinity};
  return rounding::result(std::atan2(y.value, x.value), spread / margin * (1 + 4 * rounding::unit), 2);
}

/// The derivative is 1/sqrt(1 + x^2), largest at the end of the interval next to zero.
inline Bounded asinh(Bounded x) {
  const double nearest = std::max(0.0, std::abs(x.value) - x.bound);
  const double slope = 1 / std::sqrt(1 + nearest * nearest) * rounding::inflate;
  return rounding::result(std::asinh(x.value), slope * x.bound, 4);
}

/// The derivative is cosh, largest at the end of the interval furthest from zero.
inline Bounded sinh(Bounded x) {
  const double slope = x.bound == 0 ? 0 : std::cosh(std::abs(x.value) + x.bound) * (1 + 8 * rounding::unit);
  return rounding::result(std::sinh(x.value), x.bound == 0 ? 0 : slope * x.bound, 4);
}

inline Bounded cosh(Bounded x) {
  const double slope = x.bound == 0 ? 0 : std::sinh(std::abs(x.value) + x.bound) * (1 + 8 * rounding::unit);
  return rounding::result(std::cosh(x.value), x.bound == 0 ? 0 : slope * x.bound, 4);
}

}  // namespace plumbline::reference
