#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

class UpdateStressFirst final : public TimeIntegrator {
  Claims claims() const override {
    return {.orders = {{1}, {1, "oscillator", "velocity"}, {1, "fixed mesh", "strain"}, {1, "fixed mesh", "velocity"}},
            .energy = EnergyBehaviour::bounded,
            .limit = 2};
  }

  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();  // [York 3.15, 3.16]
    mpm.update_stress(dt);        // [York 3.23] with the velocity of the start of the step
    mpm.map_forces();             // [York 3.17, 3.18]
    mpm.advance_momentum(dt);     // [York 3.19, 3.20]
    mpm.move_points(dt);          // [York 3.21, 3.22]
  }
};

PLUMBLINE_INTEGRATOR(UpdateStressFirst, "usf", "update stress first, before the forces",
                     "Bardenhagen 2002, doi 10.1006/jcph.2002.7103");

}  // namespace
}  // namespace plumbline
