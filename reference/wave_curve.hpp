#pragma once
// All states that one gas can reach through one shock or one rarefaction, as functions of the pressure behind it.
// Equations in brackets: E. F. Toro, Riemann Solvers and Numerical Methods for Fluid Dynamics, 3rd ed., 2009, ch. 4.
#include "reference/bounded.hpp"
#include "reference/gas.hpp"

namespace plumbline::reference {

/// `direction` -1: the wave runs to the left into this gas; +1: to the right. For p above the gas's own pressure the
/// wave is a shock, otherwise a rarefaction. All functions of p (>= 0, exact) never decrease.
class WaveCurve {
 public:
  /// `gas` must not be a vacuum; gamma > 1.
  WaveCurve(const GasState& gas, double gamma, int direction);

  bool is_shock(double p) const { return p > gas_.pressure; }
  Bounded velocity_change(double p) const;  // f_K; velocity behind = velocity + direction * f_K
  double slope(double p) const;             // df_K/dp for p > 0, without a bound
  Bounded density(double p) const;
  Bounded sound_speed(double p) const;
  Bounded energy(double p) const;     // specific internal energy
  Bounded mass_flux(double p) const;  // through the shock, by area and time

  Bounded velocity_behind(Bounded p) const;
  Bounded head(Bounded p) const;                    // speed of the shock, or of the rarefaction's first ray
  Bounded tail(Bounded p, Bounded velocity) const;  // speed of the shock, or of the rarefaction's last ray

  const GasState& gas() const { return gas_; }
  Bounded own_sound_speed() const { return a_; }
  Bounded own_energy() const { return e_; }

  /// State on the ray x/t = xi inside the rarefaction, for a gas that is not cold.
  struct Ray {
    Bounded density, velocity, pressure, energy;
  };
  Ray ray(double xi) const;

 private:
  Bounded shock_speed(Bounded p) const;

  GasState gas_;
  double direction_;
  Bounded gamma_, gamma_minus_, gamma_plus_;  // gamma, gamma - 1, gamma + 1
  Bounded A_, B_;                             // [Toro 4.8]
  Bounded a_, e_;                             // sound speed and specific internal energy of the gas at rest
  Bounded escape_;                            // 2 a / (gamma - 1), the speed gained by expanding into a vacuum
};

}  // namespace plumbline::reference
