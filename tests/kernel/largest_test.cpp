#include "kernel/largest.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::largest_test {
namespace {

const double nan = std::nan("");

Pack but(double all, int lane, double other) {
  return Pack([&](auto k) { return static_cast<int>(k) == lane ? other : all; });
}

TEST(Largest, OfNoneIsZero) {
  Largest largest;
  EXPECT_EQ(largest.value(), 0);
  largest.include(Pack(7.0), 0);
  EXPECT_EQ(largest.value(), 0);
}

TEST(Largest, IsFoundInEveryLaneThatCounts) {
  for (int lane = 0; lane < lanes; ++lane) {
    for (int count = 1; count <= lanes; ++count) {
      Largest largest;
      largest.include(Pack(1.0), lanes);
      largest.include(but(2, lane, 5), count);
      largest.include(Pack(3.0), 1);
      EXPECT_EQ(largest.value(), lane < count ? 5 : 3) << lane << ' ' << count;
    }
  }
  Largest infinite;
  infinite.include(but(1, lanes - 1, HUGE_VAL), lanes);
  EXPECT_EQ(infinite.value(), HUGE_VAL);
}

// Before, between and behind numbers; beyond the points it counts for nothing.
TEST(Largest, ANanStays) {
  for (int lane = 0; lane < lanes; ++lane) {
    for (int when = 0; when < 3; ++when) {
      Largest largest;
      for (int k = 0; k < 3; ++k) largest.include(k == when ? but(1, lane, nan) : Pack(2.0 + k), lanes);
      EXPECT_TRUE(std::isnan(largest.value())) << lane << ' ' << when;
    }
    Largest numbers;
    numbers.include(but(1, lane, nan), lane);
    EXPECT_EQ(numbers.value(), lane > 0 ? 1 : 0);
  }
}

TEST(Largest, LargerTakesLaneByLane) {
  const Pack a = but(1, 0, nan), b = but(2, lanes - 1, nan);
  const Pack both = larger(a, b);
  EXPECT_TRUE(std::isnan(both[0]));
  EXPECT_TRUE(std::isnan(both[static_cast<std::size_t>(lanes - 1)]));
  for (int k = 1; k + 1 < lanes; ++k) EXPECT_EQ(both[static_cast<std::size_t>(k)], 2);
  EXPECT_EQ(larger(Pack(3.0), Pack(2.0))[0], 3);
}

}  // namespace
}  // namespace plumbline::largest_test
