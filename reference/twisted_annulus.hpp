#pragma once
// A flat ring of membrane that carries no compression, clamped at both rims, one of which is turned: it wrinkles everywhere (tension
// field: E. Reissner, Proc. 5th Int. Congr. Appl. Mech. (1938) 88; M. Stein, J. M. Hedgepeth, NASA TN D-813 (1961); of finite strain and
// St. Venant and Kirchhoff's law derived here). A line of material along the tension has stretch l and stress S1 = E (l^2 - 1)/2; nothing
// else is stressed. Where n is its direction at rest and m that in the twisted ring, equilibrium of the nominal stress S1 l m (x) n is
//   dm/dn = 0,  div(S1 l n) = 0:
// lines of tension are straight in the twisted ring, and each pulls alike along it. With symmetry all are as far from the axis, p, and with
// alpha and beta the angles of n and m from the radius, (R, r) the radii at rest and twisted, (Phi, Phi + phi) their angles,
//   r sin beta = p,  R l sin alpha = p,  R S1 l cos alpha = E kappa, [Annulus 1]
// so that q = l cos alpha is a root, and the only positive one, of
//   q^3 - g^2 q = 2 kappa/R,  g^2 = 1 - p^2/R^2. [Annulus 2]
// With u = (r^2 - p^2)^(1/2) along the line and U = (R^2 - p^2)^(1/2), and since g would be q without strain,
//   u' = l^2/q:  u - U = 2 kappa I_1,  I_1 = int (1 - p^2/(R^2 q g)) / (R q (q + g)) dR, [Annulus 3]
//   phi = atan(u/p) - atan(U/p) + 2 kappa p I_2 + const,  I_2 = int dR/(R^3 q^2 g (q + g)). [Annulus 4]
// Between rims of radii a and b that keep them I_1 is 0, which for no kappa is
//   log(x/(1 - x)) - 1/(1 - x)  alike for x = p^2/a^2 and p^2/b^2, [Annulus 5]
// and 2 kappa p I_2 is the twist. Torque and energy:
//   T = 2 pi t E kappa p,  W = pi t E int e1^2 R dR,  e1 = (l^2 - 1)/2. [Annulus 6]
// Across the lines, where the sheet is free to shorten, its stretch is l2 = l u/(R q); it is wrinkled where
//   (l2^2 - 1)/2 + nu e1 < 0. [Annulus 7]
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// Any consistent units; all positive but nu, 0 <= nu <= 1/2.
struct TwistedAnnulusProblem {
  double youngs_modulus = 1;
  double poisson_ratio = 0.1;
  double thickness = 0.01;    // t at rest
  double inner_radius = 0.5;  // a
  double outer_radius = 1;    // b > a, to 50 a
  double twist = 0.05;        // rad, of the outer rim against the inner one
};

struct AnnulusPoint {
  Bounded radius;  // r
  Bounded turned;  // phi, rad: -twist at the inner rim, 0 at the outer one
  Bounded along;   // l
  Bounded across;  // l2
  Bounded stress;  // S1
  Bounded rest;    // alpha, rad
  Bounded now;     // beta, rad
};

class TwistedAnnulus {
 public:
  /// Throws ParameterError with the key of a value out of range: "twist" where lines of tension would meet the inner rim, and
  /// "poisson_ratio" where the sheet is taut across them at one of 65 radii.
  explicit TwistedAnnulus(const TwistedAnnulusProblem& problem = {});

  Bounded arm() const { return arm_; }  // p
  Bounded pull() const;                 // t E kappa: force of the lines that start in a radian of angle at rest
  Bounded torque() const;
  Bounded energy() const;
  /// At rest at `position`, a <= position <= b; ParameterError.
  AnnulusPoint at(double position) const;

 private:
  void bound_roots(double p, double kappa);

  TwistedAnnulusProblem problem_;
  Bounded arm_, kappa_;
};

}  // namespace plumbline::reference
