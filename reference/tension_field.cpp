#include "reference/tension_field.hpp"

#include "reference/argument.hpp"
#include "reference/circle.hpp"

namespace plumbline::reference {
namespace {

/// (l^2 - 1)/2 without its cancellation.
Bounded strain(Bounded stretch) { return Bounded(0.5) * (stretch - 1.0) * (stretch + 1.0); }

/// The largest value of a number that cannot be negative, zero for certain where all of its interval is below zero.
Bounded not_negative(Bounded x) {
  if (highest(x) <= 0) return {0, 0};
  return x.value >= 0 ? x : Bounded(0, highest(x));
}

}  // namespace

// e1 >= e2, so S1 >= S2. Where S2 is free it is (e2 + nu e1) E/(1 - nu^2), and cut off at zero; then S1 = E e1 + nu S2, which is
// where the slope of the maximum along S1 vanishes.
TensionField::TensionField(const TensionFieldProblem& problem) : problem_(problem) {
  check_positive("youngs_modulus", problem.youngs_modulus);
  check({"poisson_ratio", 0, -1, 0.5, true, false, "", ""}, problem.poisson_ratio);
  check_positive("thickness", problem.thickness);
  check_positive("density", problem.density);
  check_positive("stretch", problem.stretch);
  check({"shear", 0, 0, 1, false, true, "", ""}, problem.shear);
  check_positive("half_side", problem.half_side);
  const Bounded E(problem.youngs_modulus), nu(problem.poisson_ratio), one(1);
  longer_ = Bounded(problem.stretch) * (one + problem.shear);
  shorter_ = Bounded(problem.stretch) * (one - problem.shear);
  const Bounded e1 = strain(longer_), e2 = strain(shorter_);
  across_ = not_negative(E * (e2 + nu * e1) / ((one - nu) * (one + nu)));
  along_ = not_negative(E * e1 + nu * across_);
  const Bounded least = (along_ * along_ + across_ * across_ - Bounded(2) * nu * along_ * across_) / (Bounded(2) * E);
  energy_ = not_negative(along_ * e1 + across_ * e2 - least);  // [Surface 12]
}

Bounded TensionField::resultant_along() const { return Bounded(problem_.thickness) * along_ * longer_ / shorter_; }

Bounded TensionField::resultant_across() const { return Bounded(problem_.thickness) * across_ * shorter_ / longer_; }

Bounded TensionField::omega(int along, int across) const {
  check({"along", 0, 1, 1000, false, false, "", ""}, along);
  check({"across", 0, 1, 1000, false, false, "", ""}, across);
  const Bounded k = pi / (Bounded(2) * problem_.half_side), k1 = k * along, k2 = k * across;
  return sqrt((along_ * k1 * k1 + across_ * k2 * k2) / problem_.density);  // [Surface 13]
}

}  // namespace plumbline::reference
