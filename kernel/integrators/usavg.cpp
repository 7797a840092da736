#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

class UpdateStressAveraged final : public TimeIntegrator {
  Claims claims() const override {
    return {.orders = {{2}, {2, "oscillator", "velocity"}, {2, "fixed mesh", "strain"}, {2, "fixed mesh", "velocity"}},
            .energy = EnergyBehaviour::bounded,
            .limit = 2,
            .reversible = true};
  }

  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();
    mpm.update_stress(dt / 2);  // half the increment with the velocity of the start
    mpm.map_forces();
    mpm.advance_momentum(dt);
    mpm.move_points(dt);
    mpm.map_momentum();
    mpm.update_stress(dt / 2);  // the other half with the updated, remapped velocity
  }
};

PLUMBLINE_INTEGRATOR(UpdateStressAveraged, "usavg", "half the strain increment before, half after the momentum update",
                     "Nairn 2003, doi 10.3970/cmes.2003.004.649");

}  // namespace
}  // namespace plumbline
