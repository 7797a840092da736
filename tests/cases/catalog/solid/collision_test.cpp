// What is watched of bodies that meet.
#include "cases/catalog/solid/collision.hpp"

#include <gtest/gtest.h>

#include "kernel/materials/linear_elastic.hpp"

namespace plumbline::collision_test {
namespace {

// Two points of masses 1 and 3 on a line.
Body pair(double v1, double v2) {
  auto law = std::make_shared<LinearElastic>();
  law->youngs_modulus = 100;
  law->density = 1;
  Body body = make_body("pair", law, 2, 1);
  const double mass[] = {1, 3}, x[] = {0.2, 0.6}, v[] = {v1, v2};
  for (int p = 0; p < 2; ++p) {
    body.points(column::mass)[p] = body.points(column::volume)[p] = mass[p];
    body.points(column::position)[p] = x[p];
    body.points(column::velocity)[p] = v[p];
  }
  return body;
}

TEST(CollisionWatch, MotionOfABody) {
  const BodyMotion motion = motion_of(pair(1, 5), 1);
  EXPECT_DOUBLE_EQ(motion.mass, 4);
  EXPECT_DOUBLE_EQ(motion.position[0], 0.5);
  EXPECT_DOUBLE_EQ(motion.velocity[0], 4);
  EXPECT_EQ(motion.velocity[1], 0);
  EXPECT_EQ(highest_point(pair(0, 0), 0), 0.6);
  EXPECT_EQ(lowest_point(pair(0, 0), 0), 0.2);
}

// A steady push from 0.25 to 0.75, sampled at uneven times; and none.
TEST(CollisionWatch, StartAndEndOfAPush) {
  PushWatch steady(0, 3);
  for (double t : {0.1, 0.25, 0.26, 0.4, 0.55, 0.75, 0.8, 1.0}) {
    steady.observe(t, 3 + 8 * (std::min(std::max(t, 0.25), 0.75) - 0.25));
  }
  EXPECT_NEAR(steady.start(), 0.25, 1e-12);
  EXPECT_NEAR(steady.end(), 0.75, 1e-12);
  EXPECT_NEAR(steady.duration(), 0.5, 1e-12);
  PushWatch nothing(0, 3);
  nothing.observe(pair(0, 1), 1, 0.1);
  EXPECT_TRUE(std::isnan(nothing.start()));
  EXPECT_TRUE(std::isnan(nothing.duration()));
}

// A free rod in flight neither gains nor loses. One that is stretched and let go vibrates, and under a step of first
// order its energy swings: that is seen.
TEST(CollisionWatch, EnergyThatRisesIsSeen) {
  const auto rise = [](double strain) {
    auto law = std::make_shared<LinearElastic>();
    law->youngs_modulus = 100;
    law->density = 1;
    Body rod = make_body("rod", law, 20, 1);
    for (int p = 0; p < 20; ++p) {
      rod.points(column::mass)[p] = rod.points(column::volume)[p] = 0.05;
      rod.points(column::position)[p] = 0.5 + (p + 0.5) * 0.05;
      rod.points(column::velocity)[p] = 1;
      rod.points(column::strain)[p] = strain;
    }
    Scene scene;
    scene.grid.cells = {30, 1, 1};
    scene.grid.h = 0.1;
    scene.transfer = "flip";
    scene.bodies.push_back(std::move(rod));
    Simulation simulation(scene, "musl", {0.3, 5e-3});
    EnergyWatch energy;
    MomentumWatch momentum(0);
    for (int step = 0; step < 100; ++step) {
      simulation.step(5e-3);
      energy.observe(simulation);
      momentum.observe(simulation);
    }
    EXPECT_LE(momentum.largest_error(), 1e-13);
    EXPECT_GE(energy.highest(), 1);
    return energy.largest_rise();
  };
  EXPECT_LE(rise(0), 1e-14);
  EXPECT_GT(rise(0.05), 1e-6);
}

}  // namespace
}  // namespace plumbline::collision_test
