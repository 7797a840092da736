#include "reference/spring_oscillator.hpp"

#include <gsl/gsl_errno.h>

#include <array>
#include <cmath>

#include "reference/argument.hpp"
#include "reference/gsl_owned.hpp"

namespace plumbline::reference {
namespace {

using State = std::array<double, 2>;

int oscillator_rates(double /*time*/, const double* y, double* rate, void* parameters) {
  const auto& problem = *static_cast<const SpringOscillatorProblem*>(parameters);
  rate[0] = y[1];
  rate[1] = spring_force(problem, y[0]) - 2 * problem.damping * y[1] + problem.gravity;
  return std::isfinite(rate[1]) ? GSL_SUCCESS : GSL_EBADFUNC;
}

State integrated(SpringOscillatorProblem problem, double time, int steps) {
  gsl_odeiv2_system system{oscillator_rates, nullptr, 2, &problem};
  const Owned<gsl_odeiv2_step> stepper(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 2));
  State state{problem.displacement, problem.velocity}, error{};
  const double step = time / steps;
  for (int k = 0; k < steps; ++k) {
    gsl_odeiv2_step_apply(stepper.get(), k * step, step, state.data(), error.data(), nullptr, nullptr, &system);
  }
  return state;
}

}  // namespace

double spring_force(const SpringOscillatorProblem& problem, double displacement) {
  switch (problem.law) {
    case SpringLaw::hardening:
      return -displacement - displacement * displacement * displacement;
    case SpringLaw::gas_column:
      return std::expm1(-problem.gamma * std::log1p(displacement)) / problem.gamma;
    default:
      return -displacement;
  }
}

SpringOscillatorState spring_oscillator(const SpringOscillatorProblem& problem, double time) {
  check_not_negative("damping", problem.damping);
  check_not_negative("time", time);
  check_finite("gravity", problem.gravity);
  check_finite("velocity", problem.velocity);
  check_finite("displacement", problem.displacement);
  if (problem.law == SpringLaw::gas_column) {
    check({"gamma", 1.4, 1, rounding::infinity, true, true, "", ""}, problem.gamma);
    check({"displacement", 0, -1, rounding::infinity, true, true, "", ""}, problem.displacement);
  }
  // The method is of eighth order: where halving the step still changes the answer, the finer one is better by far.
  constexpr int most_halvings = 6;
  int steps = 8 + static_cast<int>(8 * time);
  State coarse = integrated(problem, time, steps);
  Bounded answer[2];
  for (int level = 0; level < most_halvings; ++level) {
    steps *= 2;
    const State fine = integrated(problem, time, steps);
    bool settled = true;
    for (std::size_t k = 0; k < 2; ++k) {
      const double scale = std::abs(problem.displacement) + std::abs(problem.velocity) + std::abs(problem.gravity);
      const double own = 4 * rounding::unit * (steps + 16) * scale, change = 2 * std::abs(fine[k] - coarse[k]);
      settled = settled && change <= own;
      answer[k] = {fine[k], change + own};
    }
    if (settled) break;
    coarse = fine;
  }
  return {answer[0], answer[1]};
}

}  // namespace plumbline::reference
