#include "tests/kernel/integrators/recording.hpp"

namespace plumbline::usl_test {
namespace {

TEST(UpdateStressLast, Order) {
  EXPECT_EQ(calls_of("usl"),
            (std::vector<std::string>{"locate_points", "map_mass_and_momentum", "map_forces", "advance_momentum dt",
                                      "move_points dt", "strain_points dt current", "evaluate_stress current"}));
}

// The strain takes v~ = v + dt a as the grid has it. [York 3.20, 3.23]
TEST(UpdateStressLast, OnePointOscillator) {
  expect_steps_as_by_hand("usl", [](OnePointOscillator& o, double dt) {
    const double a = o.acceleration(), end = o.v + dt * a;
    o.move(a, dt);
    o.stretch(dt * end / o.h);
  });
}

}  // namespace
}  // namespace plumbline::usl_test
