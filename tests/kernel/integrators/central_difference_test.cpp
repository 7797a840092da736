#include "tests/kernel/integrators/recording.hpp"

namespace plumbline::central_difference_test {
namespace {

// The kick reaches from the middle of the last step to the middle of this one. [Central-Difference 1]
TEST(CentralDifference, Order) {
  const auto integrator = find_integrator("central-difference")->make();
  const auto calls = [&](double dt) {
    RecordingStages stages;
    integrator->step(stages, dt);
    return stages.calls;
  };
  const auto expected = [](const std::string& kick, const std::string& dt) -> std::vector<std::string> {
    return {"locate_points",
            "map_mass_and_momentum",
            "map_forces",
            "advance_momentum " + kick,
            "move_points " + dt,
            "map_momentum",
            "strain_points " + dt + " current",
            "evaluate_stress current"};
  };
  EXPECT_EQ(calls(1.0), expected("dt/2", "dt"));
  EXPECT_EQ(calls(1.0), expected("dt", "dt"));
  EXPECT_EQ(calls(0.5), expected("0.750000", "dt/2"));
}

// [Central-Difference 1]
TEST(CentralDifference, StepsAsByHand) {
  double last = 0;
  expect_steps_as_by_hand("central-difference", [&](OnePointOscillator& o, double dt) {
    const double n = o.weight(), kick = (last + dt) / 2 * o.acceleration();
    last = dt;
    o.x += dt * n * (o.v + kick);
    o.v += n * kick;
    o.stretch(dt * o.v / o.h);
  });
}

}  // namespace
}  // namespace plumbline::central_difference_test
