// Intervals along one coordinate share a measure equally, whatever it is.
#include "cases/catalog/gas/intervals.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::intervals_test {
namespace {

constexpr double rounding = 1e-13;

// Gauss's rule of five points: exact to degree nine, and not beyond.
TEST(Intervals, TheIntegralIsExactToDegreeNine) {
  for (int degree = 0; degree <= 9; ++degree) {
    const auto power = [degree](double s) { return std::pow(s, degree); };
    const double exact = (std::pow(1.5, degree + 1) - std::pow(0.5, degree + 1)) / (degree + 1);
    EXPECT_NEAR(integral(power, {0.5, 1.5}), exact, rounding * exact) << degree;
  }
  const auto tenth = [](double s) { return std::pow(s, 10); };
  EXPECT_GT(std::abs(integral(tenth, {-1, 1}) - 2.0 / 11), 1e-6);
}

TEST(Intervals, AMeanOfAConstantIsThatConstant) {
  const auto weight = [](double s) { return 1 + s * s; };
  EXPECT_EQ(weighted_mean([](double) { return 0.3; }, weight, {0.1, 0.7}), 0.3);
  // Of s under 1 + s^2 over [0, 1]: (1/2 + 1/4)/(1 + 1/3).
  EXPECT_NEAR(weighted_mean([](double s) { return s; }, weight, {0, 1}), 0.75 / (4.0 / 3), rounding);
}

TEST(Intervals, LayersLieBetweenTheJumpsWithin) {
  const auto all = layers(0, 1, {-0.5, 0.25, 0.75, 1.0, 2});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].to, 0.25);
  EXPECT_EQ(all[2].from, 0.75);
  EXPECT_EQ(all[2].to, 1.0);
}

TEST(Intervals, TheLargestValueIsNotAskedForAtAJump) {
  const auto f = [](double s) { return s == 0.5 || s == 0 || s == 1 ? 1e9 : (s < 0.5 ? 2.0 : 1.0); };
  EXPECT_EQ(largest(f, layers(0, 1, {0.5})), 2);
}

TEST(Intervals, SharesAreEqualAndNotAboveOne) {
  for (const auto& [name, measure] : std::vector<std::pair<const char*, std::function<double(double)>>>{
           {"smooth", [](double s) { return 40 * (1 + 0.9 * std::sin(5 * s)); }},
           {"steep", [](double s) { return std::exp(8 * s); }},
           {"kinked", [](double s) { return std::max(100 * s, 10.0); }}}) {
    const auto all = equal_shares({0, 1}, measure);
    double total = 0;
    for (const Interval& at : all) total += integral(measure, at);
    EXPECT_EQ(all.size(), static_cast<std::size_t>(std::ceil(total - 1e-9))) << name;
    EXPECT_EQ(all.front().from, 0);
    EXPECT_EQ(all.back().to, 1);
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (k > 0) {
        EXPECT_EQ(all[k].from, all[k - 1].to);
      }
      // A kink costs the quadrature some digits in the interval that has it.
      EXPECT_NEAR(integral(measure, all[k]), total / static_cast<double>(all.size()),
                  1e-2 / 1e6 + (name[0] == 'k' ? 2e-2 : 0))
          << name << k;
    }
  }
}

TEST(Intervals, AUniformMeasureGivesUniformIntervals) {
  const auto all = equal_shares({-1, 3}, [](double) { return 25.0; });
  ASSERT_EQ(all.size(), 100u);  // a share of exactly 1 needs no further interval
  for (std::size_t k = 0; k < all.size(); ++k)
    EXPECT_NEAR(all[k].from, -1 + 0.04 * static_cast<double>(k), 4 * rounding);
}

TEST(Intervals, NearlyNothingIsOneInterval) {
  const auto all = equal_shares({0, 1e-3}, [](double) { return 1e-6; });
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].length(), 1e-3);
}

}  // namespace
}  // namespace plumbline::intervals_test
