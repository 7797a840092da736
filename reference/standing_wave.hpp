#pragma once
// A standing sound wave in an ideal gas between walls at k x = 0, pi, 2 pi, ... or periodic, that starts as
//   u = U sin(k x),  rho = rho0,  p = p0:
// u = U sin(k x) cos(w t), rho'/rho0 = p'/(gamma p0) = -U/c cos(k x) sin(w t), w = c k, in the limit of small amplitudes
// (L. D. Landau, E. M. Lifshitz, Fluid Mechanics, 2nd ed., section 64). Here to second order in U, by characteristics;
// orders above are bounded as explained in the source.
#include "reference/gas_flow.hpp"

namespace plumbline::reference {

/// Any consistent units.
struct StandingWaveProblem {
  double amplitude = 1e-3;                // U, at most a hundredth of the speed of sound
  double wavenumber = 6.283185307179586;  // k > 0
  double density = 1;
  double pressure = 1;
  double gamma = 1.4;
};

class StandingWave {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit StandingWave(const StandingWaveProblem& problem);

  const StandingWaveProblem& problem() const { return problem_; }
  Bounded sound_speed() const { return sound_speed_; }
  Bounded period() const;  // 2 pi/w
  /// time >= 0, long before the wave breaks: (gamma + 1)/2 U k t below 1/2.
  Sample sample(double position, double time) const;

 private:
  StandingWaveProblem problem_;
  Bounded sound_speed_;
};

}  // namespace plumbline::reference
