// Growth in small steps, of steps whose spectral radius is known in closed form.
#include "cases/harness/integrators/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/cases/harness/laboratory/made_up_integrators.hpp"

namespace plumbline::growth_test {
namespace {

TEST(SmallSteps, FindThePowerOfTheGrowth) {
  for (const double power : {1.0, 2.0, 3.0}) {
    const SmallSteps steps = small_steps([&](double dt) { return std::exp(0.3 * std::pow(dt, power)); });
    ASSERT_EQ(steps.dt.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_EQ(steps.dt[k], std::ldexp(1, -static_cast<int>(k)));
      EXPECT_NEAR(steps.growth[k], 0.3 * std::pow(steps.dt[k], power), 1e-14);
    }
    EXPECT_NEAR(steps.power, power, 1e-9);
  }
}

TEST(SmallSteps, WhatIsRoundingOrDoesNotFallHasNoPower) {
  EXPECT_EQ(small_steps([](double) { return 1.0; }).power, 0);
  EXPECT_EQ(small_steps([](double dt) { return std::exp(1e-14 * dt); }).power, 0);
  EXPECT_EQ(small_steps([](double dt) { return std::exp(0.1 / dt); }).power, 0);
}

// Euler's step grows by sqrt(1 + dt^2).
TEST(SmallSteps, OnTheOscillator) {
  const SmallSteps steps = small_steps_on_oscillator(Subject({made_up::forward_euler, {}}));
  for (std::size_t k = 0; k < steps.dt.size(); ++k)
    EXPECT_NEAR(steps.growth[k], 0.5 * std::log1p(steps.dt[k] * steps.dt[k]), 1e-9);
  EXPECT_NEAR(steps.power, 2, steps.dt[3] * steps.dt[3]);
}

}  // namespace
}  // namespace plumbline::growth_test
