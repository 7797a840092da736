#include "cases/harness/integrators/oscillators.hpp"

#include <cmath>

#include "cases/harness/laboratory/oscillator.hpp"

namespace plumbline {

const std::vector<OscillatorScene>& oscillator_scenes() {
  using reference::SpringLaw;
  static const std::vector<OscillatorScene> all{
      {"spring", "a linear spring", {.displacement = 0.6, .velocity = 0.8}},
      {"spring-variable-steps",
       "a linear spring, steps that alternate between 1 and 0.7 of a size",
       {.displacement = 0.6, .velocity = 0.8},
       3,
       true},
      {"hardening-spring",
       "a spring whose force grows with its stretch and with the cube of it",
       {.law = SpringLaw::hardening, .displacement = 0.6, .velocity = 0.8}},
      {"gas-column",
       "a piston on a gas that is compressed without exchange of heat",
       {.law = SpringLaw::gas_column, .displacement = -0.3, .velocity = 0.3}},
      {"damped-spring", "a linear spring with a damper", {.damping = 0.1, .displacement = 0.6, .velocity = 0.8}},
      {"hanging-spring", "a linear spring under gravity", {.gravity = 0.5, .displacement = 0.1, .velocity = 0.3}}};
  return all;
}

std::vector<double> oscillator_errors(const Subject& subject, const OscillatorScene& scene, int steps) {
  const reference::SpringOscillatorProblem& problem = scene.problem;
  const auto exact = reference::spring_oscillator(problem, scene.end);
  const auto integrator = subject.entry().make();
  set_parameters(*integrator, subject.choice().parameters);
  const auto force = [problem](double u) { return reference::spring_force(problem, u); };
  OneMass mass(problem.displacement, problem.velocity, Spring{force, problem.damping, problem.gravity});
  const double dt = scene.end / steps;
  for (int k = 0; k < steps; ++k) {
    integrator->step(mass, scene.variable_steps ? dt / 1.7 : dt);
    if (scene.variable_steps) integrator->step(mass, 0.7 * dt / 1.7);
  }
  const double scale = std::hypot(problem.displacement, problem.velocity) + std::abs(problem.gravity);
  return {(mass.displacement() - exact.displacement.value) / scale, (mass.velocity() - exact.velocity.value) / scale,
          (mass.place() - exact.displacement.value) / scale};
}

}  // namespace plumbline
