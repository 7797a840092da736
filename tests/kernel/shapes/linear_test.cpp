#include "kernel/shapes/linear.hpp"

#include "tests/kernel/shapes/properties.hpp"

namespace plumbline::linear_test {
namespace {

using namespace shape_properties;

TEST(Linear, IsAPartitionOfUnity) { expect_partition_of_unity<Linear>(); }
TEST(Linear, ReproducesLinearFields) { expect_linear_reproduction<Linear>(); }
TEST(Linear, InertiaIsTheSecondMoment) { expect_inertia<Linear>(); }
TEST(Linear, GradientsAreDerivatives) { expect_gradients_are_derivatives<Linear>(); }
TEST(Linear, ReachesNoFurtherThanItsGhosts) { expect_reach<Linear>(); }

// [York A.3.1] N1 = (1-r)(1-s), N2 = r (1-s), N3 = r s, N4 = (1-r) s: the printed N4 is wrong, its derivatives
// are right.
TEST(Linear, MakesYorksFourNodeFunctions) {
  const double r = 0.3, s = 0.8;
  double x[2], y[2];
  Linear::weights(r, x);
  Linear::weights(s, y);
  EXPECT_NEAR(x[0] * y[0], 0.14, rounding);
  EXPECT_NEAR(x[1] * y[0], 0.06, rounding);
  EXPECT_NEAR(x[1] * y[1], 0.24, rounding);
  EXPECT_NEAR(x[0] * y[1], 0.56, rounding);
}

TEST(Linear, InertiaVanishesAtNodes) {
  EXPECT_EQ(Linear::inertia(0), 0);
  EXPECT_EQ(Linear::inertia(1), 0);
  EXPECT_EQ(Linear::inertia(0.5), 0.25);
  EXPECT_FALSE(Linear::fixed_inertia);
}

TEST(Linear, APointOnTheLastNodeLineBelongsToTheLastCell) {
  double local = 0;
  EXPECT_EQ(Linear::anchor(5.0, 5, local), 4);
  EXPECT_EQ(local, 1);
  EXPECT_EQ(Linear::anchor(4.0, 5, local), 4);
  EXPECT_EQ(local, 0);
}

}  // namespace
}  // namespace plumbline::linear_test
