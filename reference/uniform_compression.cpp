#include "reference/uniform_compression.hpp"

#include "reference/exponential.hpp"

namespace plumbline::reference {

UniformCompression::UniformCompression(const UniformCompressionProblem& problem) : problem_(problem) {
  check_dimension(problem.dimension);
  check_finite("rate", problem.rate);
  check_not_negative("viscosity", problem.viscosity);
  check_not_negative("linear", problem.linear);
  check_not_negative("quadratic", problem.quadratic);
  check_positive("density", problem.density);
  check_positive("pressure", problem.pressure);
  check_gamma(problem.gamma);
  if (problem.linear > 0 && (problem.viscosity > 0 || problem.quadratic > 0)) {
    throw ParameterError("linear", problem.linear, "0 where there is other viscosity");
  }
  gamma_ = problem.gamma;
  energy_ = Bounded(problem.pressure) / ((gamma_ - 1.0) * problem.density);
}

Bounded UniformCompression::stretch(double time) const {
  check_not_negative("time", time);
  if (!(problem_.rate * time < 1))
    throw ParameterError("time", time, "below 1 over the rate: there the gas is a point");
  return Bounded(1) - Bounded(problem_.rate) * time;
}

Bounded UniformCompression::to_power(double time, Bounded exponent) const { return exp(exponent * log(stretch(time))); }

Bounded UniformCompression::integral(double time, Bounded exponent) const {
  const Bounded l = log(stretch(time));
  return -(l * expm1_over(exponent * l));
}

Bounded UniformCompression::isentropic_energy(double time) const {
  return energy_ * to_power(time, -(Bounded(problem_.dimension) * (gamma_ - 1.0)));
}

Bounded UniformCompression::viscous_heat(double time) const {
  const Bounded d(problem_.dimension), a(problem_.rate), m = d * (gamma_ - 1.0);
  const bool closing = problem_.rate > 0;
  if (problem_.linear > 0) {
    if (!closing) return 0;
    const Bounded half = Bounded(0.5) * m;
    const Bounded gain = Bounded(0.5) * problem_.linear * sqrt(gamma_ * (gamma_ - 1.0)) * d * d * a *
                         integral(time, half - 1.0);
    return gain * (Bounded(2) * sqrt(energy_) + gain) * to_power(time, -m);
  }
  const Bounded physical = Bounded(2) * problem_.viscosity * d * (Bounded(1) - d / 3.0) * a / problem_.density;
  Bounded gain = physical * integral(time, m + d - 1.0);
  if (closing) gain = gain + Bounded(problem_.quadratic) * power(d, 3) * a * a * integral(time, m - 2.0);
  return gain * to_power(time, -m);
}

Bounded UniformCompression::energy(double time) const { return isentropic_energy(time) + viscous_heat(time); }

UniformCompression::Instant UniformCompression::instant(double time) const {
  const Bounded s = stretch(time), e = energy(time);
  const Bounded density = Bounded(problem_.density) / power(s, problem_.dimension);
  return {s, density, (gamma_ - 1.0) * density * e, e, problem_.rate};
}

Sample UniformCompression::Instant::at(double position) const {
  check_finite("position", position);
  return {density, -(rate * position / stretch), pressure, energy};
}

}  // namespace plumbline::reference
