#pragma once
// Two equal elastic bars without friction or stress meet end to end: they touch for 2 L/c under the stress
// -rho c (v1 - v2)/2 and part with their velocities exchanged, free of stress: restitution 1. Exact for linear
// elasticity: during contact the pair is one free bar of length 2 L (d'Alembert).
#include "reference/bar_riemann.hpp"

namespace plumbline::reference {

/// Left bar [left, left + L] at velocity_left, right bar behind a gap at velocity_right < velocity_left, no stress. Any
/// consistent units; all but `left`, the velocities and the gap positive, the gap >= 0. Defaults: York's two bars
/// (York, section A.1.5) in one dimension.
struct BarImpactProblem {
  double youngs_modulus = 1e5;
  double density = 1;
  double area = 1;  // of the energies
  double length = 1.25;
  double left = 1;
  double gap = 0.5;
  double velocity_left = 2;
  double velocity_right = 0;
};

enum class ImpactBar { left, right };

class BarImpact {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit BarImpact(const BarImpactProblem& problem);

  const BarImpactProblem& problem() const { return problem_; }
  Bounded wave_speed() const { return joined_.wave_speed(); }
  Bounded contact_time() const { return touch_; }      // the bars touch
  Bounded contact_duration() const { return lasts_; }  // 2 L/c
  Bounded release_time() const { return touch_ + lasts_; }
  Bounded contact_stress() const;  // negative
  Bounded velocity_after(ImpactBar bar) const;
  Bounded restitution() const { return 1.0; }
  /// x: place in the bar at the start, on `bar`; time >= 0.
  BarState state(ImpactBar bar, double x, double time) const;
  /// The same by the distance from the end that meets the other bar, in the unstretched bar.
  BarState state_from_contact(ImpactBar bar, double distance, double time) const;
  Bounded kinetic_energy(double time) const;
  Bounded strain_energy(double time) const;
  Bounded centre_of_mass_velocity() const;

 private:
  BarState before(ImpactBar bar, Bounded time) const;
  BarState after(ImpactBar bar, Bounded since) const;
  BarState during(ImpactBar bar, Bounded place, Bounded since) const;
  BarState at(ImpactBar bar, Bounded place, double time) const;  // place in both bars without the gap

  BarImpactProblem problem_;
  BarRiemann joined_;  // both bars without the gap, from the contact on
  Bounded touch_, lasts_;
};

}  // namespace plumbline::reference
