// Where a shock stands and what it leaves, on made-up points.
#include "cases/catalog/gas/shock_front.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::shock_front_test {
namespace {

// A smeared step from 4 to 1 at `place`, three cells wide, in points of random order.
std::vector<GasSample> step(double place, double h, double plateau = 4, double wall_energy = 1) {
  std::vector<GasSample> points;
  const int n = 800;
  for (int k = 0; k < n; ++k) {
    const double x = ((k * 37) % n + 0.5) / n;
    const double rho = 1 + (plateau - 1) / 2 * (1 - std::tanh((x - place) / h));
    points.push_back({x, 1.0 / n, rho, 0, 1, x < 0.02 ? wall_energy : 1.0});
  }
  return points;
}

const ShockFront front{0, {0.4, 1e-12}, 1, {4, 1e-14}, {1, 1e-14}};

const Measure& find(const std::vector<Measure>& all, const std::string& name) {
  for (const Measure& m : all) {
    if (m.name == name) return m;
  }
  throw std::out_of_range(name);
}

TEST(ShockFront, StandsHalfway) {
  for (const double place : {0.4, 0.4037, 0.3911}) {
    EXPECT_NEAR(shock_place(step(place, 0.01), 0.01, 2.5), place, 0.001) << place;
  }
  EXPECT_TRUE(std::isnan(shock_place(step(0.4, 0.01), 0.01, 5)));
}

TEST(ShockFront, IsMeasuredFromItsOrigin) {
  ShockFront moved = front;
  moved.origin = 0.1;
  moved.distance = {0.3, 0};
  EXPECT_NEAR(*find(shock_measures(step(0.4, 0.01), 0.01, moved), "shock_position").value, 0.3, 0.001);
  EXPECT_EQ(*find(shock_measures(step(0.4, 0.01), 0.01, moved), "shock_position").reference, 0.3);
}

TEST(ShockFront, ThePlateauIsItsWorstPoint) {
  auto points = step(0.4, 0.01, 4);
  EXPECT_NEAR(find(shock_measures(points, 0.01, front), "plateau_density").error, 0, 1e-3);
  for (GasSample& p : points) {
    if (std::abs(p.coordinate - 0.25) < 1e-3) p.density = 3.7;
    if (p.coordinate < 0.1) p.density = 2;  // at the wall: not looked at
  }
  EXPECT_NEAR(find(shock_measures(points, 0.01, front), "plateau_density").error, 0.3, 1e-9);
}

TEST(ShockFront, WallHeatingIsAShareOfTheExactEnergy) {
  EXPECT_NEAR(find(shock_measures(step(0.4, 0.01, 4, 1.7), 0.01, front), "wall_heating").error, 0.7, 1e-12);
  EXPECT_EQ(find(shock_measures(step(0.4, 0.01, 4, 0.7), 0.01, front), "wall_heating").error, 0);
}

TEST(ShockFront, GatesAreOneCellAndTwoPercent) {
  const auto gates = shock_gates("default", 400, 1.0 / 400, 4);
  ASSERT_EQ(gates.size(), 2u);
  EXPECT_EQ(*gates[0].gate.expected.high, 1.0 / 400);
  EXPECT_EQ(*gates[1].gate.expected.high, 0.08);
  for (const CaseGate& gate : gates) EXPECT_EQ(gate.gate.origin, Origin::requirement);
}

}  // namespace
}  // namespace plumbline::shock_front_test
