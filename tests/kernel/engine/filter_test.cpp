// What a filter that leaves points a part of their own motion gives back, where roundings would take what nobody has. [Filter 1]
#include "kernel/engine/loops/filter.hpp"

#include <gtest/gtest.h>

namespace plumbline::filter_test {
namespace {

double repaid_of(double given, double taken) { return repaid(Pack(given), Pack(taken))[0]; }

TEST(Filter, RepaysNoMoreThanWasTakenByRounding) {
  EXPECT_EQ(repaid_of(-2 * (1 + 1e-13), 2), -2);
  EXPECT_EQ(repaid_of(-2 * (1 + 1e-11), 2), -2 * (1 + 1e-11));  // no rounding: an error that must be seen
  EXPECT_EQ(repaid_of(-1, 2), -1);
  EXPECT_EQ(repaid_of(-1, -2), -1);
}

// Of numbers below 2e-308 a relative rounding is no measure: they have hardly any digits.
TEST(Filter, RepaysNoMoreThanWasTakenOfSubnormalEnergies) {
  EXPECT_EQ(repaid_of(-6e-319, 5e-319), -5e-319);
  EXPECT_EQ(repaid_of(-4e-320, 0), 0);
  EXPECT_EQ(repaid_of(-4e-319, 5e-319), -4e-319);
}

}  // namespace
}  // namespace plumbline::filter_test
