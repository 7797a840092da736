#include "reference/root.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace plumbline::reference::root_test {
namespace {

TEST(Root, BrentFindsACubeRoot) {
  const double x = brent_root([](double t) { return t * t * t - 2; }, 0, 5);
  EXPECT_NEAR(x, std::cbrt(2.0), 4 * rounding::unit * x);  // the stopping width
}

TEST(Root, RefusesABracketWithoutAChangeOfSign) {
  EXPECT_THROW(brent_root([](double t) { return t * t + 1; }, -1, 1), std::domain_error);
  EXPECT_THROW(brent_root([](double t) { return t; }, 1, 2), std::domain_error);
}

TEST(Root, RefusesAValueThatIsNotFinite) {
  EXPECT_THROW(brent_root([](double t) { return std::abs(t) < 0.9 ? std::nan("") : t; }, -1, 1), std::domain_error);
}

TEST(Root, EnclosureHoldsTheRootOfAGuessThatIsOff) {
  auto f = [](double t) { return Bounded(t) * t - 2.0; };
  for (double guess : {1.0, 1.4, std::sqrt(2.0), 1.5, 3.0}) {
    const Bounded root = enclose_root(f, guess, 2 * guess, 0, rounding::infinity);
    EXPECT_LE(std::abs(static_cast<long double>(root.value) - std::sqrt(2.0L)), root.bound) << guess;
  }
}

TEST(Root, EnclosureCountsTheRoundingOfTheFunction) {
  // (t - 1)^3 written out has a rounding error of 1e-16, so its root is known to the cube root of that only.
  auto f = [](double t) {
    const Bounded x(t);
    return x * x * x - Bounded(3) * x * x + Bounded(3) * x - 1.0;
  };
  const Bounded root = enclose_root(f, 1, 1, 0, 2);
  EXPECT_GT(root.bound, 1e-6);
  EXPECT_LT(root.bound, 1e-4);
}

TEST(Root, EnclosureThatCannotBeCertifiedThrows) {
  auto flat = [](double) { return Bounded(0, 1); };
  EXPECT_THROW(enclose_root(flat, 1, 1, -rounding::infinity, rounding::infinity), std::domain_error);
}

}  // namespace
}  // namespace plumbline::reference::root_test
