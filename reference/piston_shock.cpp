#include "reference/piston_shock.hpp"

namespace plumbline::reference {

PistonShock::PistonShock(const PistonShockProblem& problem) : problem_(problem) {
  check_positive("piston_velocity", problem.piston_velocity);
  check_positive("density", problem.density);
  check_not_negative("pressure", problem.pressure);
  check_gamma(problem.gamma);
  const Bounded gamma(problem.gamma), u(problem.piston_velocity), density(problem.density), p(problem.pressure);
  const Bounded energy = p / ((gamma - 1.0) * density);  // ideal gas: p = (gamma - 1) rho e
  sound_speed_ = sqrt(gamma * p / density);              // ideal gas: c^2 = gamma p/rho
  ahead_ = {density, 0.0, p, problem.pressure == 0 ? Bounded(0) : energy};
  // Mass, momentum and energy over the shock give U (U - (gamma + 1)/2 u) = c^2, of which U is the positive root.
  const Bounded half = Bounded(0.25) * (gamma + 1.0) * u, c2 = sound_speed_ * sound_speed_;
  shock_speed_ = half + sqrt(half * half + c2);
  const Bounded relative = c2 / shock_speed_ + Bounded(0.5) * (gamma - 1.0) * u;  // U - u without cancellation
  behind_.density = density * shock_speed_ / relative;
  behind_.velocity = u;
  behind_.pressure = p + density * shock_speed_ * u;
  behind_.energy = behind_.pressure / ((gamma - 1.0) * behind_.density);
}

Bounded PistonShock::mach_number() const { return shock_speed_ / sound_speed_; }

Sample PistonShock::sample(double position, double time) const {
  check_finite("position", position);
  check_not_negative("time", time);
  return beside_front(
      position, shock_speed_ * time, [this] { return behind(); }, [this] { return ahead(); });
}

}  // namespace plumbline::reference
