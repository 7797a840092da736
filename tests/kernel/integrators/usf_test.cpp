#include "tests/kernel/integrators/recording.hpp"

namespace plumbline::usf_test {
namespace {

TEST(UpdateStressFirst, Order) {
  EXPECT_EQ(calls_of("usf"), (std::vector<std::string>{"locate_points", "map_mass_and_momentum",
                                                       "strain_points dt current", "evaluate_stress current",
                                                       "map_forces", "advance_momentum dt", "move_points dt"}));
}

// The strain takes the velocity of the start, the force the new stress. [York 3.23] before [York 3.17]
TEST(UpdateStressFirst, OnePointOscillator) {
  expect_steps_as_by_hand("usf", [](OnePointOscillator& o, double dt) {
    o.stretch(dt * o.v / o.h);
    o.move(o.acceleration(), dt);
  });
}

}  // namespace
}  // namespace plumbline::usf_test
