// Block and disk on an incline: Newton's and Coulomb's laws, thresholds, growth of gravity.
#include "reference/incline.hpp"

#include "tests/reference/flow_checks.hpp"

namespace plumbline::reference::incline_test {
namespace {

TEST(InclinePublished, ByHand) {  // a 3-4-5 incline: sin 0.6, cos 0.8 [Goldstein 1.4]
  const Incline incline({0.75, 0.25, 10, 0});
  expect_near(incline.along(), 6, 1e-10);
  expect_near(incline.across(), 8, 1e-10);
  expect_near(incline.block_acceleration(), 4, 1e-10);
  expect_near(incline.disk_acceleration(), 4, 1e-10);  // at tan = 3 mu both are one
  expect_near(incline.disk_spin_up(), 4, 1e-10);
  expect_near(incline.block_friction_work(2), 2 * 8, 1e-10);  // mu g cos(theta) times the way a t^2/2
}

TEST(InclineIdentity, NewtonAndTheLimits) {
  const Incline rolls({0.5, 0.3, 9.81, 0}), slides({1.5, 0.3, 9.81, 0});
  EXPECT_TRUE(rolls.disk_rolls());
  EXPECT_FALSE(slides.disk_rolls());
  for (const Incline& disk : {rolls, slides}) {  // (m R^2/2) w' = F R and m a = m g sin - F
    const Bounded force = Bounded(0.5) * disk.disk_spin_up();
    expect_zero(disk.along() - force - disk.disk_acceleration(), 10, "both laws of motion");
    EXPECT_LE(force.value, 0.3 * disk.across().value * (1 + 1e-14));
  }
  EXPECT_EQ(Incline({0.3, 0.3, 1, 0}).block_acceleration().value, 0);
  EXPECT_EQ(Incline({0.2, 0.3, 1, 0.5}).block_friction_work(2).value, 0);
}

TEST(InclineIdentity, GrowingGravity) {
  const Incline incline({0.6, 0.3, 1, 0.5});
  const auto growth = [](double t) { return t < 0.5 ? t * t / 0.25 * (3 - 2 * t / 0.5) : 1.0; };
  for (const double t : {0.1, 0.3, 0.5, 0.8}) {
    EXPECT_NEAR(incline.velocity_time(t).value, over_body(1, 0, t, growth) / sphere_measure(1).value, 1e-10) << t;
    const auto velocity = [&](double at) { return incline.velocity_time(at).value; };
    EXPECT_NEAR(incline.way_time(t).value, over_body(1, 0, t, velocity) / sphere_measure(1).value, 1e-10) << t;
    const auto power = [&](double at) {
      return 0.3 * incline.across().value * growth(at) * incline.block_acceleration().value * velocity(at);
    };
    EXPECT_NEAR(incline.block_friction_work(t).value, over_body(1, 0, t, power) / sphere_measure(1).value, 1e-10) << t;
  }
}

TEST(InclineProblem, WrongProblemsAreRefusedByKey) {
  const auto key = refused_change<Incline, InclineProblem>;
  EXPECT_EQ(key([](auto& p) { p.slope = -0.1; }), "slope");
  EXPECT_EQ(key([](auto& p) { p.friction = -1; }), "friction");
  EXPECT_EQ(key([](auto& p) { p.gravity = 0; }), "gravity");
  EXPECT_EQ(key([](auto& p) { p.rise = NAN; }), "rise");
}

}  // namespace
}  // namespace plumbline::reference::incline_test
