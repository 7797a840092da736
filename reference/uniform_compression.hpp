#pragma once
// An ideal gas that is compressed uniformly, without forces: x = s X in d directions, s = 1 - a t, so that the velocity
// is -a x/s, the density rho0 s^-d and pressure and energy are uniform. Its stress is that of York (4.1), with a
// physical viscosity mu or with an artificial one, q = rho (l c D + b D^2), D = max(0, -div v): l = c_L h and
// b = c_Q h^2 of York (4.11). With e' = sigma : grad v/rho, de/ds = -e'/a and m = d (gamma - 1),
//   mu, b:  (e s^m)'       = -s^m (2 mu d (1 - d/3) a s^(d-2)/rho0 + b d^3 a^2 s^-3),
//   l:      (e^1/2 s^m/2)' = -l sqrt(gamma (gamma - 1)) d^2 a s^(m/2-2)/2,
// whose integrals are powers. l together with mu or b has no closed form.
#include "reference/gas_flow.hpp"

namespace plumbline::reference {

/// Any consistent units.
struct UniformCompressionProblem {
  int dimension = 1;     // d: 1, 2 or 3 directions
  double rate = 0.5;     // a; below zero the gas expands, and artificial viscosity does nothing
  double viscosity = 0;  // mu >= 0
  double linear = 0;     // l >= 0, a length; > 0 only with mu = b = 0
  double quadratic = 0;  // b >= 0, a length squared
  double density = 1;    // at t = 0
  double pressure = 1;
  double gamma = 1.4;
};

class UniformCompression {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit UniformCompression(const UniformCompressionProblem& problem);

  const UniformCompressionProblem& problem() const { return problem_; }
  Bounded stretch(double time) const;            // s; time >= 0, rate * time < 1
  Bounded energy(double time) const;             // e, per mass
  Bounded isentropic_energy(double time) const;  // of the same gas without viscosity
  Bounded viscous_heat(double time) const;       // what viscosity has added to it; no digits are lost where it is small

  /// The gas at one time: all but the velocity is the same everywhere.
  struct Instant {
    Bounded stretch, density, pressure, energy, rate;
    Sample at(double position) const;  // the velocity along `position`
  };
  Instant instant(double time) const;
  Sample sample(double position, double time) const { return instant(time).at(position); }

 private:
  Bounded to_power(double time, Bounded exponent) const;  // s^exponent
  Bounded integral(double time, Bounded exponent) const;  // of x^(exponent - 1) from s to 1

  UniformCompressionProblem problem_;
  Bounded gamma_, energy_;  // energy_: at t = 0
};

}  // namespace plumbline::reference
