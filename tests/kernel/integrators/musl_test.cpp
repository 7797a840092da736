#include "tests/kernel/integrators/recording.hpp"

namespace plumbline::musl_test {
namespace {

// York's chapter 3: to the grid, forces, momentum, points, the second map, strains. [York 3.15-3.24]
TEST(ModifiedUpdateStressLast, Order) {
  EXPECT_EQ(calls_of("musl"), (std::vector<std::string>{"locate_points", "map_mass_and_momentum", "map_forces",
                                                        "advance_momentum dt", "move_points dt", "map_momentum",
                                                        "strain_points dt current", "evaluate_stress current"}));
}

// The strain takes the velocity mapped again from the updated point with the frozen weights: that is its own.
// [York 3.24]
TEST(ModifiedUpdateStressLast, OnePointOscillator) {
  expect_steps_as_by_hand("musl", [](OnePointOscillator& o, double dt) {
    o.move(o.acceleration(), dt);
    o.stretch(dt * o.v / o.h);
  });
}

}  // namespace
}  // namespace plumbline::musl_test
