#include "cases/harness/integrators/extrapolation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "cases/harness/integrators/measured_limit.hpp"

namespace plumbline::extrapolation_test {
namespace {

// Values of f at dt, dt/2, ...
template <class Function>
std::vector<std::vector<double>> halvings(int count, Function&& f) {
  std::vector<std::vector<double>> values;
  double dt = 0.1;
  for (int k = 0; k < count; ++k, dt /= 2) values.push_back(f(dt));
  return values;
}

// A polynomial in dt is extrapolated to rounding, whatever its lowest power.
TEST(StepLimit, OfPolynomials) {
  const auto first = [](double dt) { return std::vector<double>{3e-3 + 2 * dt - 7 * dt * dt, dt * dt * dt}; };
  const StepLimit limit = limit_of_halvings(halvings(5, first));
  EXPECT_NEAR(limit.size, 3e-3, 1e-14);
  EXPECT_LE(limit.uncertainty, 1e-14);
  EXPECT_FALSE(limit.stalls());
}

// Where a function of dt has a kink the uncertainty covers what is left.
TEST(StepLimit, OfKinks) {
  for (const double kink : {0.011, 0.02, 0.037}) {
    const StepLimit limit = limit_of_halvings(
        halvings(6, [&](double dt) { return std::vector<double>{dt + std::max(0.0, dt - kink)}; }));
    EXPECT_LE(limit.size, 3 * limit.uncertainty + 1e-15) << kink;
  }
}

TEST(StepLimit, WhatStallsIsSaid) {
  EXPECT_TRUE(limit_of_halvings({{1.0}, {0.98}, {1.01}, {0.99}}).stalls());
  EXPECT_FALSE(limit_of_halvings({{1.0}, {0.5}, {0.25}}).stalls());
  EXPECT_THROW(limit_of_halvings({{1.0}, {0.5}}), std::invalid_argument);
}

// A limit of zero and one of one per mille behind an error of first order fifty times as large, from the same step sizes.
TEST(MeasuredLimit, TellsOnePerMilleFromNone) {
  for (const double left : {0.0, 1e-3, 1e-4}) {
    const Measured measured = measured_limit(
        {8, 4, 8}, [&](int steps) { return std::vector<double>{left + 0.4 / steps + 0.1 * std::exp(-steps / 9.0)}; });
    EXPECT_EQ(measured.interval->second <= most_left_over, left == 0) << left;
    EXPECT_EQ(measured.interval->first > most_left_over, left != 0) << left;
  }
}

// What jumps to and fro with the step count, and does not fall, is over the bound.
TEST(MeasuredLimit, OfWhatDoesNotFall) {
  const Measured jumps = measured_limit(
      {8, 4, 8}, [](int steps) { return std::vector<double>{0.01 * (1 + std::cos(1.0 * steps))}; });
  EXPECT_GT(jumps.interval->first, most_left_over);
}

// Of less than first order, as no integrator may be: never green.
TEST(MeasuredLimit, OfHalfOrderIsNotMet) {
  const Measured slow = measured_limit({8, 4, 8},
                                       [](int steps) { return std::vector<double>{0.1 / std::sqrt(steps)}; });
  EXPECT_GT(slow.interval->second, most_left_over);
}

}  // namespace
}  // namespace plumbline::extrapolation_test
