#pragma once
// A ring without tension around a gas under pressure, let go: it breathes about its equilibrium in all modes of
// gas_ring. Small motions about the equilibrium; derived here.
//
// Gas and ring start at rest, the gas uniform with pressure p0 and density rho0, the ring unstretched at R0, nothing
// outside. Equilibrium, the gas compressed and expanded adiabatically:
//   p R = E' t (R/R0 - 1),   p = p0 (R0/R)^(2 gamma).
// Seen from there everything starts displaced by -(R - R0) r/R. With the modes of gas_ring (1 at the ring, modal mass
// M_n, z = k R, q = J0/J1, mu = m_l/(rho R)) that is -(R - R0) sum a_n times mode n,
//   a_n = (2 mu + 2 (2/z - q)/z) / (2 mu + 1 + q^2 - 2 q/z),
// as int r^2 J1(k r)/J1(k R) dr = R^2 J2/(k J1), J2/J1 = 2/z - q. At the ring the sum of all a_n is 1, and
//   R(t) - R0 = (R - R0) (1 - sum a_n cos(w_n t)).
// What the linear modes do not know is of the order (R - R0)/R of the motion; the bounds do not cover it.
#include <vector>

#include "reference/bounded.hpp"
#include "reference/gas_ring.hpp"

namespace plumbline::reference {

/// SI units, per depth out of the plane. All positive, gamma > 1, 0 <= nu < 1/2.
struct ReleasedRingProblem {
  double youngs_modulus = 1e6;    // E, Pa
  double poisson_ratio = 0.3;     // nu
  double thickness = 0.1;         // t, m, unstretched
  double membrane_density = 0.5;  // kg/m^3, unstretched
  double radius = 1;              // R0, m
  double pressure = 1000;         // p0, Pa
  double gas_density = 0.025;     // rho0, kg/m^3
  double gamma = 1.4;
};

class ReleasedRing {
 public:
  static constexpr int modes = 30;

  /// Throws ParameterError with the key.
  explicit ReleasedRing(const ReleasedRingProblem& problem);

  double equilibrium_radius() const { return at_rest_.radius; }                            // R, m
  double equilibrium_pressure() const { return at_rest_.pressure; }                        // p, Pa
  double equilibrium_gas_density() const { return at_rest_.gas_density; }                  // rho, kg/m^3
  double equilibrium_line_mass() const { return at_rest_.line_mass; }                      // m_l, kg/m^2
  double strain() const { return at_rest_.radius / problem_.radius - 1; }                  // (R - R0)/R0
  Bounded omega(int n) const { return modes_.at(static_cast<std::size_t>(n - 1)).omega; }  // n <= modes
  Bounded share(int n) const { return modes_.at(static_cast<std::size_t>(n - 1)).share; }  // a_n
  double left_out() const { return left_out_; }  // bounds what the modes left out add to the sum

  /// R(t) - R0, m. `time` >= 0.
  Bounded radius_change(double time) const;

 private:
  struct Mode {
    Bounded omega, share;
  };
  ReleasedRingProblem problem_;
  GasRingProblem at_rest_;
  std::vector<Mode> modes_;
  double left_out_ = 0;
};

}  // namespace plumbline::reference
