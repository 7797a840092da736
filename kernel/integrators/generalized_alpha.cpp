#include <cmath>

#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

// Forces of the start of the step balance a mean of the accelerations of both its ends. Of an undamped oscillator the
// spectral radius falls to rho_b, where at omega dt = (1 + rho_b) sqrt(2 - rho_b) three roots meet; beyond, one grows and
// leaves the unit circle at omega dt = sqrt(12 (1 + rho_b)(2 - rho_b)/(10 - 5 rho_b + rho_b^2)).
// Equations: reports/docs/theory/step.md, "Integrators of the laboratory".
class GeneralizedAlpha final : public TimeIntegrator {
  std::vector<IntegratorParameter> parameters() override {
    return {{"rho_b", &rho_b_, 0, 1, "of generalized-alpha: what is left of the fastest oscillation after a step"}};
  }
  std::vector<State*> memory() override { return {&acceleration_}; }
  Claims claims() const override {
    const double r = rho_b_;
    return {.orders = {{2}, {2, "oscillator", "velocity"}, {2, "fixed mesh", "strain"}, {2, "fixed mesh", "velocity"}},
            .energy = EnergyBehaviour::decaying,
            .limit = std::sqrt(12 * (1 + r) * (2 - r) / (10 - 5 * r + r * r))};
  }

  void step(Stages& mpm, double dt) override {
    const double r = rho_b_, alpha_m = (2 * r - 1) / (1 + r), gamma = 1.5 - alpha_m;  // [Generalized-Alpha 1]
    const double beta = (5 - 3 * r) / ((1 + r) * (1 + r) * (2 - r));                  // [Generalized-Alpha 1]
    const State start = mpm.state(), force = mpm.velocities_of(mpm.rate());
    if (acceleration_.values.size() != force.values.size()) acceleration_ = force;
    const State next = 1 / (1 - alpha_m) * (force + -alpha_m * acceleration_);  // [Generalized-Alpha 2]
    // Positions and strains move with the velocity whose mean over the step is Newmark's.
    mpm.set_state(start + dt * ((0.5 - beta) * acceleration_ + beta * next));  // [Generalized-Alpha 3]
    const State moved = mpm.rate();
    mpm.set_state(start + dt * (moved + -1.0 * mpm.velocities_of(moved)) +
                  dt * ((1 - gamma) * acceleration_ + gamma * next));  // [Generalized-Alpha 4]
    acceleration_ = next;
  }

  double rho_b_ = 0.8;
  State acceleration_;
};

PLUMBLINE_INTEGRATOR(GeneralizedAlpha, "generalized-alpha", "explicit generalized-alpha with chosen damping rho_b",
                     "Hulbert, Chung 1996, doi 10.1016/S0045-7825(96)01036-5");

}  // namespace
}  // namespace plumbline
