// A rigid ball thrown back by a net without mass: geometry, work and time.
#include "cases/catalog/solid/net_throw.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace plumbline::net_throw_test {
namespace {

NetBall yorks() { return {1.5, std::numbers::pi * 2.25, 1, 10, 125}; }

// A flat net touches in one point; pushed by the radius, the centre stands between the supports: tangents of
// sqrt(25 - R^2) and an arc of twice 90 degrees - acos(R/5).
TEST(NetThrow, Lengths) {
  const NetBall ball = yorks();
  EXPECT_NEAR(net_length(ball, 0), 10, 1e-14);
  const double arc = 0.5 * std::numbers::pi - std::acos(0.3);
  EXPECT_NEAR(net_length(ball, 1.5), 2 * (std::sqrt(25 - 2.25) + 1.5 * arc), 1e-14);
}

// The force is the slope of the stored energy, E A L eps^2 / 2.
TEST(NetThrow, ForceIsTheSlopeOfTheEnergy) {
  const NetBall ball = yorks();
  const auto energy = [&](double x) {
    const double strain = net_length(ball, x) / ball.length - 1;
    return 0.5 * ball.stiffness * ball.length * strain * strain;
  };
  for (double x : {0.3, 1.0, 1.9, 3.0}) {
    const double step = 1e-4;
    EXPECT_NEAR(net_force(ball, x), (energy(x + step) - energy(x - step)) / (2 * step), 1e-6 * net_force(ball, x));
  }
}

// The same motion by small steps of velocity and place.
TEST(NetThrow, DurationAndDepthOfAStepByStepMotion) {
  const NetBall ball = yorks();
  const NetThrow thrown = throw_of_net(ball);
  double x = 0, v = 1, t = 0, deepest = 0;
  const double dt = 1e-4;
  do {
    v -= 0.5 * dt * net_force(ball, x) / ball.mass;
    x += dt * v;
    v -= 0.5 * dt * net_force(ball, x) / ball.mass;
    t += dt;
    deepest = std::max(deepest, x);
  } while (x > 0);
  t += x / -v;  // back to where it was
  EXPECT_NEAR(thrown.deepest, deepest, 1e-7);
  EXPECT_NEAR(thrown.duration, t, 1e-6);
  EXPECT_NEAR(thrown.force, net_force(ball, deepest), 1e-6);
}

}  // namespace
}  // namespace plumbline::net_throw_test
