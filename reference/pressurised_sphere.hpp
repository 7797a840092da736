#pragma once
// A thin sphere of radius R0, thickness t and density rho at rest, blown up by a constant pressure p, and its
// breathing. Derived here: l is the stretch of every tangent, the radius is l R0, S and W as in equal_stretches.hpp.
//   At rest:  p = 2 t S/(l R0),  force per length N = t S = p R/2 (Laplace). [Surface 6]
//   Breathing:  rho t R0 l'' = p l^2 - 2 t l S/R0: a mass rho t R0^2 in the potential Phi = t W - p R0 l^3/3, per area
//   at rest. About the stretch l0 that p balances:  w^2 = Phi''/(rho t R0^2) = 2 (l S' - S)/(rho R0^2). [Surface 7]
//     unstretched:  w^2 = 2 E/((1 - nu) rho R0^2);  neo-Hookean: stable below l0 = 7^(1/6), where p is the largest.
//   Released from rest at a, turning at b with Phi(b) = Phi(a): Phi(a) - Phi(l) = (a - l)(l - b) Q(l) with Q the second
//   divided difference Phi[a, b, l], and with l = (a + b)/2 + (a - b)/2 cos(theta)
//     T = int_0^pi dtheta sqrt(2 rho t R0^2/Q), [Surface 8]
//   periodic and smooth, so that the midpoint rule in theta (that of Gauss and Chebyshev) converges exponentially. Its
//   bound is the change from n to 2 n places, and rounding.
// Differences of the terms of Phi are taken by their formulas, so small amplitudes lose no digits.
#include "reference/equal_stretches.hpp"

namespace plumbline::reference {

/// Any consistent units; all positive, -1 < nu <= 1/2.
struct PressurisedSphereProblem {
  double youngs_modulus = 1;
  double poisson_ratio = 0.3;  // not of the neo-Hookean
  double thickness = 0.01;     // t at rest
  double density = 1;          // rho at rest
  double radius = 1;           // R0 at rest
  double stretch = 1.05;       // l0, of the sphere at rest under its pressure; below 1: pressed from outside
  bool neo_hookean = false;
};

class PressurisedSphere {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit PressurisedSphere(const PressurisedSphereProblem& problem = {});

  const PressurisedSphereProblem& problem() const { return problem_; }
  /// At rest at any stretch > 0; ParameterError "stretch".
  Bounded pressure(double stretch) const;
  Bounded resultant(double stretch) const;  // N, force per length
  Bounded stress(double stretch) const;     // S

  /// Of breathing about the problem's stretch under its pressure.
  Bounded pressure() const { return pressure(problem_.stretch); }
  Bounded resultant() const { return resultant(problem_.stretch); }
  Bounded omega() const;  // small; 0 where the equilibrium is unstable
  /// The stretch at which the sphere turns, released from rest at stretch + amplitude (of any sign).
  /// ParameterError "amplitude" if there is no such stretch.
  Bounded turning_stretch(double amplitude) const;
  Bounded period(double amplitude) const;  // amplitude 0: 2 pi/omega

 private:
  Bounded first_difference(Bounded a, Bounded b) const;              // Phi[a, b]/t
  Bounded second_difference(Bounded a, Bounded b, Bounded c) const;  // Phi[a, b, c]/t
  double furthest(double amplitude) const;

  PressurisedSphereProblem problem_;
  EqualStretches law_;
  Bounded push_;  // p R0/t
};

}  // namespace plumbline::reference
