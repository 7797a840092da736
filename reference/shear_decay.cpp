// Sound driven by the heat. With K = 2 k, w = c K, s = 2 nu k^2, D = 4/3 nu K^2 = 8/3 s and the source of pressure
// F e^(-s t) (1 - cos K x), F = (gamma - 1) mu k^2 U^2/2, the amplitudes (p and rho of cos K x, v of sin K x) obey
//   rho0 v' = K p - rho0 D v,   p' = -gamma p0 K v - F e^(-s t),   (p - c^2 rho)' = -F e^(-s t).
// The heat received until t is H = F (1 - e^(-s t))/s; p swings about its rest 0, so |rho| c^2 stays below 2 H.
//
// Orders above the second, with delta = 2 H/(rho0 c^2):
// - transverse velocity: the gas moves by delta/(2 k), which shifts the cosine by U delta/2; its diffusivity, per mass,
//   changes by delta and moves at most (1/2 + 3/2) U delta of velocity into cos k x and cos 3 k x. Together 2.5, taken
//   as 3, times U delta.
// - density and pressure: the heat itself changes by twice the share of the transverse velocity (6 delta); squares of
//   delta; and the speed of sound changes by up to gamma delta with the mean pressure, which shifts the phase of the
//   sound, and steepens it, by gamma delta w t. Taken as delta min(2, delta (12 + (gamma + 1) w t)).
#include "reference/shear_decay.hpp"

#include "reference/exponential.hpp"
#include "reference/widened.hpp"

namespace plumbline::reference {

ShearDecay::ShearDecay(const ShearDecayProblem& problem) : problem_(problem) {
  check_finite("amplitude", problem.amplitude);
  check_positive("wavenumber", problem.wavenumber);
  check_not_negative("viscosity", problem.viscosity);
  check_positive("density", problem.density);
  check_positive("pressure", problem.pressure);
  check_gamma(problem.gamma);
  const Bounded k(problem.wavenumber), nu = Bounded(problem.viscosity) / problem.density;
  sound_speed_ = sqrt(Bounded(problem.gamma) * problem.pressure / problem.density);  // ideal gas: c^2 = gamma p/rho
  rate_ = problem.viscosity == 0 ? Bounded(0) : nu * k * k;
  if (std::abs(problem.amplitude) > 0.5 * sound_speed_.value) {
    throw ParameterError("amplitude", problem.amplitude, "at most half the speed of sound");
  }
  if (nu.value * k.value > 0.5 * sound_speed_.value) {
    throw ParameterError("viscosity", problem.viscosity, "at most density times half the speed of sound over k");
  }
}

Bounded ShearDecay::heat(double time) const {
  check_not_negative("time", time);
  const Bounded u(problem_.amplitude), power_at_start = Bounded(0.5) * rate_ * problem_.density * u * u;
  return power_at_start * time * expm1_over(Bounded(-2) * rate_ * time);  // rho U^2/4 (1 - e^(-2 nu k^2 t))
}

ShearDecay::Response ShearDecay::response(double time) const {
  const Bounded gamma(problem_.gamma), rho(problem_.density), c = sound_speed_;
  const Bounded K = Bounded(2) * problem_.wavenumber, w = c * K;
  const Bounded s = Bounded(2) * rate_, damping = Bounded(4) / 3.0 * s, D = Bounded(2) * damping;  // D/2, [York 4.1]
  const Bounded F = Bounded(0.5) * (gamma - 1.0) * rate_ * rho * problem_.amplitude * problem_.amplitude;
  const Bounded ringing = sqrt(w * w - damping * damping), angle = ringing * time;
  const Bounded forced = exp(-(s * time)), free = exp(-(damping * time));
  const Bounded A = -(K * F) / (rho * (w * w + s * s - D * s)), C = A * (s - damping) / ringing;
  const Bounded v = A * forced + free * (C * sin(angle) - A * cos(angle));
  const Bounded v_rate = -(s * A * forced) +
                         free * ((damping * A + ringing * C) * cos(angle) + (ringing * A - damping * C) * sin(angle));
  Response r;
  r.velocity = v;
  r.pressure = rho / K * (v_rate + D * v);
  r.mean_pressure = (gamma - 1.0) * heat(time);
  r.density = (r.pressure + r.mean_pressure) / (c * c);
  r.disturbance = 2 * highest(r.mean_pressure) / (rho.value * c.value * c.value) * (1 + 1e-12);
  const double shift = 12 + (gamma.value + 1) * w.value * time;
  r.neglected = r.disturbance * std::min(2.0, r.disturbance * shift);
  return r;
}

Sample ShearDecay::sample(double position, double time) const {
  check_finite("position", position);
  const Response r = response(time);
  const Bounded p0(problem_.pressure), rho0(problem_.density), phase = Bounded(problem_.wavenumber) * position;
  const Bounded once = cos(phase), twice = cos(Bounded(2) * phase);
  const Bounded pressure = r.mean_pressure + r.pressure * twice, density = r.density * twice;
  const Bounded e0 = p0 / ((Bounded(problem_.gamma) - 1.0) * rho0);
  const double gamma = problem_.gamma;
  return {widened(rho0 + density, rho0.value * r.neglected),
          widened(Bounded(problem_.amplitude) * exp(-(rate_ * time)) * once, 3 * problem_.amplitude * r.disturbance),
          widened(p0 + pressure, p0.value * gamma * r.neglected),
          widened(e0 * (Bounded(1) + pressure / p0 - density / rho0), e0.value * (gamma + 1) * r.neglected)};
}

Bounded ShearDecay::longitudinal_velocity(double position, double time) const {
  check_finite("position", position);
  const Response r = response(time);
  const Bounded value = r.velocity * sin(Bounded(2) * (Bounded(problem_.wavenumber) * position));
  return widened(value, sound_speed_.value * r.neglected);
}

}  // namespace plumbline::reference
