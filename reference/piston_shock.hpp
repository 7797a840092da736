#pragma once
// A piston is pushed at once, at constant speed, into gas at rest and drives a shock ahead of it. Source: the
// Rankine-Hugoniot conditions, Toro, 3rd ed., section 3.1.3.
#include "reference/gas_flow.hpp"

namespace plumbline::reference {

/// Any consistent units. The face of the piston is at x = piston_velocity t, the gas to its right.
struct PistonShockProblem {
  double piston_velocity = 1;  // > 0
  double density = 1;
  double pressure = 1;  // >= 0; 0 is a cold gas, the shock infinitely strong
  double gamma = 1.4;
};

class PistonShock {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit PistonShock(const PistonShockProblem& problem);

  const PistonShockProblem& problem() const { return problem_; }
  Bounded shock_speed() const { return shock_speed_; }
  Bounded mach_number() const;  // of the shock; its bound is infinite in a cold gas
  Sample behind() const { return behind_; }
  Sample ahead() const { return ahead_; }
  /// time >= 0; at the shock the value ahead of it. Left of the piston there is no gas: the state at its face.
  Sample sample(double position, double time) const;

 private:
  PistonShockProblem problem_;
  Bounded sound_speed_, shock_speed_;
  Sample ahead_, behind_;
};

}  // namespace plumbline::reference
