#pragma once
// A sheet of St. Venant and Kirchhoff in plane stress that wrinkles (A. C. Pipkin, IMA J. Appl. Math. 36 (1986) 85, doi
// 10.1093/imamat/36.1.85), stretched by l and sheared by s: with axes at 45 degrees to those of the shear its stretches are
//   l1 = l (1 + s),  l2 = l (1 - s),  e_a = (l_a^2 - 1)/2.
// Its energy W per volume at rest is the largest that stresses without compression give,
//   W = max over S1, S2 >= 0 of  S1 e1 + S2 e2 - (S1^2 + S2^2 - 2 nu S1 S2)/(2 E), [Surface 12]
// and the stresses are those where it is attained: both positive (taut), S2 = 0 (wrinkled) or none (slack). Forces per length of the
// sheet as it is: N1 = t S1 l1/l2, N2 = t S2 l2/l1.
// Small transverse vibration of a rectangle with fixed edges, sides 2 a at rest along both axes,
//   w = sin(m pi (X1/(2 a) + 1/2)) sin(n pi (X2/(2 a) + 1/2)) cos(omega t),  X at rest,
//   rho omega^2 = S1 (m pi/(2 a))^2 + S2 (n pi/(2 a))^2: [Surface 13]
// where it is wrinkled each line along axis 1 swings by itself, as a string.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Any consistent units; all positive but the shear, -1 < nu <= 1/2, 0 <= shear < 1.
struct TensionFieldProblem {
  double youngs_modulus = 1;
  double poisson_ratio = 0.3;
  double thickness = 0.01;  // t at rest
  double density = 1;       // rho at rest
  double stretch = 1;       // l
  double shear = 0.05;      // s
  double half_side = 1;     // a, of a square at rest
};

class TensionField {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit TensionField(const TensionFieldProblem& problem = {});

  Bounded energy() const { return energy_; }         // W, per volume at rest
  Bounded stress_along() const { return along_; }    // S1
  Bounded stress_across() const { return across_; }  // S2
  Bounded resultant_along() const;                   // N1
  Bounded resultant_across() const;                  // N2
  /// Modes 1 to 1000; ParameterError "along" or "across".
  Bounded omega(int along, int across) const;

 private:
  TensionFieldProblem problem_;
  Bounded longer_, shorter_;  // l1, l2
  Bounded energy_, along_, across_;
};

}  // namespace plumbline::reference
