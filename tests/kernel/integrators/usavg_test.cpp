#include "tests/kernel/integrators/recording.hpp"

namespace plumbline::usavg_test {
namespace {

TEST(UpdateStressAveraged, Order) {
  EXPECT_EQ(calls_of("usavg"),
            (std::vector<std::string>{"locate_points", "map_mass_and_momentum", "strain_points dt/2 current",
                                      "evaluate_stress current", "map_forces", "advance_momentum dt", "move_points dt",
                                      "map_momentum", "strain_points dt/2 current", "evaluate_stress current"}));
}

TEST(UpdateStressAveraged, OnePointOscillator) {
  expect_steps_as_by_hand("usavg", [](OnePointOscillator& o, double dt) {
    o.stretch(dt / 2 * o.v / o.h);
    o.move(o.acceleration(), dt);
    o.stretch(dt / 2 * o.v / o.h);
  });
}

}  // namespace
}  // namespace plumbline::usavg_test
