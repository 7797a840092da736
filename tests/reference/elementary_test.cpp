// atan, atan2 and the hyperbolic functions with bounds, against long double on operands drawn from inside the bounds.
#include "reference/elementary.hpp"

#include <gtest/gtest.h>

#include <random>

namespace plumbline::reference {
namespace {

class RandomArguments : public ::testing::Test {
 protected:
  std::mt19937_64 engine{7};
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  double wide() { return (uniform(0, 1) < 0.5 ? -1 : 1) * std::pow(10.0, uniform(-6, 1.3)); }
  Bounded ball(double value) {
    return {value, uniform(0, 1) < 0.3 ? 0 : std::abs(value) * std::pow(10.0, uniform(-17, 0.3))};
  }
  long double inside(Bounded x) {
    const double kind = uniform(0, 1);  // the ends of the interval are the likeliest to be missed
    const long double share = kind < 0.3 ? -1 : kind < 0.6 ? 1 : uniform(-1, 1);
    return x.value + share * x.bound;
  }
  static void expect_covers(Bounded result, long double truth, const char* what) {
    if (std::isinf(result.bound)) return;
    EXPECT_LE(std::abs(static_cast<long double>(result.value) - truth), result.bound) << what;
  }
};

TEST_F(RandomArguments, EveryFunctionCoversItsTrueResult) {
  for (int i = 0; i < 20000; ++i) {
    const Bounded x = ball(wide()), y = ball(wide());
    const long double tx = inside(x), ty = inside(y);
    expect_covers(atan(x), std::atan(tx), "atan");
    expect_covers(asinh(x), std::asinh(tx), "asinh");
    expect_covers(sinh(x), std::sinh(tx), "sinh");
    expect_covers(cosh(x), std::cosh(tx), "cosh");
    if (x.value > x.bound) expect_covers(atan2(y, x), std::atan2(ty, tx), "atan2");
  }
}

TEST_F(RandomArguments, ExactArgumentsGiveARoundingErrorOnly) {
  for (int i = 0; i < 1000; ++i) {
    const Bounded x(wide()), y(wide());
    for (Bounded r : {atan(x), atan2(y, x), asinh(x), sinh(x), cosh(x)}) {
      EXPECT_LE(r.bound, 5 * rounding::unit * std::abs(r.value));
    }
  }
}

TEST(Elementary, AbsoluteValueKeepsTheBound) {
  EXPECT_EQ(abs(Bounded(-2, 0.1)).value, 2);
  EXPECT_EQ(abs(Bounded(-2, 0.1)).bound, 0.1);
}

TEST(Elementary, DirectionOfWhatMayBeTheZeroVectorIsUnknown) {
  EXPECT_TRUE(std::isinf(atan2(Bounded(0.1, 0.2), Bounded(0.1, 0.2)).bound));
}

}  // namespace
}  // namespace plumbline::reference
