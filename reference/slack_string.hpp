#pragma once
// A mass on an elastic string without mass that starts slack (York, section 5.6): free fall by the slack, half an
// oscillation and a bit while the string is taut, release, free flight back to the start, and again without end.
//
// With w^2 = k/m, rest r = m g/k of the taut string and v the speed after falling by the slack, the taut motion
//   d = slack + r (1 - cos wt) + v/w sin wt
// is back at d = slack after T = (2/w) (pi - atan(v w/g)), with the speed -v: the motion has the period 2 v/g + T.
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// A string of Young's modulus E, section A and unstretched length L hangs from a support; a point mass at its lower
/// end starts at rest, `slack` above the place where the string becomes straight. Any consistent units; all positive,
/// the slack may be 0. Defaults: (York, section 5.6), six points of ten with the strain -0.1 each.
struct SlackStringProblem {
  double youngs_modulus = 1e6;
  double area = 0.1;
  double length = 0.3;
  double mass = 3.33;
  double gravity = 250;
  double slack = 0.02;
};

/// Displacement, velocity: positive along gravity, from the place of the start.
class SlackString {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit SlackString(const SlackStringProblem& problem);

  const SlackStringProblem& problem() const { return problem_; }
  Bounded stiffness() const { return stiffness_; }
  Bounded omega() const { return omega_; }
  Bounded taut_time() const { return fall_; }             // the string becomes taut
  Bounded release_time() const { return fall_ + taut_; }  // and slack again
  Bounded apex_time() const { return period_; }           // back at the start, at rest: the period of all
  Bounded taut_speed() const { return speed_; }           // when the string becomes taut, and at release
  Bounded max_displacement() const;                       // at the lowest point
  Bounded max_tension() const;                            // there

  // At any time >= 0.
  Bounded displacement(double time) const;
  Bounded velocity(double time) const;
  Bounded tension(double time) const;  // a force, >= 0
  Bounded kinetic_energy(double time) const;
  Bounded string_energy(double time) const;

 private:
  struct State {
    Bounded displacement, velocity, stretch;
  };
  State state(double time) const;
  State falling(Bounded time) const;
  State taut(Bounded since) const;

  SlackStringProblem problem_;
  Bounded stiffness_, omega_, rest_, speed_, fall_, taut_, period_;
};

}  // namespace plumbline::reference
