#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

class UpdateStressLast final : public TimeIntegrator {
  Claims claims() const override {
    return {.orders = {{1}, {1, "oscillator", "velocity"}, {1, "fixed mesh", "strain"}, {1, "fixed mesh", "velocity"}},
            .energy = EnergyBehaviour::bounded,
            .limit = 2};
  }

  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();  // [York 3.15, 3.16]
    mpm.map_forces();             // [York 3.17, 3.18]
    mpm.advance_momentum(dt);     // [York 3.19, 3.20]
    mpm.move_points(dt);          // [York 3.21, 3.22]
    mpm.update_stress(dt);        // [York 3.23] with v~_i, not mapped again
  }
};

PLUMBLINE_INTEGRATOR(UpdateStressLast, "usl", "update stress last, from the updated nodal velocity",
                     "Sulsky, Chen, Schreyer 1994, doi 10.1016/0045-7825(94)90112-0");

}  // namespace
}  // namespace plumbline
