#include "reference/equal_stretches.hpp"

#include "reference/argument.hpp"
#include "reference/exponential.hpp"

namespace plumbline::reference {
namespace {

/// e without the cancellation of l^2 - 1.
Bounded strain(Bounded stretch) { return Bounded(0.5) * (stretch - 1.0) * (stretch + 1.0); }

}  // namespace

Bounded EqualStretches::modulus() const {
  return neo_hookean ? Bounded(youngs_modulus) / 3.0 : Bounded(youngs_modulus) / (Bounded(1) - poisson_ratio);
}

Bounded EqualStretches::stress(Bounded l) const {
  if (!neo_hookean) return modulus() * strain(l);  // [Surface 5]
  // 1 - x^3 with x = l^-2 and 1 - x = 2 e/l^2
  const Bounded x = Bounded(1) / (l * l);
  return modulus() * Bounded(2) * strain(l) * x * (Bounded(1) + x + x * x);  // [Surface 5]
}

Bounded EqualStretches::slope(Bounded l) const {
  if (!neo_hookean) return modulus() * l;
  return Bounded(6) * modulus() / power(l, 7);
}

Bounded EqualStretches::energy(Bounded l) const {
  const Bounded e = strain(l);
  if (!neo_hookean) return modulus() * e * e;  // [Surface 5]
  // 2 l^2 + l^-4 - 3 = (1 - x)^2 (x + 2)/x with x = l^-2
  const Bounded x = Bounded(1) / (l * l), less = Bounded(2) * e * x;
  return Bounded(0.5) * modulus() * less * less * (x + 2.0) / x;  // [Surface 5]
}

void check_law(const EqualStretches& law) {
  check_positive("youngs_modulus", law.youngs_modulus);
  check({"poisson_ratio", 0, -1, 0.5, true, false, "", ""}, law.poisson_ratio);
}

}  // namespace plumbline::reference
