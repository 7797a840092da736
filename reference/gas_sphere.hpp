#pragma once
// Breathing of a thin sphere around a gas at rest: spherical, small. Derived here; at rest PressurisedSphere.
//
// The sheet has the mass rho t/l^2 per area as it stands at rest under the pressure p, at the radius R = l R0:
//   rho t/l^2 xi'' = -k_s xi + dp,   k_s = 2 t (l S' - S)/(l^2 R0^2)                                       [Surface 7]
// The gas, of density rho_g there: rho_g xi_tt = -dp_r, dp = -rho_g c^2 div xi, c^2 = gamma p/rho_g, within a sphere: k = w/c
//   xi_r(r) = xi j1(k r)/j1(k R),   dp(r) = -rho_g w^2 xi j0(k r)/(k j1(k R)),   j0 = sin z/z, j1 = sin z/z^2 - cos z/z,
//   rho t/l^2 w^2 = k_s + rho_g w^2 j0(k R)/(k j1(k R)),      for slow motion dp = -3 gamma p xi/R.        [Surface 17]
// With z = k R: z j0/j1 = 3 - sum 2 z^2/(j^2 - z^2) over the zeros j of j1, tan j = j; divided by z the right side less the left falls
// between neighbouring zeros, so the n-th frequency lies between the zeros n - 1 and n (zero 0 being z = 0).
#include "reference/pressurised_sphere.hpp"

namespace plumbline::reference {

/// Gas density > 0, gamma > 1; the sheet is stretched at rest, l > 1.
struct GasSphereProblem {
  PressurisedSphereProblem sheet{.stretch = 1.2};
  double gas_density = 0.01;  // rho_g inside at rest, nothing outside, kg/m^3
  double gamma = 1.4;
  double velocity = 1;  // of the sheet at t = 0 where it starts with a mode, m/s, positive outward
};

/// Modes are numbered from 1 to `most_mode`: ParameterError "mode" beyond.
class GasSphere {
 public:
  static constexpr int most_mode = 1000;

  /// Throws ParameterError with the key.
  explicit GasSphere(const GasSphereProblem& problem = {});

  Bounded radius() const { return radius_; }                // R at rest under the pressure, m
  Bounded pressure() const { return pressure_; }            // p, Pa
  Bounded resultant() const { return sheet_.resultant(); }  // N = p R/2, N/m
  Bounded sheet_stiffness() const { return stiffness_; }    // k_s, Pa/m
  Bounded sound_speed() const { return speed_; }            // c, m/s
  Bounded dry_omega() const { return sheet_.omega(); }      // the pressure constant; 0 where that is unstable
  Bounded quasi_static_omega() const;                       // the gas a spring without mass, 3 gamma p/R

  Bounded wavenumber(int n = 1) const;  // z = k R
  Bounded omega(int n = 1) const;       // rad/s

  /// At the radius r in [0, R], per displacement of the sheet: the gas's radial displacement and its pressure, Pa/m.
  /// Throws ParameterError "radius".
  Bounded shape(double r, int n = 1) const;
  Bounded pressure_shape(double r, int n = 1) const;

  /// Sheet and gas start at rest's place with the velocity of mode n: of the sheet, m/s. ParameterError "time".
  Bounded velocity(double time, int n = 1) const;

 private:
  GasSphereProblem problem_;
  PressurisedSphere sheet_;
  Bounded radius_, pressure_, mass_per_area_, stiffness_, speed_;
  Bounded mass_, spring_;  // rho t/(l^2 rho_g R), k_s R/(rho_g c^2)
};

}  // namespace plumbline::reference
