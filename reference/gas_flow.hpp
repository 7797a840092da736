#pragma once
// What the exact gas flows share: arguments, the measure of a sphere in 1, 2, 3 dimensions, and fronts whose place is
// known within a bound.
#include "reference/argument.hpp"
#include "reference/bounded.hpp"
#include "reference/circle.hpp"
#include "reference/parameter.hpp"
#include "reference/riemann.hpp"

namespace plumbline::reference {

// Each throws ParameterError with the key.
inline void check_gamma(double gamma) { check({"gamma", 0, 1, rounding::infinity, true, true, "", ""}, gamma); }
inline void check_dimension(int dimension) {
  if (dimension < 1 || dimension > 3) throw ParameterError("dimension", dimension, "1, 2 or 3");
}

/// Measure of the unit sphere: 2 (both sides of a plane), 2 pi, 4 pi.
inline Bounded sphere_measure(int dimension) {
  if (dimension == 1) return 2.0;
  return dimension == 2 ? Bounded(2) * pi : Bounded(4) * pi;
}

inline Sample hull(const Sample& a, const Sample& b) {
  return {hull(a.density, b.density), hull(a.velocity, b.velocity), hull(a.pressure, b.pressure),
          hull(a.energy, b.energy)};
}

/// `inside` left of the front, `outside` from the front on; where the bound of the front leaves the side open, the
/// bounds cover both.
template <class Inside, class Outside>
Sample beside_front(double position, Bounded front, const Inside& inside, const Outside& outside) {
  if (certainly_below(position, front)) return inside();
  if (certainly_below(front, position) || (front.bound == 0 && position >= front.value)) return outside();
  return position >= front.value ? hull(outside(), inside()) : hull(inside(), outside());
}

}  // namespace plumbline::reference
