#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

// Velocities stand half a step behind positions and stresses: the first step kicks them by half of itself, the others by
// the mean of the last step and this one. Positions are of second order; velocities are those of half a step ago.
class CentralDifference final : public TimeIntegrator {
  Claims claims() const override {
    return {.orders = {{2}, {1, "oscillator", "velocity"}, {2, "fixed mesh", "strain"}, {1, "fixed mesh", "velocity"}},
            .energy = EnergyBehaviour::bounded,
            .limit = 2};
  }
  std::vector<double*> kept() override { return {&last_dt_}; }

  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();
    mpm.map_forces();
    mpm.advance_momentum((last_dt_ + dt) / 2);  // [Central-Difference 1]
    mpm.move_points(dt);
    mpm.map_momentum();
    mpm.update_stress(dt);
    last_dt_ = dt;
  }

  double last_dt_ = 0;  // s
};

PLUMBLINE_INTEGRATOR(CentralDifference, "central-difference",
                     "velocities at half steps, positions and stresses at whole",
                     "Wallstedt, Guilkey 2008, doi 10.1016/j.jcp.2008.07.019");

}  // namespace
}  // namespace plumbline
