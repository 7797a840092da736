#include "reference/string_vibration.hpp"

#include "reference/argument.hpp"
#include "reference/circle.hpp"
#include "reference/elliptic.hpp"

namespace plumbline::reference {

StringVibration::StringVibration(const StringVibrationProblem& problem) : problem_(problem) {
  check_positive("youngs_modulus", problem.youngs_modulus);
  check_positive("area", problem.area);
  check_positive("density", problem.density);
  check_positive("strain", problem.strain);
  check_positive("length", problem.length);
  check_mode(problem.mode);
  check_finite("amplitude", problem.amplitude);
  tension_ = Bounded(problem.youngs_modulus) * problem.area * problem.strain;
  speed_ = sqrt(Bounded(problem.youngs_modulus) * problem.strain / problem.density);  // sqrt(T/(rho A))
  wavenumber_ = pi * problem.mode / problem.length;
  omega_ = wavenumber_ * speed_;
}

Bounded StringVibration::period() const { return Bounded(2) * pi / omega_; }

Bounded StringVibration::unstretched_length() const {
  return Bounded(problem_.length) / (Bounded(1) + problem_.strain);
}

Bounded StringVibration::displacement(double x, double time) const {
  check_within("position", x, 0, problem_.length);
  check_finite("time", time);
  return Bounded(problem_.amplitude) * sin(wavenumber_ * x) * cos(omega_ * time);
}

Bounded StringVibration::velocity(double x, double time) const {
  check_within("position", x, 0, problem_.length);
  check_finite("time", time);
  return -(Bounded(problem_.amplitude) * omega_ * sin(wavenumber_ * x) * sin(omega_ * time));
}

Bounded StringVibration::slope(double x, double time) const {
  check_within("position", x, 0, problem_.length);
  check_finite("time", time);
  return Bounded(problem_.amplitude) * wavenumber_ * cos(wavenumber_ * x) * cos(omega_ * time);
}

// 1/2 rho A w^2 times the mean of the squared mode, half of the length
Bounded StringVibration::energy() const {
  const Bounded size = omega_ * problem_.amplitude;
  return Bounded(0.25) * problem_.density * problem_.area * problem_.length * size * size;
}

Bounded StringVibration::kinetic_energy(double time) const {
  const Bounded s = sin(omega_ * time);
  return energy() * s * s;
}

Bounded StringVibration::potential_energy(double time) const {
  const Bounded c = cos(omega_ * time);
  return energy() * c * c;
}

// A mode of amplitude q stretches the string by k^2 q^2/4 in the mean: q'' + w^2 q (1 + gamma q^2) = 0 with
// gamma = k^2/(4 eps0); from its energy the quarter of the period is K(k)/(w sqrt(1 + z)), z = gamma A^2,
// k^2 = z/(2 (1 + z)).
Bounded StringVibration::kirchhoff_period() const {
  const Bounded steepness = wavenumber_ * problem_.amplitude;
  const Bounded z = steepness * steepness / (Bounded(4) * problem_.strain), twice = Bounded(2) * (Bounded(1) + z);
  const Bounded K = elliptic_K(sqrt(z / twice), sqrt((Bounded(2) + z) / twice));
  return Bounded(4) * K / (omega_ * sqrt(Bounded(1) + z));
}

}  // namespace plumbline::reference
