#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

// Two force passes: the second with the stress of the midpoint, as the first predicts it. Points strain and move with the
// midpoint velocity. Of linear elasticity no step raises the energy below w dt = 2, contact included.
// Equations: reports/docs/theory/step.md, "Midpoint".
class Midpoint final : public TimeIntegrator {
  Claims claims() const override {
    return {.orders = {{2}, {2, "oscillator", "velocity"}, {1, "fixed mesh", "strain"}, {1, "fixed mesh", "velocity"}},
            .energy = EnergyBehaviour::decaying,
            .limit = 2};
  }

  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();
    mpm.map_forces();
    mpm.advance_momentum(dt);                             // [Midpoint 1]
    mpm.predict_stress(dt / 2, NodalVelocity::midpoint);  // [Midpoint 2]
    mpm.map_forces();
    mpm.advance_momentum(dt);                      // [Midpoint 3]
    mpm.move_points(dt, NodalVelocity::midpoint);  // [Midpoint 4]
    mpm.update_stress(dt, NodalVelocity::midpoint);
  }
};

PLUMBLINE_INTEGRATOR(Midpoint, "midpoint", "two force passes, the second with the stress of the midpoint",
                     "reports/docs/theory/step.md; explicit midpoint rule: Hairer, Norsett, Wanner 1993, section II.1");

}  // namespace
}  // namespace plumbline
