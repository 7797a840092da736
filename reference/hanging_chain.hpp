#pragma once
// Small transverse vibration of a heavy chain that hangs from its upper end: with s the distance from the free end the
// tension is proportional to s, and y_tt = g (s y_s)_s has the modes
//   y = A J0(2 w sqrt(s/g)) cos wt,   J0(2 w sqrt(L/g)) = 0   (D. Bernoulli; H. Lamb, Hydrodynamics, art. 195: canal).
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// One mode, released from rest: all positive, `amplitude` (at the free end) any sign. Any consistent units. The theory
/// is that of small slopes: they are largest at the free end, amplitude w^2/g.
struct HangingChainProblem {
  double length = 1;
  double gravity = 9.81;
  double line_density = 1;  // mass per length
  int mode = 1;             // 1 to 1000
  double amplitude = 0.01;
};

/// All positions s are distances from the free end, 0 <= s <= length; times have any sign.
class HangingChain {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit HangingChain(const HangingChainProblem& problem);

  const HangingChainProblem& problem() const { return problem_; }
  Bounded zero() const { return zero_; }  // of J0
  Bounded omega() const { return omega_; }
  Bounded period() const;
  Bounded shape(double s) const;                      // 1 at the free end, 0 at the support
  Bounded displacement(double s, double time) const;  // transverse
  Bounded velocity(double s, double time) const;
  Bounded slope(double s, double time) const;  // d displacement/ds
  Bounded tension(double s) const;             // a force
  Bounded energy() const;                      // kinetic + potential
  Bounded kinetic_energy(double time) const;
  Bounded potential_energy(double time) const;

 private:
  HangingChainProblem problem_;
  Bounded zero_, omega_;
};

/// w_n = j_{0,n}/2 sqrt(g/L).
Bounded hanging_chain_omega(double length, double gravity, int mode);

}  // namespace plumbline::reference
