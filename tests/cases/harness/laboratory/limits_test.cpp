#include "cases/harness/laboratory/limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::limits_test {
namespace {

// A step whose radius is known: stable up to 1, unstable to 1.5, stable again up to 3. Radii rise in a line, or as a root does.
Growth islands(double dt, const std::vector<WaveNumber>&) {
  double radius = 0.9;
  if (dt > 1 && dt < 1.5) radius = 1 + 0.2 * std::min(dt - 1, 1.5 - dt);
  if (dt > 3) radius = 1 + std::sqrt(dt - 3);
  return {dt, radius, {dt, 0}};
}

TEST(Scan, StepsAreEvenInTheLogarithm) {
  const std::vector<double> steps = Scan{0.5, 8, 5}.values();
  ASSERT_EQ(steps.size(), 5U);
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(steps[static_cast<std::size_t>(k)], std::ldexp(1, k - 1), 1e-14);
}

// All of them, not the first alone; each is where the radius leaves one, not where it passes the threshold of 1 + 1e-6,
// 5e-6 later for the linear rise.
TEST(Limits, EveryStableIntervalIsFound) {
  const Prediction found = predict(GrowthOfStep(islands), {0.3, 6, 40});
  ASSERT_EQ(found.stable.size(), 2U);
  EXPECT_EQ(found.stable[0].low, 0);
  EXPECT_NEAR(found.stable[0].high, 1, 1e-8);
  EXPECT_NEAR(found.stable[1].low, 1.5, 1e-8);
  EXPECT_NEAR(found.stable[1].high, 3, 1e-8);
  EXPECT_EQ(found.limit(), found.stable[0].high);
  EXPECT_FALSE(found.always_stable());
  EXPECT_FALSE(found.always_unstable());
  ASSERT_EQ(found.growth.size(), 40U);
  EXPECT_EQ(found.growth.front().dt, 0.3);
}

// From the smallest step on; beyond the first that grows nothing is looked at.
TEST(Limits, TheFirstAloneIfAskedFor) {
  double largest = 0;
  const auto watched = [&](double dt, const std::vector<WaveNumber>& hints) {
    largest = std::max(largest, dt);
    return islands(dt, hints);
  };
  const Scan scan{.low = 0.3, .high = 6, .steps = 40, .first_limit_only = true};
  const Prediction found = predict(GrowthOfStep(watched), scan);
  ASSERT_EQ(found.stable.size(), 1U);
  EXPECT_EQ(found.stable[0].low, 0);
  EXPECT_NEAR(found.limit(), 1, 1e-8);
  EXPECT_LT(largest, 1.1);
  const Scan above{.low = 1.2, .high = 6, .steps = 40, .first_limit_only = true};
  EXPECT_TRUE(predict(GrowthOfStep(watched), above).always_unstable());
  const Scan below{.low = 0.3, .high = 0.9, .steps = 4, .first_limit_only = true};
  EXPECT_TRUE(predict(GrowthOfStep(watched), below).always_stable());
}

TEST(Limits, NoneAndAll) {
  const Scan scan{0.1, 10, 8};
  const Prediction never = predict(GrowthOfStep([](double dt, const auto&) { return Growth{dt, 1.1, {}}; }), scan);
  EXPECT_TRUE(never.always_unstable());
  EXPECT_EQ(never.limit(), 0);
  const Prediction always = predict(GrowthOfStep([](double dt, const auto&) {
                                      return Growth{dt, 1 + 9e-7, {}};
                                    }),
                                    scan);
  EXPECT_TRUE(always.always_stable());
  EXPECT_TRUE(std::isinf(always.limit()));
}

// A wave that grows at an unstable step is looked at again at the steps between.
TEST(Limits, HintsAreWavesThatGrow) {
  bool hinted = false;
  predict(GrowthOfStep([&](double dt, const std::vector<WaveNumber>& hints) {
            for (const WaveNumber& wave : hints) {
              hinted = true;
              EXPECT_GT(wave[0], 1);
            }
            return Growth{dt, dt < 2 ? 0.5 : 2.0, {dt, 0}};
          }),
          {0.5, 4, 6});
  EXPECT_TRUE(hinted);
}

TEST(Limits, RunsBracketEveryLimit) {
  const Scan scan{0.3, 6, 40};
  Watch watch;
  watch.width = 1e-3;
  const auto run = [](double dt) {
    plumbline::Run result;
    result.growth = islands(dt, {}).per_step;
    result.unstable = result.growth > 1;
    return result;
  };
  const Observation seen = observe(run, scan, watch);
  ASSERT_EQ(seen.brackets.size(), 3U);
  const double limits[] = {1, 1.5, 3};
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LE(seen.brackets[k].low, limits[k]);
    EXPECT_GE(seen.brackets[k].high, limits[k]);
    EXPECT_LE(seen.brackets[k].high - seen.brackets[k].low, 1e-3 * seen.brackets[k].high);
    EXPECT_EQ(seen.brackets[k].stable_below, k != 1);
  }
  EXPECT_FALSE(seen.always_stable || seen.always_unstable);
  EXPECT_EQ(seen.growth.size(), 40U);
}

// An unstable interval that one step of the scan meets: each of its ends lies in a bracket of its own, which halving from two
// neighbouring steps of the scan narrows as fast as it can.
TEST(Limits, RunsBracketBothEndsOfAnIslandOfOneStep) {
  const Scan scan{1, 16, 5};  // 1, 2, 4, 8, 16
  Watch watch;
  watch.width = 1e-3;
  int runs = 0;
  const auto run = [&](double dt) {
    ++runs;
    plumbline::Run result;
    result.unstable = dt > 2.5 && dt < 5.3;
    result.growth = result.unstable ? 1.1 : 0.9;
    return result;
  };
  const Observation seen = observe(run, scan, watch);
  ASSERT_EQ(seen.brackets.size(), 2U);
  const double ends[] = {2.5, 5.3};
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LE(seen.brackets[k].low, ends[k]);
    EXPECT_GE(seen.brackets[k].high, ends[k]);
    EXPECT_EQ(seen.brackets[k].stable_below, k == 0);
  }
  // (4 - 2)/2^n <= 1e-3 2.5 and (8 - 4)/2^n <= 1e-3 5.3
  EXPECT_EQ(runs, 5 + 10 + 10);
}

}  // namespace
}  // namespace plumbline::limits_test
