// Midpoint-radius arithmetic [Higham 3.3]: results in double against the same operation in long double on operands
// drawn from inside the bounds.
#include "reference/bounded.hpp"

#include "tests/reference/random_operands.hpp"

namespace plumbline::reference::bounded_test {
namespace {

class RandomOperands : public RandomBalls {
 protected:
  RandomOperands() : RandomBalls(42) {}
  double signed_log(double decades) { return RandomBalls::signed_log(-decades, decades); }
};

TEST_F(RandomOperands, EveryOperationCoversItsTrueResult) {  // [Higham 3.3]
  for (int i = 0; i < 20000; ++i) {
    const Bounded a = ball(signed_log(4)), b = ball(signed_log(4)), p = ball(std::abs(signed_log(4)));
    const Bounded small = ball(uniform(-3, 3)), power = ball(uniform(-6, 6));
    const long double ta = inside(a), tb = inside(b), ts = inside(small), tw = inside(power);
    const long double tp = std::max(inside(p), 0.0L);
    expect_covers(a + b, ta + tb, "+");
    expect_covers(a - b, ta - tb, "-");
    expect_covers(a * b, ta * tb, "*");
    expect_covers(a / b, ta / tb, "/");
    expect_covers(sqrt(p), std::sqrt(tp), "sqrt");
    expect_covers(log(p), std::log(tp), "log");
    expect_covers(expm1(small), std::expm1(ts), "expm1");
    expect_covers(pow(p, power), std::pow(tp, tw), "pow");
    expect_covers(sin(small), std::sin(ts), "sin");
    expect_covers(cos(small), std::cos(ts), "cos");
  }
}

TEST_F(RandomOperands, ExactOperandsGiveARoundingErrorOnly) {
  for (int i = 0; i < 1000; ++i) {
    const Bounded a(signed_log(4)), b(signed_log(4)), p(std::abs(signed_log(4)));
    for (Bounded r : {a * b, a / b, sqrt(p), pow(p, 1.5), log(p)}) {
      EXPECT_LE(r.bound, 3 * rounding::unit * std::abs(r.value));
    }
  }
}

TEST(Bounded, WhatCannotBeKnownIsInfiniteNeverNaN) {
  const Bounded around_zero(1e-3, 1e-2);
  EXPECT_TRUE(std::isinf((Bounded(1) / around_zero).bound));
  EXPECT_TRUE(std::isinf((Bounded(0) / Bounded(0)).bound));
  EXPECT_TRUE(std::isinf(log(around_zero).bound));
  EXPECT_TRUE(std::isinf(pow(around_zero, -2.0).bound));
  EXPECT_TRUE(std::isinf((Bounded(1e300) * 1e300).bound));
  const Bounded unknown(1, rounding::infinity);
  for (Bounded r : {unknown * 0.0, unknown - unknown, unknown / unknown, pow(unknown, 2.0)}) {
    EXPECT_TRUE(std::isinf(r.bound));
  }
}

TEST(Bounded, ExactWhereArithmeticIsExact) {
  EXPECT_EQ((Bounded(3) - 3.0).bound, 0);
  EXPECT_EQ((Bounded(0) + 0.1).bound, 0);
  EXPECT_EQ(pow(Bounded(0), 2.5).bound, 0);
}

TEST(Bounded, ComparisonIsCertainOrFalse) {
  EXPECT_TRUE(certainly_below({1, 0.1}, {1.3, 0.1}));
  EXPECT_FALSE(certainly_below({1, 0.1}, {1.2, 0.1}));
  EXPECT_FALSE(certainly_below({1, 0}, {1, 0}));
}

TEST(Bounded, IntervalOfAMonotoneFunctionCoversBothEnds) {
  const Bounded square = over_interval([](double x) { return Bounded(x) * x; }, {1, 2}, 0);
  EXPECT_LE(lowest(square), 0);
  EXPECT_GE(highest(square), 9);
}

}  // namespace
}  // namespace plumbline::reference::bounded_test
