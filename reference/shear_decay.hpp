#pragma once
// A transverse velocity u_y = U cos(k x) e^(-nu k^2 t) that decays by viscosity, nu = mu/rho, in an ideal gas without
// conduction of heat, between free-slip walls at k x = 0, pi, 2 pi, ... or periodic. In a gas of constant density this
// is exact (L. D. Landau, E. M. Lifshitz, Fluid Mechanics, 2nd ed., section 24). The viscous heat
//   mu u_y,x^2 = mu k^2 U^2 e^(-2 nu k^2 t) (1 - cos 2 k x)/2
// raises the pressure and, its cosine not being uniform, sends sound of wave number 2 k through the gas. Pressure,
// density and energy are given to second order in U (heat and its sound, linear acoustics with the longitudinal
// viscosity 4/3 mu of York's law, York (4.1)); what is left out is bounded as explained in the source.
#include "reference/gas_flow.hpp"

namespace plumbline::reference {

/// Any consistent units.
struct ShearDecayProblem {
  double amplitude = 0.01;                // U, at most half the speed of sound
  double wavenumber = 3.141592653589793;  // k > 0
  double viscosity = 0.01;                // mu >= 0, nu k at most half the speed of sound
  double density = 1;
  double pressure = 1;
  double gamma = 1.4;
};

class ShearDecay {
 public:
  /// Throws ParameterError with the key of a value out of range.
  explicit ShearDecay(const ShearDecayProblem& problem);

  const ShearDecayProblem& problem() const { return problem_; }
  Bounded decay_rate() const { return rate_; }  // nu k^2
  Bounded sound_speed() const { return sound_speed_; }
  /// `velocity` is the transverse one. time >= 0.
  Sample sample(double position, double time) const;
  Bounded longitudinal_velocity(double position, double time) const;  // along x, of second order in U
  Bounded heat(double time) const;  // mean rise of internal energy per volume, to second order

 private:
  /// Amplitudes of the sound: pressure and density go as cos 2 k x, velocity as sin 2 k x; and of the mean pressure.
  struct Response {
    Bounded pressure, density, velocity, mean_pressure;
    double disturbance;  // largest relative change of density so far
    double neglected;    // of the relative change of density, by orders above the second
  };
  Response response(double time) const;

  ShearDecayProblem problem_;
  Bounded rate_, sound_speed_;
};

}  // namespace plumbline::reference
