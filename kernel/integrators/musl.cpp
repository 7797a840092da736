#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

class ModifiedUpdateStressLast final : public TimeIntegrator {
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
    mpm.map_momentum();           // [York 3.24]
    mpm.update_stress(dt);        // [York 3.23]
  }
};

PLUMBLINE_INTEGRATOR(ModifiedUpdateStressLast, "musl", "York's step: momentum form with a second map, stress last",
                     "York 1997, SAND97-1893, chapter 3");

}  // namespace
}  // namespace plumbline
