#pragma once
// Circular sheets of plane stress after St. Venant and Kirchhoff, flat and without stress at rest, under the pressure p
// on their deformed surface; finite strains and slopes. Lengths scale with the radius a at rest and stresses with E:
// all depends on the load q = p a/(E t) and on nu. Equilibrium: taut_sheet.hpp, derived there. The strain in the middle
// is the one for which the rim is as it must be (shooting).
//
// CircularMembrane: the rim is clamped at its place, r(a) = a. Small loads are Hencky's problem (H. Hencky, Z. Math.
//   Phys. 63 (1915) 311; W. B. Fichter, NASA TP-3658 (1997)): middle height 0.653 a q^(1/3), middle stress
//   0.431 E q^(2/3) for nu = 0.3.
// MylarBalloon: two sheets, sewn together at their free rims. The law is one-way: where S2 would be negative,
//   e2 + nu e1 < 0, the sheet wrinkles along its meridians and carries S1 = E e1 alone (tension field: A. C. Pipkin,
//   IMA J. Appl. Math. 36 (1986) 85). There the force along all meridians, s S1 l1 = N, is the same everywhere, and as
//   the sheets meet upright at the radius R, N = q R^2/2 (units of taut_sheet.hpp). With r = R cos(theta), theta = 0 at
//   the seam,
//     l1 (l1^2 - 1)/2 = N/s,   arc from the seam = int_s^1 l1 ds = R int_0^theta dtheta/sqrt(1 + cos^2),
//     height = R int cos^2/sqrt(1 + cos^2),   half of the volume = pi R^3 int cos^4/sqrt(1 + cos^2). [Surface 11]
//   Loads to 0: the inextensible balloon, theta to pi/2 and arc a (W. Paulsen, Amer. Math. Monthly 101 (1994) 953).
//
// Bounds: steps and shooting are done twice, the second time with half of the step, until the answer stays; the bound
// is twice the last change of every number, and rounding of each step.
#include <memory>

#include "reference/bounded.hpp"

namespace plumbline::reference {

struct CircularMembraneProblem {
  double load = 0.05;          // q = p a/(E t), 1e-9 to 1
  double poisson_ratio = 0.3;  // nu, 0 to 1/2
  double radius = 1;           // a, at rest, > 0
};

/// Where a point of the sheet is that was at the distance s from the middle, and what pulls there.
struct MembranePoint {
  Bounded radius;            // r
  Bounded height;            // above the rim
  Bounded meridian_stress;   // S1/E, second Piola and Kirchhoff
  Bounded hoop_stress;       // S2/E
  Bounded meridian_stretch;  // l1
};

/// Throws ParameterError with the key of a value out of range.
void check_circular_membrane(const CircularMembraneProblem& problem);

class CircularMembrane {
 public:
  /// Throws ParameterError with the key of a value out of range, with "load" if the sheet overhangs its rim (q above
  /// 0.8 for nu = 0).
  explicit CircularMembrane(const CircularMembraneProblem& problem = {});

  Bounded height() const;  // of the middle
  Bounded stress() const;  // S1/E = S2/E in the middle
  Bounded volume() const;  // below the sheet
  /// 0 <= s <= radius; ParameterError "position".
  MembranePoint at(double s) const;

 private:
  struct Solution;
  double radius_;
  std::shared_ptr<const Solution> solution_;
};

class MylarBalloon {
 public:
  /// Throws ParameterError with the key of a value out of range, with "load" if the balloon is taut at its seam (q
  /// above about 0.75).
  explicit MylarBalloon(const CircularMembraneProblem& problem = {0.01, 0.3, 1});

  Bounded rim_radius() const;   // R
  Bounded half_height() const;  // of the middle above the seam
  Bounded volume() const;       // of the whole balloon
  Bounded stress() const;       // S1/E = S2/E in the middle
  Bounded taut_radius() const;  // s where the wrinkles begin
  /// 0 <= s <= radius, of the upper sheet; ParameterError "position".
  MembranePoint at(double s) const;

 private:
  struct Solution;
  double radius_;
  std::shared_ptr<const Solution> solution_;
};

}  // namespace plumbline::reference
