#include "reference/simple_wave.hpp"

#include "reference/exponential.hpp"
#include "reference/root.hpp"

namespace plumbline::reference {
namespace {

Bounded bump(Bounded s) { return power((Bounded(1) - s) * (Bounded(1) + s), 6); }

double bump_slope(double s) { return -12 * s * std::pow(1 - s * s, 5); }

}  // namespace

SimpleWave::SimpleWave(const SimpleWaveProblem& problem) : problem_(problem) {
  check_finite("amplitude", problem.amplitude);
  check_finite("centre", problem.centre);
  check_positive("half_width", problem.half_width);
  check_positive("density", problem.density);
  check_positive("pressure", problem.pressure);
  check_gamma(problem.gamma);
  const Bounded gamma(problem.gamma);
  sound_speed_ = sqrt(gamma * problem.pressure / problem.density);          // ideal gas: c^2 = gamma p/rho
  energy_ = Bounded(problem.pressure) / ((gamma - 1.0) * problem.density);  // ideal gas: p = (gamma - 1) rho e
  const Bounded least = Bounded(-2) * sound_speed_ / (gamma - 1.0);
  if (!certainly_below(least, problem.amplitude)) {
    throw ParameterError("amplitude", problem.amplitude, "above -2 c/(gamma - 1), where the gas would part");
  }
}

Bounded SimpleWave::breaking_time() const {
  if (problem_.amplitude == 0) return {rounding::infinity, 0};
  // x = x0 + (c + (gamma + 1)/2 u(x0)) t first folds where u falls fastest: |s| = 1/sqrt(11).
  const Bounded steepest = Bounded(12) / sqrt(Bounded(11)) * power(Bounded(10) / 11.0, 5);
  const Bounded spread = (Bounded(problem_.gamma) + 1.0) * std::abs(problem_.amplitude);
  return Bounded(2) * problem_.half_width / (spread * steepest);
}

/// s of the state that is found at centre + c t + shifted.
Bounded SimpleWave::foot(Bounded shifted, double time) const {
  const double w = problem_.half_width;
  const Bounded lead = Bounded(0.5) * (Bounded(problem_.gamma) + 1.0) * problem_.amplitude * time;
  auto f = [&](double s) { return Bounded(w) * s + lead * bump(s) - shifted; };
  if (!(f(-1).value < 0)) return enclose_root(f, -1, w, -1, 1);
  if (!(f(1).value > 0)) return enclose_root(f, 1, w, -1, 1);
  const double s = brent_root([&f](double at) { return f(at).value; }, -1, 1);
  return enclose_root(f, s, std::max(w + lead.value * bump_slope(s), w * 1e-12), -1, 1);
}

Sample SimpleWave::state(Bounded velocity) const {
  const Bounded gamma(problem_.gamma), less = gamma - 1.0;
  const Bounded ratio = Bounded(1) + Bounded(0.5) * less * velocity / sound_speed_;  // c over that of the gas at rest
  return {Bounded(problem_.density) * pow(ratio, Bounded(2) / less), velocity,
          Bounded(problem_.pressure) * pow(ratio, Bounded(2) * gamma / less), energy_ * ratio * ratio};
}

Sample SimpleWave::sample(double position, double time) const {
  check_finite("position", position);
  check_not_negative("time", time);
  if (!certainly_below(time, breaking_time())) throw ParameterError("time", time, "before the pulse breaks");
  const Bounded shifted = Bounded(position) - problem_.centre - sound_speed_ * time;
  const Bounded w(problem_.half_width);
  if (certainly_below(shifted, -w) || certainly_below(w, shifted)) {
    return {problem_.density, 0.0, problem_.pressure, energy_};
  }
  return state(Bounded(problem_.amplitude) * bump(foot(shifted, time)));
}

}  // namespace plumbline::reference
