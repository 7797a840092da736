#pragma once
// One mass on a spring, u'' = f(u) - 2 zeta u' + g, mass and linear stiffness one, so that times are in units of 1/omega:
//   linear      f = -u
//   hardening   f = -u - u^3 (Duffing); started at rest at u0 without g, u = u0 cn(sqrt(1 + u0^2) t | m), with
//               m = u0^2 / (2 (1 + u0^2)) [DLMF 22.13.14] (NIST Digital Library of Mathematical Functions)
//   gas column  f = ((1 + u)^-gamma - 1) / gamma: a piston on a gas of length 1 + u without exchange of heat, a constant
//               pressure on its other side
// Integrated by GSL's rk8pd; the step is halved until the answer stays, and the bound is twice the last change, plus the
// rounding of all steps.
#include "reference/bounded.hpp"

namespace plumbline::reference {

enum class SpringLaw { linear, hardening, gas_column };

/// damping (zeta) >= 0; gamma > 1 of the gas column. Start: displacement > -1 on a gas column.
struct SpringOscillatorProblem {
  SpringLaw law = SpringLaw::linear;
  double damping = 0, gravity = 0, gamma = 1.4;
  double displacement = 0, velocity = 0;  // at t = 0
};

struct SpringOscillatorState {
  Bounded displacement, velocity;
};

/// f(u) of the law, without damper and gravity.
double spring_force(const SpringOscillatorProblem& problem, double displacement);

/// At a time >= 0, in units of 1/omega. Throws ParameterError with the key of a value out of range.
SpringOscillatorState spring_oscillator(const SpringOscillatorProblem& problem, double time);

}  // namespace plumbline::reference
