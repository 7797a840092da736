#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

// Closes the energy ledger to rounding: points get back exactly the work their forces did on the grid and what the two
// maps lost. Equations: reports/docs/theory/step.md, "The energy-conserving step".
class EnergyConserving final : public TimeIntegrator {
  Claims claims() const override {
    const std::string cause =
        "strains follow the midpoint velocity, forces the stress of the start: an elastic oscillation grows by "
        "sqrt(1 + (omega dt)^2/2) a step";
    return {.orders = {{1}, {1, "oscillator", "velocity"}},
            .limit = 0,
            .known_failures = {{"stability/oscillator/growth", cause, 9.7e-4, 9.8e-4},
                               {"stability/bar/growth", cause, 3.8e-3, 4.0e-3},
                               {"energy/oscillator/growth", cause, 380, 465},
                               {"identities/airbag-500/finite", cause, 1, 2},
                               {"identities/noh-spherical/finite", cause, 1, 2}}};
  }

  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();                // [EC-APIC 1]
    mpm.evaluate_stress(NodalVelocity::start);  // [EC-APIC 2, 3]
    mpm.map_forces();                           // [EC-APIC 4]
    mpm.advance_momentum(dt);
    if (mpm.reverse_cooling()) {  // [EC-APIC viscous heat]
      mpm.map_forces();
      mpm.advance_momentum(dt);
    }
    mpm.move_points(dt);  // [EC-APIC 5]
    mpm.strain_points(dt, NodalVelocity::midpoint);
    mpm.return_transfer_loss();  // [EC-APIC 6]
  }
};

PLUMBLINE_INTEGRATOR(EnergyConserving, "energy",
                     "the energy-conserving step: work and transfer losses returned exactly",
                     "reports/docs/theory/step.md; APIC: Jiang et al. 2015, doi 10.1145/2766996");

}  // namespace
}  // namespace plumbline
