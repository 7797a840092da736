// J0, J1 and the zeros of J0 against tables: M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions, tables
// 9.1 and 9.5. Half of the last printed digit, or the last one.
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
