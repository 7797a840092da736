#include "kernel/shapes/quadratic.hpp"

#include "tests/kernel/shapes/properties.hpp"

namespace plumbline::quadratic_test {
namespace {

using namespace shape_properties;

TEST(Quadratic, IsAPartitionOfUnity) { expect_partition_of_unity<Quadratic>(); }
TEST(Quadratic, ReproducesLinearFields) { expect_linear_reproduction<Quadratic>(); }
TEST(Quadratic, InertiaIsTheSecondMoment) { expect_inertia<Quadratic>(); }
TEST(Quadratic, GradientsAreDerivatives) { expect_gradients_are_derivatives<Quadratic>(); }
TEST(Quadratic, ReachesNoFurtherThanItsGhosts) { expect_reach<Quadratic>(); }

// [York A.3.2] S1 = (3/4 - r^2)(3/4 - s^2), S2 = 1/2 (1/2 + r)^2 (3/4 - s^2), S3 = 1/4 ((1/2 + r)(1/2 + s))^2:
// in the centre 9/16, 3/32, 1/64; at the north-east corner 1/4 for the four nodes around it and 0 for the five
// others.
TEST(Quadratic, MakesYorksNineNodeFunctions) {
  double c[3], e[3];
  Quadratic::weights(0.0, c);
  EXPECT_DOUBLE_EQ(c[1] * c[1], 9.0 / 16);
  for (int k : {0, 2}) {
    EXPECT_DOUBLE_EQ(c[k] * c[1], 3.0 / 32);
    EXPECT_DOUBLE_EQ(c[k] * c[k], 1.0 / 64);
  }
  Quadratic::weights(0.5, e);
  for (int i : {1, 2}) {
    for (int j : {1, 2}) EXPECT_DOUBLE_EQ(e[i] * e[j], 0.25);
  }
  EXPECT_EQ(e[0], 0);
  double w[2][3];
  const double r = 0.3, s = -0.1;
  Quadratic::weights(r, w[0]);
  Quadratic::weights(s, w[1]);
  EXPECT_NEAR(w[0][1] * w[1][1], (0.75 - r * r) * (0.75 - s * s), rounding);
  EXPECT_NEAR(w[0][2] * w[1][1], 0.5 * (0.5 + r) * (0.5 + r) * (0.75 - s * s), rounding);
  EXPECT_NEAR(w[0][2] * w[1][2], 0.25 * std::pow((0.5 + r) * (0.5 + s), 2), rounding);
  EXPECT_NEAR(w[0][0] * w[1][0], 0.25 * std::pow((0.5 - r) * (0.5 - s), 2), rounding);
}

// [York A.3.2, Table 13] dS1/dr = -2 r (3/4 - s^2), dS2/dr = (1/2 + r)(3/4 - s^2), dS6/dr = -(1/2 - r)(3/4 - s^2).
TEST(Quadratic, HasYorksDerivatives) {
  double g[3];
  Quadratic::gradients(0.3, g);
  EXPECT_DOUBLE_EQ(g[0], -0.2);
  EXPECT_DOUBLE_EQ(g[1], -0.6);
  EXPECT_DOUBLE_EQ(g[2], 0.8);
}

// [EC-APIC 5] D = h^2/4 wherever the point stands.
TEST(Quadratic, InertiaIsAQuarter) {
  EXPECT_EQ(Quadratic::inertia(-0.5), 0.25);
  EXPECT_EQ(Quadratic::inertia(0.3), 0.25);
  EXPECT_TRUE(Quadratic::fixed_inertia);
}

TEST(Quadratic, GradientsAreContinuousWhereTheAnchorChanges) {
  double below[3], above[3];
  Quadratic::gradients(0.5, below);
  Quadratic::gradients(-0.5, above);
  EXPECT_EQ(below[0], 0);
  EXPECT_EQ(below[1], above[0]);
  EXPECT_EQ(below[2], above[1]);
  EXPECT_EQ(above[2], 0);
}

}  // namespace
}  // namespace plumbline::quadratic_test
