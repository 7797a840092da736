#include "reference/bar_stability.hpp"

#include "reference/argument.hpp"
#include "reference/elementary.hpp"

namespace plumbline::reference {
namespace {

// 4 N (1 - N), 0 at the sides of a cell, 1 at its centre.
Bounded spread_of(double weight) {
  check_within("weight", weight, 0, 1);
  return Bounded(4) * weight * (Bounded(1) - weight);
}

// max of s (1 - 4 N (1 - N) s) over 0 <= s <= 1. Either branch is right at the value where they meet.
Bounded greatest_stiffness(double weight) {
  const Bounded spread = spread_of(weight), inward = Bounded(1) - Bounded(2) * weight;
  if (spread.value < 0.5) return inward * inward;
  return Bounded(0.25) / spread;
}

// Of the real roots of z^2 - (2 - x) z + d with x >= 2, the one furthest from zero.
Bounded furthest_root(Bounded x, Bounded determinant) {
  const Bounded half = (x - 2) / 2;
  return half + sqrt(half * half - determinant);
}

}  // namespace

Bounded frozen_courant_limit(StressUpdate update, double weight) {
  const Bounded spread = spread_of(weight);
  if (update == StressUpdate::last) return Bounded(1) / sqrt(Bounded(1) + spread);  // [Stability 2]
  if (spread.value >= 0.5) return Bounded(2) * sqrt(spread);                        // [Stability 1]
  return Bounded(1) / abs(Bounded(1) - Bounded(2) * weight);
}

// Unstable roots are real, the greater x the further from zero; those of StressUpdate::last at s = 1.
Bounded frozen_growth(StressUpdate update, double weight, double courant) {
  check_positive("courant", courant);
  if (courant <= lowest(frozen_courant_limit(update, weight))) return 1;
  const Bounded square = Bounded(4) * courant * courant;
  Bounded growth;
  if (update == StressUpdate::last) {
    growth = furthest_root(square, Bounded(1) - square * spread_of(weight));
  } else {
    growth = furthest_root(square * greatest_stiffness(weight), 1);
  }
  return {std::max(growth.value, 1.0), growth.bound};
}

Bounded corner_courant_limit(int dimensions) {
  check_within("dimensions", dimensions, 1, 3);
  return Bounded(1) / sqrt(Bounded(dimensions));  // [Stability 3]
}

Bounded york_courant_limit(double weight) {
  return Bounded(1) / sqrt(Bounded(1) - Bounded(0.75) * spread_of(weight));  // [York 8.24, 8.36, 8.41]
}

}  // namespace plumbline::reference
