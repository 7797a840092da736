#pragma once
// Small transverse vibration of a taut string between fixed ends: c = sqrt(T/(rho A)), modes n pi c/l.
//
// Length, section and density are those of the taut state (the length is the distance of the ends), the strain is that
// of the taut state over the unstretched one: T = E A eps0, c = sqrt(E eps0/rho), unstretched length l/(1 + eps0).
#include "reference/bounded.hpp"

namespace plumbline::reference {

/// One mode, released from rest. Any consistent units; all positive, the amplitude may have any sign.
struct StringVibrationProblem {
  double youngs_modulus = 1e6;
  double area = 0.1;
  double density = 0.1;
  double strain = 0.01;  // eps0
  double length = 1;
  int mode = 1;
  double amplitude = 1e-3;  // largest displacement; linear theory: (n pi A/l)^2 << eps0
};

/// Positions 0 <= x <= length; times have any sign.
class StringVibration {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit StringVibration(const StringVibrationProblem& problem);

  const StringVibrationProblem& problem() const { return problem_; }
  Bounded tension() const { return tension_; }
  Bounded wave_speed() const { return speed_; }
  Bounded omega() const { return omega_; }
  Bounded period() const;
  Bounded unstretched_length() const;
  Bounded displacement(double x, double time) const;  // transverse
  Bounded velocity(double x, double time) const;
  Bounded slope(double x, double time) const;
  Bounded energy() const;  // of the vibration, without that of the strain eps0
  Bounded kinetic_energy(double time) const;
  Bounded potential_energy(double time) const;
  /// The period at the finite amplitude, by Kirchhoff's string (the tension rises with the mean stretch and is even
  /// along the string): exact for that equation, and a measure of what the linear theory neglects.
  Bounded kirchhoff_period() const;

 private:
  StringVibrationProblem problem_;
  Bounded tension_, speed_, wavenumber_, omega_;
};

}  // namespace plumbline::reference
