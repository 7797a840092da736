// Roots between poles that have bounds of their own, and the poles of two columns in one order.
#include "reference/interlacing.hpp"

#include "reference/circle.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::interlacing_test {
namespace {

Bounded cosine_upward(double x) { return -cos(Bounded(x)); }  // root at pi/2 between the poles 0 and pi of the tangent
double sine(double x) { return std::sin(x); }

TEST(RootBetween, EnclosesTheRoot) {
  for (double width : {0.0, 1e-3, 1.0}) {
    const Bounded x = root_between(cosine_upward, sine, {0.2, width * 0.1}, {3, width});
    EXPECT_LE(std::abs(x.value - 0.5 * pi.value), x.bound);
    EXPECT_LE(x.bound, 1e-15);
  }
}

TEST(RootBetween, FindsARootThatFallsOnAPole) {  // to rounding: the pole's own bound decides
  const Bounded half = pi / 2.0, at_low = root_between(cosine_upward, sine, half, 3.0);
  const Bounded at_high = root_between(cosine_upward, sine, 0.1, half);
  expect_same(at_low, half);
  expect_same(at_high, half);
  EXPECT_LE(at_low.bound + at_high.bound, 1e-14);
}

TEST(RootBetween, CoversBothPolesWhereTheyAreOne) {
  const Bounded x = root_between(cosine_upward, sine, {1.5, 0.2}, {1.6, 0.1});
  EXPECT_LE(lowest(x), 1.3);
  EXPECT_GE(highest(x), 1.7);
}

TEST(MergedMultiples, AreInOrderAndCountDoublesTwice) {
  const std::vector<Bounded> all = merged_multiples(2.0, 3.0, 8);
  const double expected[] = {2, 3, 4, 6, 6, 8, 9, 10};
  ASSERT_EQ(all.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_LE(std::abs(all[i].value - expected[i]), all[i].bound);
    EXPECT_LE(all[i].bound, 2e-14);
  }
  EXPECT_NEAR(merged_multiples(2.0, rounding::infinity, 5).back().value, 10, 1e-14);
  EXPECT_NEAR(merged_multiples(5.0, 0.5, 12).back().value, 5.5, 1e-14);  // 5 stands twice
}

TEST(MergedMultiples, CarryTheBoundsOfBoth) {
  const std::vector<Bounded> all = merged_multiples({2, 0.01}, {3, 0.3}, 4);
  for (double shift : {-0.3, 0.3}) {  // 2, 3, 4, then 2 (3 + shift) or 6
    EXPECT_LE(std::abs(all[1].value - (3 + shift)), all[1].bound);
    EXPECT_LE(std::abs(all[3].value - std::min(6.0, 2 * (3 + shift))), all[3].bound);
  }
}

}  // namespace
}  // namespace plumbline::reference::interlacing_test
