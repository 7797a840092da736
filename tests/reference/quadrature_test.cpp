#include "reference/quadrature.hpp"

#include <gtest/gtest.h>

#include "reference/exponential.hpp"

namespace plumbline::reference::quadrature_test {
namespace {

void expect_covers(Bounded integral, double true_value, double margin) {
  EXPECT_LE(std::abs(integral.value - true_value), integral.bound + rounding::unit * std::abs(true_value));
  EXPECT_LE(integral.bound, margin);
}

TEST(Quadrature, SmoothFunctions) {
  expect_covers(integrate([](double x) { return power(Bounded(x), 7); }, 0, 2), 32, 1e-12);
  expect_covers(integrate([](double x) { return exp(Bounded(x)); }, -1, 1), 2 * std::sinh(1.0), 1e-13);
  expect_covers(integrate([](double x) { return Bounded(1) / (Bounded(1e-4) + Bounded(x) * x); }, -1, 1),
                200 * std::atan(100.0), 1e-10);  // a peak of width 0.01: halved
}

TEST(Quadrature, RootsAtTheEndsAreFoundByHalving) {
  expect_covers(integrate([](double x) { return sqrt(Bounded(x)); }, 0, 1), 2.0 / 3, 1e-13);
  expect_covers(integrate([](double x) { return pow(Bounded(1) - x, Bounded(2.5)); }, 0, 1), 2 / 7.0, 1e-13);
}

TEST(Quadrature, WhatTheRulesDisagreeAboutIsInTheBound) {  // a step: halved as often as allowed, 2^-40 is left
  for (double step : {1.0 / 3, 0.1, 0.77, 0.513}) {
    const Bounded area = integrate([step](double x) { return Bounded(x < step ? 0 : 1); }, 0, 1);
    expect_covers(area, 1 - step, 1e-10);
  }
}

TEST(Quadrature, TheFunctionsOwnBoundIsCarried) {
  const Bounded area = integrate([](double x) { return Bounded(x, 0.01); }, 0, 3);
  EXPECT_NEAR(area.bound, 0.03, 1e-6);
  EXPECT_NEAR(area.value, 4.5, 1e-13);
}

TEST(Exponential, BoundsCoverTheInterval) {
  for (double x : {-30.0, -1.0, 0.0, 0x1p-40, 0.375, 5.0, 80.0}) {
    const double reach = 0x1p-10;
    const Bounded wide(x, reach), e = exp(wide), slope = expm1_over(wide);
    for (double shift : {-reach, 0.0, reach}) {
      const double at = x + shift;
      EXPECT_LE(std::abs(std::exp(at) - e.value), e.bound);
      EXPECT_LE(std::abs((at == 0 ? 1 : std::expm1(at) / at) - slope.value), slope.bound);
    }
    EXPECT_LE(expm1_over(x).bound, 4 * rounding::unit * expm1_over(x).value);
  }
}

TEST(Exponential, DividedDifferencesAreOneAtZero) {
  EXPECT_EQ(expm1_over(0.0).value, 1);
  EXPECT_EQ(log1m_over(0.0).value, 1);
  EXPECT_LE(expm1_over({0, 1e-300}).bound, 1e-15);
  EXPECT_NEAR(expm1_over(1e-8).value, 1 + 0.5e-8, 1e-15);
  EXPECT_NEAR(log1m_over(1e-8).value, 1 + 0.5e-8, 1e-15);
  EXPECT_NEAR(log1m_over(0.5).value, 2 * std::log(2.0), 1e-15);
  EXPECT_NEAR(log1m_over(-1.0).value, std::log(2.0), 1e-15);
  const Bounded wide = log1m_over({0.2, 0.1});
  for (double at : {0.1, 0.3}) EXPECT_LE(std::abs(-std::log1p(-at) / at - wide.value), wide.bound);
}

TEST(Exponential, WholePowers) {
  EXPECT_EQ(power(3.0, 0).value, 1);
  EXPECT_EQ(power(3.0, 4).value, 81);
  const Bounded wide = power({2, 0.01}, 3);
  EXPECT_GE(wide.bound, 2.01 * 2.01 * 2.01 - 8);
}

}  // namespace
}  // namespace plumbline::reference::quadrature_test
