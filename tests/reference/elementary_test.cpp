// atan, atan2 and the hyperbolic functions with bounds, against long double on operands drawn from inside the bounds.
#include "reference/elementary.hpp"

#include "tests/reference/random_operands.hpp"

namespace plumbline::reference::elementary_test {
namespace {

class RandomArguments : public RandomBalls {
 protected:
  RandomArguments() : RandomBalls(7) {}
  double wide() { return signed_log(-6, 1.3); }
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
}  // namespace plumbline::reference::elementary_test
