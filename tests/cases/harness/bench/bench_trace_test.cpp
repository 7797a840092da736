#include "cases/harness/bench/bench_trace.hpp"

#include <gtest/gtest.h>

#include "kernel/shapes/quadratic.hpp"
#include "kernel/stencil.hpp"

namespace plumbline::bench_trace_test {
namespace {

class BenchTrace : public testing::Test {
 protected:
  void SetUp() override { Trace::current() = Trace(); }
  static int operations(const std::vector<Traced>& results) {
    std::vector<int> at;
    for (const Traced& r : results) at.push_back(r.at());
    return Trace::current().operations(at);
  }
};

TEST_F(BenchTrace, CountsSumsProductsQuotientsAndFunctions) {
  const Traced a = Traced::input(), b = Traced::input();
  EXPECT_EQ(operations({a * b + a / b - function_of(a, b)}), 5);
}

TEST_F(BenchTrace, TheSameOperationCountsOnce) {
  const Traced a = Traced::input(), b = Traced::input();
  EXPECT_EQ(operations({a * b + b * a}), 2);      // one product, one sum
  EXPECT_EQ(operations({(a - b) * (b - a)}), 3);  // two differences
}

TEST_F(BenchTrace, WhatNobodyUsesDoesNotCount) {
  const Traced a = Traced::input(), cube = a * a * a;
  EXPECT_EQ(operations({a + 1.0}), 1);
  EXPECT_EQ(operations({cube}), 2);
  EXPECT_EQ(operations({a}), 0);
}

TEST_F(BenchTrace, ZerosAndOnesCostNothing) {
  const Traced a = Traced::input();
  Traced sum = 0.0;
  sum += 1.0 * a;
  sum -= 0.0 * a;
  EXPECT_EQ(operations({sum}), 0);
}

// By hand: 0.5 (0.5 - f)^2 takes three operations, 0.75 - f^2 two, 0.5 (0.5 + f)^2 three.
TEST_F(BenchTrace, WeightsOfAQuadraticSpline) {
  Traced w[3];
  Quadratic::weights(Traced::input(), w);
  EXPECT_EQ(operations({w[0], w[1], w[2]}), 8);
}

// By hand: a mass spread over nine nodes: three products along y, nine along x, nine sums; beside the weights along each.
TEST_F(BenchTrace, AMassSpreadInThePlane) {
  const Traced local[2] = {Traced::input(), Traced::input()};
  const Stencil<2, Quadratic, Traced> weights(local, 2.0);
  std::vector<Traced> sums;
  for (int k = 0; k < 9; ++k) sums.push_back(Traced::input());
  weights.spread(Traced::input(), sums.data(), 1);
  EXPECT_EQ(operations(sums), 2 * 8 + 3 + 9 + 9);
}

}  // namespace
}  // namespace plumbline::bench_trace_test
