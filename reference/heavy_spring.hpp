#pragma once
// A mass hanging from a spring that has mass: longitudinal vibration of a bar, fixed above, with a point mass below,
// gravity suddenly applied to both. Tag: [Rao 8.3] is the bar with a mass at its end in S. S. Rao, Mechanical
// Vibrations, 5th ed., 2011, section 8.3; the participation factors are derived here.
//
// With c^2 = E/rho, k = E A/L, mu = rho A L/m (mass of the bar over the point mass):
//   rho u_tt = E u_xx + rho g,   u(0) = 0,   m u_tt(L) = m g - E A u_x(L),   u = u_t = 0 at t = 0.
// Modes sin(x_n z/L) with frequencies w_n = x_n c/L are orthogonal in rho A int . dz + m (.)(L) where
//   x tan x = mu,   (n - 1) pi < x_n < (n - 1/2) pi,
// from the boundary condition at L. The load on mode n, rho A int sin + m sin x_n, is rho A L/x_n by that equation,
// the modal mass is rho A L (1/2 + sin(2 x_n)/(4 x_n)), and with tan x_n = mu/x_n the lower end moves by
//   d(t) = D - sum b_n cos(w_n t),   D = m g/k (1 + mu/2)  (the sum of all b_n),
//   b_n = (-1)^(n-1) 2 m g/k mu^2 sqrt(x_n^2 + mu^2) / (x_n^3 (x_n^2 + mu^2 + mu)).
// |b_n| <= 2 m g/k mu^2 min(x_n^-4, x_n^-3/mu), which bounds the part of the sum that is left out.
#include <vector>

#include "reference/bounded.hpp"
#include "reference/spring.hpp"

namespace plumbline::reference {

/// The n-th root (n >= 1) of x tan x = mu, mu > 0. Throws std::invalid_argument for n < 1.
Bounded tip_mass_root(Bounded mu, int n);

/// Density 0 gives the massless spring. Signs as in MasslessSpring.
class HeavySpring {
 public:
  explicit HeavySpring(const SpringProblem& problem);

  Bounded mass_ratio() const { return mu_; }  // spring over point mass
  Bounded omega(int n = 1) const;             // n-th natural frequency; the massless spring has only n = 1
  Bounded period() const;
  Bounded static_displacement() const { return rest_; }
  Bounded displacement(double time) const;
  Bounded velocity(double time) const;
  /// The first extremum of the displacement of the lower end (the largest one for a light spring).
  Bounded max_displacement() const;

 private:
  struct Mode {
    Bounded amplitude, omega;
  };
  void choose_modes();
  double left_out(int power) const;  // bounds the sum of |b_n| w_n^power over the modes left out; power 0, 1, 2

  SpringProblem problem_;
  MasslessSpring massless_;
  Bounded mu_, rest_, wave_rate_;  // wave_rate = c/L
  std::vector<Mode> modes_;
};

}  // namespace plumbline::reference
