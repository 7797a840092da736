#include <cmath>

#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

// Convex combinations of Euler steps: what an Euler step keeps bounded stays so. Of an oscillator: damped and stable up to
// omega dt = sqrt(3).
class SspRungeKutta3 final : public TimeIntegrator {
  Claims claims() const override {
    return {.orders = {{3}, {3, "oscillator", "velocity"}, {3, "fixed mesh", "strain"}, {3, "fixed mesh", "velocity"}},
            .energy = EnergyBehaviour::decaying,
            .limit = std::sqrt(3.0)};
  }

  void step(Stages& mpm, double dt) override {
    const State y = mpm.state();
    mpm.set_state(y + dt * mpm.rate());                                      // [SSP-RK3 1]
    mpm.set_state(0.75 * y + 0.25 * (mpm.state() + dt * mpm.rate()));        // [SSP-RK3 2]
    mpm.set_state(1.0 / 3 * y + 2.0 / 3 * (mpm.state() + dt * mpm.rate()));  // [SSP-RK3 3]
  }
};

PLUMBLINE_INTEGRATOR(SspRungeKutta3, "ssp-rk3", "strong-stability-preserving Runge-Kutta of order three",
                     "Shu, Osher 1988, doi 10.1016/0021-9991(88)90177-5");

}  // namespace
}  // namespace plumbline
