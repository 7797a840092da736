#pragma once
// A smooth pulse of any strength that runs to the right into gas at rest: a simple wave of the Euler equations. All
// gas has one entropy and u - 2 c/(gamma - 1) is the same everywhere; each state travels with its own u + c, until the
// pulse breaks. Source: R. Courant, K. O. Friedrichs, Supersonic Flow and Shock Waves, 1948, sections 40 and 41;
// L. D. Landau, E. M. Lifshitz, Fluid Mechanics, 2nd ed., section 101.
#include "reference/gas_flow.hpp"

namespace plumbline::reference {

/// Any consistent units. At t = 0 the velocity is amplitude (1 - s^2)^6, s = (x - centre)/half_width, for |s| < 1
/// and zero elsewhere: five continuous derivatives. A negative amplitude is a pulse of rarefied gas.
struct SimpleWaveProblem {
  double amplitude = 0.01;  // m/s, above -2 c/(gamma - 1)
  double centre = 0.3;
  double half_width = 0.25;
  double density = 1;  // of the gas at rest
  double pressure = 1;
  double gamma = 1.4;
};

class SimpleWave {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit SimpleWave(const SimpleWaveProblem& problem);

  const SimpleWaveProblem& problem() const { return problem_; }
  Bounded sound_speed() const { return sound_speed_; }  // of the gas at rest
  /// The first time at which two characteristics meet; infinite without amplitude.
  Bounded breaking_time() const;
  /// Any position; 0 <= time < breaking_time, else ParameterError with the key `time`.
  Sample sample(double position, double time) const;

 private:
  Bounded foot(Bounded shifted, double time) const;
  Sample state(Bounded velocity) const;

  SimpleWaveProblem problem_;
  Bounded sound_speed_, energy_;
};

}  // namespace plumbline::reference
