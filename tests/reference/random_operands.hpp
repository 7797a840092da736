#pragma once
// Random numbers with bounds, and long doubles from inside the bounds: the true operands.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "reference/bounded.hpp"

namespace plumbline::reference {

class RandomBalls : public ::testing::Test {
 protected:
  explicit RandomBalls(unsigned seed) : engine(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  double signed_log(double low_decade, double high_decade) {
    return (uniform(0, 1) < 0.5 ? -1 : 1) * std::pow(10.0, uniform(low_decade, high_decade));
  }
  Bounded ball(double value) {
    return {value, uniform(0, 1) < 0.3 ? 0 : std::abs(value) * std::pow(10.0, uniform(-17, 0.3))};
  }
  long double inside(Bounded x) {
    const double kind = uniform(0, 1);  // the ends of the interval are the likeliest to be missed
    const long double share = kind < 0.3 ? -1 : kind < 0.6 ? 1 : uniform(-1, 1);
    return x.value + share * x.bound;
  }
  static void expect_covers(Bounded result, long double truth, const char* operation) {
    if (std::isinf(result.bound)) return;
    EXPECT_LE(std::abs(static_cast<long double>(result.value) - truth), result.bound) << operation;
  }

  std::mt19937_64 engine;
};

}  // namespace plumbline::reference
