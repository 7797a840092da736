// Gas inside a sphere: how it is filled, and the mode that it starts with.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cases/catalog/coupled/gas_ball.hpp"
#include "cases/catalog/coupled/radial_mode.hpp"
#include "cases/harness/description/case.hpp"

namespace plumbline::gas_sphere_test {
namespace {

Body ball(int ppc, double shift) {
  GridSpec grid;
  grid.dim = 3;
  grid.h = 0.25;
  grid.origin = {-1.5 - shift, -1.5, -1.5};
  return fill_ball("gas", std::make_shared<IdealGas>(), grid, ppc, 1.2, 0.5, 2);
}

TEST(GasBall, MassAndMomentsAreThoseOfTheBall) {
  for (const double shift : {0.0, 0.07}) {
    const Body gas = ball(8, shift);
    double mass = 0, moment[3] = {}, squares = 0;
    for (int p = 0; p < gas.points.points(); ++p) {
      const double m = gas.points(column::mass)[p];
      mass += m;
      for (int d = 0; d < 3; ++d) {
        moment[d] += m * gas.points(column::position, d)[p];
        squares += m * std::pow(gas.points(column::position, d)[p], 2);
      }
    }
    const double exact = 0.5 * 4 / 3 * std::numbers::pi * std::pow(1.2, 3);
    EXPECT_NEAR(mass, exact, 1e-12);
    for (const double m : moment) EXPECT_NEAR(m, 0, 1e-5 * exact);  // columns are wrong by as much
    // A cube about its centre has side^2/4 more: of whole cubes exactly, and of parts less.
    const double side = 0.125, ideal = 0.6 * exact * 1.44;
    EXPECT_LT(squares, ideal);
    EXPECT_GT(squares, ideal - exact * side * side / 4 - 1e-5 * exact);
  }
}

// A uniform pressure pushes outward with the volume, whatever its points: sum V_p = the ball's.
TEST(GasBall, PointsCarryTheBallsVolumeAndOneDensity) {
  const Body gas = ball(27, 0);
  double volume = 0;
  for (int p = 0; p < gas.points.points(); ++p) {
    volume += gas.points(column::volume)[p];
    EXPECT_LE(std::hypot(gas.points(column::position)[p], gas.points(column::position, 1)[p],
                         gas.points(column::position, 2)[p]),
              1.2);
    EXPECT_EQ(gas.points(column::density)[p], 0.5);
    EXPECT_EQ(gas.points(column::energy)[p], 2);
  }
  EXPECT_NEAR(volume, 4.0 / 3 * std::numbers::pi * std::pow(1.2, 3), 1e-11);  // sums of 50 000
}

TEST(RadialMode, GradientInSpaceIsThatOfTheDisplacement) {
  const RadialMode mode([](double r) { return std::array<double, 2>{std::sin(r), std::cos(r)}; });
  const std::array<double, 3> place{0.3, -0.4, 0.7};
  const ModeAt here = mode.at(place);
  for (std::size_t e = 0; e < 3; ++e) {
    std::array<double, 3> ahead = place, behind = place;
    ahead[e] += 1e-5;
    behind[e] -= 1e-5;
    for (std::size_t d = 0; d < 3; ++d) {
      const double slope = (mode.at(ahead).displacement[d] - mode.at(behind).displacement[d]) / 2e-5;
      EXPECT_NEAR(here.gradient[d][e], slope, 1e-9);
    }
  }
  EXPECT_EQ(mode.at({0, 0, 0}).displacement[0], 0);
}

TEST(GasSphere, StartsInEquilibriumWithItsMode) {
  const Case& entry = find_case("gas-sphere");
  const auto problem = entry.problem(entry.settings("default", {}, {"cells=4", "mach=0.01"}));
  const Scene scene = problem->scene();
  const Columns &gas = scene.bodies[0].points, &sheet = scene.bodies[1].points;
  double energy = 0;
  for (int p = 0; p < gas.points(); ++p) energy += gas(column::mass)[p] * gas(column::energy)[p];
  const double pressure = 0.4 * energy / (4.0 / 3 * std::numbers::pi * std::pow(1.2, 3));
  EXPECT_NEAR(pressure, 2 * 0.01 * (1.44 - 1) / (2 * 0.7) / 1.2, 1e-12);  // p = 2 t S/(l R0) [Surface 6]
  const double c = std::sqrt(1.4 * pressure / 0.01);
  for (int p = 0; p < sheet.points(); p += 50) {
    const double v = std::hypot(sheet(column::velocity)[p], sheet(column::velocity, 1)[p],
                                sheet(column::velocity, 2)[p]);
    EXPECT_NEAR(v, 0.01 * c, 1e-12);
  }
}

}  // namespace
}  // namespace plumbline::gas_sphere_test
