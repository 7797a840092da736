// Bessel functions and their zeros against tables: M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions,
// tables 9.1, 9.4 and 9.5. Half of the last printed digit, or the last one.
#include "reference/bessel.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::bessel_test {
namespace {

TEST(Bessel, PublishedValues) {  // [DLMF 10.9.2]
  expect_near(bessel_J0(1.0), 0.7651976866, 5e-11);
  expect_near(bessel_J1(1.0), 0.4400505857, 5e-11);
  expect_near(bessel_J0(10.0), -0.2459357645, 5e-11);
  expect_near(bessel_J1(10.0), 0.0434727462, 5e-11);
  expect_near(bessel_J0(-10.0), -0.2459357645, 5e-11);
  expect_near(bessel_J1(-10.0), -0.0434727462, 5e-11);
}

TEST(Bessel, PublishedZeros) {
  expect_near(bessel_zero_J0(1), 2.4048255577, 5e-11);
  expect_near(bessel_zero_J0(2), 5.5200781103, 5e-11);
  expect_near(bessel_zero_J0(10), 30.6346064684, 1e-9);
  expect_near(bessel_zero_J0(20), 62.0484691902, 1e-9);
  expect_near(bessel_J1(bessel_zero_J0(1)), 0.5191474973, 5e-11);  // J0' = -J1
  expect_near(bessel_J1(bessel_zero_J0(2)), -0.3402648066, 1e-10);
}

TEST(Bessel, HigherOrders) {
  expect_near(bessel_J(2, 1.0), 0.1149034849, 5e-11);
  expect_near(bessel_J(3, 10.0), 0.0583793793, 5e-11);
  expect_near(bessel_J(3, -10.0), -0.0583793793, 5e-11);
  expect_near(bessel_zero_J(1, 1), 3.83170597, 5e-9);
  expect_near(bessel_zero_J(2, 1), 5.13562230, 5e-9);
  expect_near(bessel_zero_J(8, 1), 12.22509, 5e-6);
  for (double x : {0.0, 0.3, 7.7, 200.0}) {
    expect_same(bessel_J(0, x), bessel_J0(x));
    expect_same(bessel_J(1, x), bessel_J1(x));
    for (int n : {1, 2, 9, 60}) {  // [DLMF 10.6.1]; ten roundings of the argument in every term, and of the sum
      const Bounded rest = Bounded(x) * (bessel_J(n - 1, x) + bessel_J(n + 1, x)) - Bounded(2) * n * bessel_J(n, x);
      expect_zero(rest, 1, "recurrence", 1e-14 * (n + x) * (10 + x));
    }
  }
  for (int n : {1, 2, 10, 1000}) expect_same(bessel_zero_J(0, n), bessel_zero_J0(n));
  EXPECT_LE(bessel_zero_J(7, 3).bound, 1e-12);
  EXPECT_EQ(refused_key([] { bessel_J(-1, 1.0); }), "order");
  EXPECT_EQ(refused_key([] { bessel_J(101, 1.0); }), "order");
  EXPECT_EQ(refused_key([] { bessel_zero_J(101, 1); }), "order");
  EXPECT_EQ(refused_key([] { bessel_zero_J(2, 0); }), "mode");
}

// The trapezoidal sum leaves out terms below (x/2)^N/N!: were it taken too short, the hull with GSL would show it.
TEST(Bessel, BoundsAreRoundingTimesTheArgument) {  // [DLMF 10.14.4]
  for (double x : {0.0, 1e-8, 0.3, 2.0, 7.7, 31.0, 200.0, 3141.0}) {
    EXPECT_LE(bessel_J0(x).bound, 1e-15 * (20 + x)) << x;
    EXPECT_LE(bessel_J1(x).bound, 1e-15 * (20 + x)) << x;
  }
}

TEST(Bessel, BoundOfTheArgumentIsCarried) {
  for (double x : {0.5, 2.0, 9.0}) {
    const Bounded wide = bessel_J0({x, 0.1}), steep = bessel_J1({x, 0.1});
    for (double d : {-0.1, -0.03, 0.1}) {
      EXPECT_LE(std::abs(bessel_J0(x + d).value - wide.value), wide.bound);
      EXPECT_LE(std::abs(bessel_J1(x + d).value - steep.value), steep.bound);
    }
  }
}

TEST(Bessel, RefusesWhatItCannotBound) {
  EXPECT_EQ(refused_key([] { bessel_J0(2e4); }), "x");
  EXPECT_EQ(refused_key([] { bessel_J1(std::nan("")); }), "x");
  EXPECT_EQ(refused_key([] { bessel_zero_J0(0); }), "mode");
  EXPECT_EQ(refused_key([] { bessel_zero_J0(1001); }), "mode");
}

}  // namespace
}  // namespace plumbline::reference::bessel_test
