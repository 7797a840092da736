#include "reference/noh.hpp"

#include "reference/exponential.hpp"

namespace plumbline::reference {

Noh::Noh(const NohProblem& problem) : problem_(problem) {
  check_dimension(problem.dimension);
  check_gamma(problem.gamma);
  check_positive("density", problem.density);
  check_positive("velocity", problem.velocity);
  const Bounded gamma(problem.gamma), u(problem.velocity);
  // At the shock the gas has already been squeezed (1 + u/U)^(d - 1) = ((gamma + 1)/(gamma - 1))^(d - 1) times.
  const Bounded squeeze = (gamma + 1.0) / (gamma - 1.0);
  shock_speed_ = Bounded(0.5) * (gamma - 1.0) * u;
  behind_.density = Bounded(problem.density) * power(squeeze, problem.dimension);
  behind_.velocity = 0.0;
  behind_.energy = Bounded(0.5) * u * u;  // all kinetic energy turns into heat
  behind_.pressure = (gamma - 1.0) * behind_.density * behind_.energy;
}

Bounded Noh::shock_radius(double time) const {
  check_not_negative("time", time);
  return shock_speed_ * time;
}

Sample Noh::ahead(double radius, double time) const {
  const Bounded path = Bounded(problem_.velocity) * time;
  const Bounded thickening = time == 0 ? Bounded(1) : power(Bounded(1) + path / radius, problem_.dimension - 1);
  return {Bounded(problem_.density) * thickening, -problem_.velocity, 0.0, 0.0};
}

Sample Noh::sample(double radius, double time) const {
  check_not_negative("radius", radius);
  return beside_front(
      radius, shock_radius(time), [this] { return behind(); }, [&] { return ahead(radius, time); });
}

}  // namespace plumbline::reference
