#include "cases/harness/compare/two_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace plumbline::two_samples_test {
namespace {

TEST(TimeRatio, OfEqualSamplesIsOne) {
  const std::vector<double> times{1.0, 1.1, 1.2, 1.3, 1.4};
  const TimeRatio ratio = time_ratio(times, times);
  EXPECT_DOUBLE_EQ(ratio.estimate, 1);
  EXPECT_LT(ratio.low, 1);
  EXPECT_GT(ratio.high, 1);
}

// Table A.6 of Hollander, Wolfe, Chicken: P(U <= 2) = 4/252 and P(U <= 3) = 7/252 for samples of five and five, so
// the interval leaves out two ratios at each end.
TEST(TimeRatio, LeavesOutWhatTheExactDistributionAllows) {
  const std::vector<double> first{1, 1, 1, 1, 1}, second{1, 2, 3, 4, 5};
  const TimeRatio ratio = time_ratio(first, second);
  EXPECT_DOUBLE_EQ(ratio.estimate, 3);
  EXPECT_DOUBLE_EQ(ratio.low, 1);
  EXPECT_DOUBLE_EQ(ratio.high, 5);
  // Of ten and ten P(U <= 23) = 0.0216 and P(U <= 24) = 0.0262: 23 are left out.
  std::vector<double> ones(10, 1.0), grows;
  for (int k = 0; k < 10; ++k) grows.push_back(1 + k);
  EXPECT_DOUBLE_EQ(time_ratio(ones, grows).low, 3) << "ratios come in tens: number 24 is the fourth of the third ten";
  EXPECT_DOUBLE_EQ(time_ratio(ones, grows).high, 8);
}

TEST(TimeRatio, OfThreeAndThreeHasNoInterval) {
  const std::vector<double> a{1, 1, 1}, b{9, 9, 9}, c{1, 1, 1, 1}, d{9, 9, 9, 9};
  EXPECT_DOUBLE_EQ(time_ratio(a, b).estimate, 9);
  EXPECT_TRUE(std::isinf(time_ratio(a, b).high));
  EXPECT_EQ(time_ratio(a, b).low, 0);
  EXPECT_DOUBLE_EQ(time_ratio(c, d).low, 9) << least_samples << " and as many have one";
}

TEST(TimeRatio, RefusesWhatIsNoTime) {
  const std::vector<double> good{1, 2}, none, zero{1, 0}, nan{1, std::nan("")};
  EXPECT_THROW(time_ratio(good, none), std::invalid_argument);
  EXPECT_THROW(time_ratio(zero, good), std::invalid_argument);
  EXPECT_THROW(time_ratio(good, nan), std::invalid_argument);
}

// 95 % of intervals hold the true ratio, whatever the distribution; the discrete statistic makes it a little more.
TEST(TimeRatio, IntervalHoldsTheTruthAsOftenAsItSays) {
  std::mt19937 random(1);
  std::lognormal_distribution<double> noise(0, 0.3);
  int held = 0;
  constexpr int studies = 4000;
  for (int study = 0; study < studies; ++study) {
    std::vector<double> first, second;
    for (int k = 0; k < 7; ++k) first.push_back(noise(random));
    for (int k = 0; k < 6; ++k) second.push_back(1.2 * noise(random));
    const TimeRatio ratio = time_ratio(first, second);
    held += ratio.low <= 1.2 && 1.2 <= ratio.high ? 1 : 0;
  }
  const double share = static_cast<double>(held) / studies, scatter = std::sqrt(0.95 * 0.05 / studies);
  EXPECT_GT(share, 0.95 - 3 * scatter);
  EXPECT_LT(share, 0.98);
}

}  // namespace
}  // namespace plumbline::two_samples_test
