// One integration of the elastic pendulum: order of the method, changes of the string, turning points.
#include "reference/swing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::reference::swing_test {
namespace {

/// Of unit mass, length and gravity: kinetic, of height, of the string.
double energy(double kappa, const SwingState& y) {
  const double r = 1 + y[0] / kappa, outward = y[1] / kappa, around = r * y[3];
  const double pull = y[0];
  return 0.5 * (outward * outward + around * around) - r * std::cos(y[2]) + 0.5 * pull * pull / kappa;
}

TEST(Swing, ConvergesWithTheEighthOrder) {
  auto at_two = [](double step) {
    Swing swing(50, false, {0, 0, 0.9, 0}, step);
    swing.advance_to(2);
    return swing.state();
  };
  const SwingState exact = at_two(0.003);
  for (std::size_t i = 0; i < 4; ++i) {
    const double coarse = std::abs(at_two(0.125)[i] - exact[i]), fine = std::abs(at_two(0.0625)[i] - exact[i]);
    EXPECT_GT(coarse / fine, 100) << i;  // 2^8 = 256 and higher orders
  }
}

TEST(Swing, KeepsTheEnergyWhileTaut) {
  const double kappa = 30;
  Swing swing(kappa, false, {6, 0, 1.2, 0}, 0.01);
  const double start = energy(kappa, swing.state());
  for (double t : {1.0, 4.0, 9.0}) {
    swing.advance_to(t);
    EXPECT_EQ(swing.time(), t);
    EXPECT_NEAR(energy(kappa, swing.state()), start, 1e-12);
  }
}

TEST(Swing, StopsAndBeginsToCarryAtZeroTension) {
  const double kappa = 100;
  Swing swing(kappa, true, {5, 0, 0.5, 0}, 0.02);  // stretched fivefold: it flies up past zero tension
  bool was_taut = swing.taut();
  int changes = 0;
  const double start = energy(kappa, swing.state());
  for (int i = 1; i <= 3000; ++i) {
    swing.advance_to(i * 1e-3);
    if (swing.taut() != was_taut) ++changes;
    was_taut = swing.taut();
    const double kinetic_and_height = energy(kappa, {0, 0, 0, 0}) + 1;
    SwingState y = swing.state();
    EXPECT_GE(swing.taut() ? y[0] : -y[0], -1e-11);
    const double stored = swing.taut() ? 0 : 0.5 * y[0] * y[0] / kappa;
    EXPECT_NEAR(energy(kappa, y) - stored + kinetic_and_height, start, 1e-10);
  }
  EXPECT_GE(changes, 4);
}

TEST(Swing, FallsFreelyWhileSlack) {
  const double kappa = 100, angle = 0.4, r = 1 - 0.05;
  Swing swing(kappa, true, {-5, 0, angle, 0}, 0.01);
  ASSERT_FALSE(swing.taut());
  swing.advance_to(0.2);
  ASSERT_FALSE(swing.taut());
  const double length = 1 + swing.state()[0] / kappa, now = swing.state()[2];
  EXPECT_NEAR(length * std::sin(now), r * std::sin(angle), 1e-12);
  EXPECT_NEAR(length * std::cos(now), r * std::cos(angle) + 0.02, 1e-12);  // t^2/2
}

TEST(Swing, FindsABriefSlackWithinOneStep) {
  // s = 1 + 1.002 cos(10 t) is below zero for 0.0126 around t = 0.314: inside the step from 0.30 to 0.35
  auto later = [](bool one_way, double step) {
    Swing swing(100, one_way, {2.002, 0, 1e-9, 0}, step);
    swing.advance_to(0.6);
    return swing.state()[1];
  };
  EXPECT_GT(std::abs(later(true, 0.001) - later(false, 0.001)), 1e-4);
  EXPECT_NEAR(later(true, 0.05), later(true, 0.001), 1e-7);
}

TEST(Swing, TurningPointsAndCrossingsAlternate) {
  Swing swing(1000, true, {0, 0, -0.6, 0}, 0.01);
  double last = 0;
  for (int i = 0; i < 6; ++i) {
    swing.advance_to_change(2);
    EXPECT_GT(swing.time(), last);
    EXPECT_EQ(swing.state()[2], 0);
    EXPECT_GT((i % 2 == 0 ? 1 : -1) * swing.state()[3], 0);
    last = swing.time();
    swing.advance_to_change(3);
    EXPECT_GT(swing.time(), last);
    EXPECT_EQ(swing.state()[3], 0);
    EXPECT_GT((i % 2 == 0 ? 1 : -1) * swing.state()[2], 0);
    last = swing.time();
  }
}

}  // namespace
}  // namespace plumbline::reference::swing_test
