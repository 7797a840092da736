#include "kernel/shapes/cubic.hpp"

#include "tests/kernel/shapes/properties.hpp"

namespace plumbline::cubic_test {
namespace {

using namespace shape_properties;

TEST(Cubic, IsAPartitionOfUnity) { expect_partition_of_unity<Cubic>(); }
TEST(Cubic, ReproducesLinearFields) { expect_linear_reproduction<Cubic>(); }
TEST(Cubic, InertiaIsTheSecondMoment) { expect_inertia<Cubic>(); }
TEST(Cubic, GradientsAreDerivatives) { expect_gradients_are_derivatives<Cubic>(); }
TEST(Cubic, ReachesNoFurtherThanItsGhosts) { expect_reach<Cubic>(); }

// The cubic B-spline is 2/3 at its node, 23/48 half a cell away, 1/6 one cell, 1/48 one and a half cells away.
TEST(Cubic, HasThePublishedValues) {
  EXPECT_NEAR(weight_at_distance<Cubic>(0.0), 2.0 / 3, rounding);
  EXPECT_NEAR(weight_at_distance<Cubic>(0.5), 23.0 / 48, rounding);
  EXPECT_NEAR(weight_at_distance<Cubic>(-0.5), 23.0 / 48, rounding);
  EXPECT_NEAR(weight_at_distance<Cubic>(1.0), 1.0 / 6, rounding);
  EXPECT_NEAR(weight_at_distance<Cubic>(1.5), 1.0 / 48, rounding);
  EXPECT_NEAR(weight_at_distance<Cubic>(2.0), 0, rounding);
}

// [EC-APIC 5] D = h^2/3 wherever the point stands.
TEST(Cubic, InertiaIsAThird) {
  EXPECT_DOUBLE_EQ(Cubic::inertia(0.0), 1.0 / 3);
  EXPECT_DOUBLE_EQ(Cubic::inertia(0.7), 1.0 / 3);
  EXPECT_TRUE(Cubic::fixed_inertia);
}

TEST(Cubic, APointOnTheLastNodeLineBelongsToTheLastCell) {
  double local = 0;
  EXPECT_EQ(Cubic::anchor(5.0, 5, local), 4);
  EXPECT_EQ(local, 1);
}

}  // namespace
}  // namespace plumbline::cubic_test
