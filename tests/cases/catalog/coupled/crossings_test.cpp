// Zero crossings of sampled histories.
#include "cases/catalog/coupled/crossings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace plumbline::crossings_test {
namespace {

struct History {
  std::vector<double> times, values;
};

History sampled(double omega, double step, double end, double offset = 0, double phase = 0) {
  History h;
  for (int k = 0; k * step <= end; ++k) {
    h.times.push_back(k * step);
    h.values.push_back(offset - std::sin(omega * k * step + phase));
  }
  return h;
}

TEST(Crossings, PeriodOfASine) {
  const double omega = 886, period = 2 * std::numbers::pi / omega, step = 7e-6;
  const History h = sampled(omega, step, 0.015, 0, 0.3);
  const auto found = crossing_period(h.times, h.values);
  ASSERT_TRUE(found);
  // two crossings, each off by omega^2 tau^3/(36 sqrt 3)
  EXPECT_NEAR(*found, period, 2 * omega * omega * step * step * step / (36 * std::sqrt(3.0)));
}

TEST(Crossings, BothDirectionsCount) {
  // Up at 1 and 5, down at 3 and 9: periods of 4 and 6, two in all.
  const std::vector<double> times{0, 2, 4, 6, 10, 12}, values{-1, 1, -1, 1, -1.0 / 3, -1};
  EXPECT_NEAR(crossing_period(times, values).value(), (4.0 + 6.0) / 2, 1e-12);
}

TEST(Crossings, AnOffsetMovesAllOfADirectionAlike) {
  const History h = sampled(2, 1e-3, 20, 0.2);
  EXPECT_NEAR(crossing_period(h.times, h.values).value(), std::numbers::pi, 1e-9);
}

TEST(Crossings, TooFew) {
  EXPECT_FALSE(crossing_period({}, {}));
  EXPECT_FALSE(crossing_period(std::vector<double>{0, 1, 2}, std::vector<double>{-1, 1, -1}));
  EXPECT_THROW(crossing_period(std::vector<double>{0, 1}, std::vector<double>{1}), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::crossings_test
