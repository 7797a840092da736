#include <cmath>

#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

// Of an oscillator: damped and stable up to omega dt = sqrt(8).
class RungeKutta4 final : public TimeIntegrator {
  Claims claims() const override {
    return {.orders = {{4}, {4, "oscillator", "velocity"}, {4, "fixed mesh", "strain"}, {4, "fixed mesh", "velocity"}},
            .energy = EnergyBehaviour::decaying,
            .limit = std::sqrt(8.0)};
  }

  void step(Stages& mpm, double dt) override {
    const State y = mpm.state(), k1 = mpm.rate();
    mpm.set_state(y + dt / 2 * k1);
    const State k2 = mpm.rate();
    mpm.set_state(y + dt / 2 * k2);
    const State k3 = mpm.rate();
    mpm.set_state(y + dt * k3);
    const State k4 = mpm.rate();
    mpm.set_state(y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4));  // [RK4 1]
  }
};

PLUMBLINE_INTEGRATOR(RungeKutta4, "rk4", "the classical Runge-Kutta method of order four",
                     "Kutta 1901; Hairer, Norsett, Wanner 1993, section II.1");

}  // namespace
}  // namespace plumbline
