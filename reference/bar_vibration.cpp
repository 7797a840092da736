#include "reference/bar_vibration.hpp"

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/elementary.hpp"

namespace plumbline::reference {

BarVibration::BarVibration(const BarVibrationProblem& problem) : problem_(problem) {
  check_positive("youngs_modulus", problem.youngs_modulus);
  check_positive("density", problem.density);
  check_positive("area", problem.area);
  check_positive("length", problem.length);
  check_finite("velocity", problem.velocity);
  check_mode(problem.mode);
  speed_ = sqrt(Bounded(problem.youngs_modulus) / problem.density);
  wavenumber_ = pi * (2.0 * problem.mode - 1) / (Bounded(2) * problem.length);
  omega_ = wavenumber_ * speed_;
}

Bounded BarVibration::period() const { return Bounded(2) * pi / omega_; }

Bounded BarVibration::amplitude() const { return abs(Bounded(problem_.velocity)) / omega_; }

Bounded BarVibration::shape(double x) const {
  check_within("position", x, 0, problem_.length);
  return sin(wavenumber_ * x);
}

Bounded BarVibration::slope(double x) const {
  check_within("position", x, 0, problem_.length);
  return wavenumber_ * cos(wavenumber_ * x);
}

Bounded BarVibration::displacement(double x, double time) const {
  check_finite("time", time);
  return Bounded(problem_.velocity) / omega_ * shape(x) * sin(omega_ * time);
}

Bounded BarVibration::velocity(double x, double time) const {
  check_finite("time", time);
  return Bounded(problem_.velocity) * shape(x) * cos(omega_ * time);
}

Bounded BarVibration::strain(double x, double time) const {
  check_finite("time", time);
  return Bounded(problem_.velocity) / omega_ * slope(x) * sin(omega_ * time);
}

Bounded BarVibration::stress(double x, double time) const { return Bounded(problem_.youngs_modulus) * strain(x, time); }

// The mean of sin k x over the bar is (1 - cos k L)/(k L), and k L is an odd multiple of pi/2.
Bounded BarVibration::mean_velocity(double time) const {
  check_finite("time", time);
  return Bounded(problem_.velocity) / (wavenumber_ * problem_.length) * cos(omega_ * time);
}

Bounded BarVibration::energy() const {
  const Bounded v(problem_.velocity);
  return Bounded(0.25) * problem_.density * problem_.area * problem_.length * v * v;
}

Bounded BarVibration::kinetic_energy(double time) const {
  const Bounded c = cos(omega_ * time);
  return energy() * c * c;
}

Bounded BarVibration::strain_energy(double time) const {
  const Bounded s = sin(omega_ * time);
  return energy() * s * s;
}

}  // namespace plumbline::reference
