#pragma once
// A thin sheet stretched by l along both of its tangents: its second Piola stress S, and what it stores, W per volume
// at rest. With the thickness t at rest, t S is the force per length as the sheet is now, along every direction and
// whatever l is. dW/dl = 2 l S.
//   plane stress of St. Venant and Kirchhoff, e = (l^2 - 1)/2:  S = E e/(1 - nu),  W = E e^2/(1 - nu),
//   incompressible neo-Hookean, mu = E/3:  S = mu (1 - l^-6),  W = mu (2 l^2 + l^-4 - 3)/2. [Surface 5]
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// E > 0, -1 < nu <= 1/2 (not of the neo-Hookean).
struct EqualStretches {
  double youngs_modulus = 1;  // E, Pa
  double poisson_ratio = 0.3;
  bool neo_hookean = false;

  Bounded modulus() const;  // E/(1 - nu), or mu
  Bounded stress(Bounded stretch) const;
  Bounded slope(Bounded stretch) const;   // dS/dl
  Bounded energy(Bounded stretch) const;  // W
};

/// Throws ParameterError with the key.
void check_law(const EqualStretches& law);

}  // namespace plumbline::reference
