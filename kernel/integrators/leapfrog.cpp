#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

// Drift, kick, drift: second order in time, with the energy ledger closed as by `energy`. Points move half a step with
// their own velocities; maps, forces and heat all use the place reached, and a stress predicted to the half step, so that
// an elastic oscillation is neither damped nor amplified below omega dt = 2. Equations: reports/docs/theory/step.md, "Leapfrog".
class Leapfrog final : public TimeIntegrator {
  Claims claims() const override {
    return {.orders = {{2}, {2, "oscillator", "velocity"}},
            .energy = EnergyBehaviour::bounded,
            .limit = 2,
            .reversible = true};
  }

  void step(Stages& mpm, double dt) override {
    mpm.drift_points(dt / 2);  // [Leapfrog 1]
    mpm.locate_points();
    mpm.map_mass_and_momentum();  // [EC-APIC 1]
    mpm.predict_stress(dt / 2);   // [Leapfrog 2]
    mpm.map_forces();             // [EC-APIC 4]
    mpm.advance_momentum(dt);
    mpm.kick_points(dt);       // [EC-APIC 5]
    mpm.drift_points(dt / 2);  // [Leapfrog 3]
    mpm.strain_points(dt, NodalVelocity::midpoint);
    mpm.return_transfer_loss();  // [EC-APIC 6]
  }
};

PLUMBLINE_INTEGRATOR(Leapfrog, "leapfrog",
                     "drift-kick-drift with the stress predicted to the half step; energy conserved",
                     "reports/docs/theory/step.md; Verlet 1967, doi 10.1103/PhysRev.159.98");

}  // namespace
}  // namespace plumbline
