#pragma once
// Breathing of an elastic ring around a gas at rest: axisymmetric, small, plane, held out of the plane. Derived here.
//
// The ring of radius R, mass m_l per length there and tension T(R) is pressed outward by the gas: per radian
//   m_l R xi'' = p R - T,   at rest T = p R,   so   m_l xi'' = -k_s xi + dp,   k_s = (dT/dR - T/R)/R.
// The gas: rho xi_tt = -dp_r, dp = -rho c^2 div xi, c^2 = gamma p/rho, in a disc: with k = w/c
//   xi_r(r) = xi J1(k r)/J1(k R),   dp(r) = -rho w^2 xi J0(k r)/(k J1(k R)),
//   m_l w^2 = k_s + rho w^2 J0(k R)/(k J1(k R)),      for slow motion dp = -2 gamma p xi/R.
// With z = k R: z J0/J1 = 2 - sum 2 z^2/(j^2 - z^2) over the zeros j of J1; divided by z the right side less
// the left falls between neighbouring zeros, so the n-th frequency lies between the zeros n - 1 and n (zero 0 being z = 0).
//
// The law of the ring, with E' = E/(1 - nu^2) [York 5.12] and eps = p R/(E' t) at rest:
//   segments     T = E' t (R/R0 - 1), t the unstretched thickness:   k_s = (E' t/R0 - E' t (1/R0 - 1/R))/R = E' t/R^2,
//   accumulated  the stress E' eps with d eps = dR/R acts in points of constant volume V: T = E' V ln(R/R0)/(2 pi R).
//                t = V/(2 pi R) is the thickness at rest, the point's volume over its length there:
//                k_s = E' t (1 - 2 eps)/R^2,
//   bare         k_s = E' t/R^2 of a ring without tension, whatever the pressure.
// So the prestress cancels for segments and softens the ring for the accumulated strain.
#include "reference/bounded.hpp"

namespace plumbline::reference {

enum class RingLaw { segments, accumulated, bare };

/// SI units, per depth out of the plane. All positive, gamma > 1, 0 <= nu < 1/2 (smaller than 1/2 in size).
/// The default has the mass of gas of York's bag (section 6.2) in a soft ring.
struct GasRingProblem {
  double youngs_modulus = 2e3;                                       // E, Pa
  double poisson_ratio = 0.3;                                        // nu
  double thickness = 0.1;                                            // t, m
  double radius = 1.4;                                               // R, of the ring at rest under the pressure, m
  double line_mass = 0.05;                                           // m_l, kg/m^2 (per length of the ring at rest)
  double pressure = 30.80;                                           // p inside, nothing outside, Pa
  double gas_density = 0.47463 / (0.78539816339744831 * 1.4 * 1.4);  // rho, kg/m^3
  double gamma = 1.4;
  RingLaw law = RingLaw::segments;
  double velocity = 1;  // of the ring at t = 0 where it starts with a mode, m/s, positive outward
};

/// Modes are numbered from 1 to `most_mode`: ParameterError "mode" beyond.
class GasRing {
 public:
  static constexpr int most_mode = 1000;

  /// Throws ParameterError with the key.
  explicit GasRing(const GasRingProblem& problem);

  Bounded plane_modulus() const { return modulus_; }     // E', Pa
  Bounded strain() const { return strain_; }             // eps at rest, 0 for the bare law
  Bounded tension() const;                               // T = p R at rest, N/m
  Bounded unstretched_radius() const;                    // R0, m
  Bounded ring_stiffness() const { return stiffness_; }  // k_s, Pa/m
  Bounded sound_speed() const { return speed_; }         // c, m/s
  Bounded dry_omega() const;                             // sqrt(k_s/m_l): no gas; 0 if k_s < 0
  Bounded quasi_static_omega() const;                    // the gas a spring without mass, 2 gamma p/R

  Bounded wavenumber(int n = 1) const;  // z = k R
  Bounded omega(int n = 1) const;       // rad/s
  Bounded period(int n = 1) const;
  Bounded modal_mass(int n = 1) const;  // of ring and gas, whole circle, the ring's displacement being 1, kg/m

  /// At the radius r in [0, R], per displacement of the ring: the gas's radial displacement and its pressure, Pa/m.
  /// Throws ParameterError "radius".
  Bounded shape(double r, int n = 1) const;
  Bounded pressure_shape(double r, int n = 1) const;

  /// Ring and gas start at rest's place with the velocity of mode n (`velocity` times shape): of the ring, m, m/s; the
  /// energy, J/m (whole circle). Displacement and velocity of the gas are shape(r) times the ring's.
  Bounded displacement(double time, int n = 1) const;
  Bounded velocity(double time, int n = 1) const;
  Bounded pressure_change(double r, double time, int n = 1) const;  // Pa
  Bounded mode_energy(int n = 1) const;

 private:
  GasRingProblem problem_;
  Bounded modulus_, strain_, stiffness_, speed_;
  Bounded mass_, spring_;  // m_l/(rho R), k_s R/(rho c^2)
};

}  // namespace plumbline::reference
