// The tubes are within what was to be drawn, and the same ones everywhere.
#include "cases/catalog/gas/drawn_tubes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace plumbline::drawn_tubes_test {
namespace {

double sound(const reference::GasState& gas, double gamma) { return std::sqrt(gamma * gas.pressure / gas.density); }

TEST(DrawnTubes, AreWithinTheirRangesAndFillThem) {
  const auto all = drawn_tubes(1000, 1);
  int denser = 0, higher = 0, apart = 0, both = 0;
  double largest = 0, least = HUGE_VAL;
  for (const DrawnTube& drawn : all) {
    for (const double ratio : {drawn.density_ratio, drawn.pressure_ratio}) {
      EXPECT_GE(ratio, 0.01);
      EXPECT_LE(ratio, 100);
      largest = std::max(largest, ratio);
      least = std::min(least, ratio);
    }
    EXPECT_LE(std::abs(drawn.parting), 1);
    EXPECT_GE(drawn.tube.states.gamma, 1.2);
    EXPECT_LE(drawn.tube.states.gamma, 1.67);
    denser += drawn.density_ratio > 1;
    higher += drawn.pressure_ratio > 1;
    both += drawn.density_ratio > 1 && drawn.pressure_ratio > 1;
    apart += drawn.parting > 0;
  }
  EXPECT_GT(largest, 95);
  EXPECT_LT(least, 1 / 95.0);
  for (const int count : {denser, higher, apart}) EXPECT_NEAR(count, 500, 50);  // three standard deviations
  EXPECT_NEAR(both, 250, 45);
}

TEST(DrawnTubes, StatesFollowFromWhatWasDrawn) {
  for (const DrawnTube& drawn : drawn_tubes(64, 1)) {
    const auto& [left, right, gamma] = drawn.tube.states;
    EXPECT_EQ(right.density / left.density, drawn.density_ratio);
    EXPECT_EQ(right.pressure / left.pressure, drawn.pressure_ratio);
    EXPECT_EQ(left.velocity, -right.velocity);
    EXPECT_NEAR(right.velocity - left.velocity, drawn.parting * (sound(left, gamma) + sound(right, gamma)) / 2,
                1e-14 * sound(right, gamma) + 1e-14);
  }
}

TEST(DrawnTubes, NoVacuumFormsAndTheFastestWaveTravelsItsShare) {
  for (const DrawnTube& drawn : drawn_tubes(1000, 2)) {
    const reference::RiemannSolution exact(drawn.tube.states);
    EXPECT_FALSE(exact.vacuum());
    double furthest = 0;
    for (const double speed : exact.jumps()) furthest = std::max(furthest, std::abs(speed * drawn.tube.end_time));
    EXPECT_NEAR(furthest, 0.4, 1e-14);
  }
}

// Of the 64-bit Mersenne twister with seed 5489 the standard prescribes the 10000th number, 9981545732273789042: the
// last of 2500 tubes' four numbers, from which gamma follows.
TEST(DrawnTubes, AreThoseOfTheGeneratorThatTheStandardPrescribes) {
  const double share = static_cast<double>(9981545732273789042ull >> 11) / 9007199254740992.0;
  EXPECT_EQ(drawn_tubes(2500, 5489).back().tube.states.gamma, 1.2 + (1.67 - 1.2) * share);
}

TEST(DrawnTubes, AShorterListIsTheBeginningOfALongerOne) {
  EXPECT_EQ(drawn_tubes(3, 7).back().parting, drawn_tubes(5, 7)[2].parting);
  EXPECT_NE(drawn_tubes(3, 7).back().parting, drawn_tubes(3, 8).back().parting);
}

}  // namespace
}  // namespace plumbline::drawn_tubes_test
