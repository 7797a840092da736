// Points are the gas: its mass, momentum and energy, in every geometry, for any ratio of densities.
#include "cases/catalog/gas/fill.hpp"
#include "cases/catalog/gas/fill_ball.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plumbline::fill_test {
namespace {

constexpr double rounding = 1e-12;  // a sum of some thousand terms

std::shared_ptr<const IdealGas> gas() { return std::make_shared<IdealGas>(); }  // gamma = 1.4

GridSpec grid_of(int dim, double h, bool axisymmetric = false) {
  GridSpec grid;
  grid.dim = dim;
  grid.h = h;
  grid.axisymmetric = axisymmetric;
  return grid;
}

double sum(const Body& body, const std::function<double(int)>& f) {
  double total = 0;
  for (int p = 0; p < body.points.points(); ++p) total += f(p);
  return total;
}
double mass(const Body& body) {
  return sum(body, [&](int p) { return body.points(column::mass)[p]; });
}
double momentum(const Body& body, int d) {
  return sum(body, [&](int p) { return body.points(column::mass)[p] * body.points(column::velocity, d)[p]; });
}
double heat(const Body& body) {
  return sum(body, [&](int p) { return body.points(column::mass)[p] * body.points(column::energy)[p]; });
}

// rho = 1 + s^2/2, u = 0.3 + s, p = 0.4 (1 + s) along the axis: all integrals below are of polynomials.
GasBox smooth_box(int axis) {
  GasBox box;
  box.axis = axis;
  box.high = {1, 1, 1};
  box.state = [axis](const Position& x) {
    const double s = x[static_cast<std::size_t>(axis)];
    GasAt at{1 + 0.5 * s * s, {}, 0.4 * (1 + s)};
    at.velocity[static_cast<std::size_t>(axis)] = 0.3 + s;
    return at;
  };
  return box;
}

TEST(Fill, SmoothGasKeepsItsIntegralsInEveryGeometry) {
  // Integrals of s^k over [0, 1]: 1/(k + 1); with the weight s: 1/(k + 2).
  for (const bool equal_mass : {true, false}) {
    const PointRule rule{equal_mass, 4, 2, 1};
    for (int dim = 1; dim <= 3; ++dim) {
      for (int axis = 0; axis < dim; ++axis) {
        const Body body = fill_gas(gas(), smooth_box(axis), rule, grid_of(dim, 0.1));
        EXPECT_NEAR(mass(body), 1 + 0.5 / 3, rounding);
        EXPECT_NEAR(momentum(body, axis), 0.3 * (1 + 0.5 / 3) + 0.5 + 0.5 / 4, rounding);
        EXPECT_NEAR(heat(body), 1 + 0.5, rounding);  // p / (gamma - 1)
      }
    }
    const Body radial = fill_gas(gas(), smooth_box(0), rule, grid_of(2, 0.1, true));
    EXPECT_NEAR(mass(radial), 0.5 + 0.5 / 4, rounding);
    EXPECT_NEAR(momentum(radial, 0), 0.3 * (0.5 + 0.5 / 4) + 1.0 / 3 + 0.5 / 5, rounding);
    EXPECT_NEAR(heat(radial), 0.5 + 1.0 / 3, rounding);
    const Body axial = fill_gas(gas(), smooth_box(1), rule, grid_of(2, 0.1, true));
    EXPECT_NEAR(mass(axial), 0.5 * (1 + 0.5 / 3), rounding);
    EXPECT_NEAR(heat(axial), 0.5 * 1.5, rounding);
  }
}

// First moments too: a point stands at the centre of mass of its interval, and so do rings.
TEST(Fill, PointsStandAtCentresOfMass) {
  const PointRule rule{true, 4, 3, 1};
  const auto moment = [&](const Body& body, int d) {
    return sum(body, [&](int p) { return body.points(column::mass)[p] * body.points(column::position, d)[p]; });
  };
  EXPECT_NEAR(moment(fill_gas(gas(), smooth_box(0), rule, grid_of(1, 0.1)), 0), 0.5 + 0.5 / 4, rounding);
  EXPECT_NEAR(moment(fill_gas(gas(), smooth_box(0), rule, grid_of(2, 0.1, true)), 0), 1.0 / 3 + 0.5 / 5, rounding);
  EXPECT_NEAR(moment(fill_gas(gas(), smooth_box(1), rule, grid_of(2, 0.1, true)), 0), (1 + 0.5 / 3) / 3, rounding);
}

// The second moment of the points is that of the gas to second order in their spacing.
TEST(Fill, SmoothProfilesAreOfSecondOrder) {
  double before = 0;
  for (const double h : {0.2, 0.1, 0.05}) {
    const Body body = fill_gas(gas(), smooth_box(0), {true, 4, 1, 1}, grid_of(1, h));
    const double moment = sum(
        body, [&](int p) { return body.points(column::mass)[p] * std::pow(body.points(column::position)[p], 2); });
    const double error = std::abs(moment - (1.0 / 3 + 0.5 / 5));
    if (before > 0) {
      EXPECT_NEAR(before / error, 4, 0.4) << h;
    }
    before = error;
  }
}

GasBox two_layers(double left, double right, double jump = 0.5) {
  GasBox box;
  box.high = {1, 1, 1};
  box.jumps = {jump};
  box.state = [=](const Position& x) { return GasAt{x[0] < jump ? left : right, {}, 1}; };
  return box;
}

TEST(Fill, NoPointIsHeavierThanStatedAndNoCellEmptyWhateverTheRatio) {
  for (const double ratio : {1.0, 8.0, 125.0, 1000.0, 1e6}) {
    for (const double jump : {0.5, 0.003, 0.9971}) {
      const double h = 0.01;
      const Body body = fill_gas(gas(), two_layers(1, 1 / ratio, jump), {true, 8, 1, 1}, grid_of(1, h));
      std::vector<int> in_cell(100, 0);
      for (int p = 0; p < body.points.points(); ++p) {
        EXPECT_LE(body.points(column::mass)[p], h / 8 * (1 + 1e-9));
        ++in_cell[static_cast<std::size_t>(body.points(column::position)[p] / h)];
        EXPECT_EQ(body.points(column::density)[p], body.points(column::position)[p] < jump ? 1 : 1 / ratio);
      }
      EXPECT_NEAR(mass(body), jump + (1 - jump) / ratio, rounding);
      EXPECT_GE(*std::min_element(in_cell.begin(), in_cell.end()), 1) << ratio << " " << jump;
    }
  }
}

TEST(Fill, EqualMassesAreEqualUpToTheLeastNumber) {
  const Body body = fill_gas(gas(), two_layers(1, 0.25), {true, 8, 1, 1}, grid_of(1, 0.01));
  EXPECT_EQ(body.points.points(), 400 + 100);
  for (int p = 0; p < body.points.points(); ++p) EXPECT_NEAR(body.points(column::mass)[p], 0.01 / 8, 1e-15);
}

TEST(Fill, EqualVolumesAreEqual) {
  const Body body = fill_gas(gas(), two_layers(1, 0.001), {false, 3, 1, 1}, grid_of(1, 0.01));
  EXPECT_EQ(body.points.points(), 300);
  for (int p = 0; p < body.points.points(); ++p) EXPECT_NEAR(body.points(column::volume)[p], 0.01 / 3, 1e-15);
}

// The same intervals on every line: the line's points in one, two and three dimensions.
TEST(Fill, EveryLineIsTheLine) {
  const PointRule rule{true, 5, 3, 1};
  const Body line = fill_gas(gas(), smooth_box(0), rule, grid_of(1, 0.25));
  const int n = line.points.points();
  for (int dim : {2, 3}) {
    const Body body = fill_gas(gas(), smooth_box(0), rule, grid_of(dim, 0.25));
    const int lines = dim == 2 ? 12 : 144;
    ASSERT_EQ(body.points.points(), n * lines);
    for (int p = 0; p < body.points.points(); ++p) {
      EXPECT_EQ(body.points(column::position)[p], line.points(column::position)[p % n]);
      EXPECT_EQ(body.points(column::velocity)[p], line.points(column::velocity)[p % n]);
      EXPECT_EQ(body.points(column::velocity, 1)[p], 0);
      EXPECT_EQ(body.points(column::energy)[p], line.points(column::energy)[p % n]);
      EXPECT_NEAR(body.points(column::mass)[p] * lines, line.points(column::mass)[p % n], rounding);
    }
    EXPECT_NEAR(body.points(column::position, 1)[0], 0.25 / 3 / 2, rounding);
  }
}

TEST(Fill, RingsWeighWithTheirRadius) {
  GasBox box;
  box.low = {0.5, 0, 0};
  box.high = {1.5, 1, 0};
  box.axis = 1;
  box.state = [](const Position&) { return GasAt{2, {}, 1}; };
  const Body body = fill_gas(gas(), box, {true, 4, 4, 1}, grid_of(2, 0.25, true));
  EXPECT_NEAR(mass(body), 2 * (1.5 * 1.5 - 0.25) / 2, rounding);
  for (int p = 0; p < body.points.points(); ++p) {
    EXPECT_NEAR(body.points(column::mass)[p] / body.points(column::volume)[p], 2, rounding);
    EXPECT_NEAR(body.points(column::volume)[p], body.points(column::position)[p] / 256, 1e-4);
  }
}

// The greatest distance between shells of a cylinder whose density falls to a hundredth, in cells.
double widest_shell(double ppc) {
  const double h = 0.1;
  GasBall ball;
  ball.geometry = radial_geometries(2).back();  // in the plane
  ball.radius = 1;
  ball.initial = [](double r) { return reference::GasState{1 - 0.99 * r, 0, 1}; };
  ball.uniform = false;
  const Body body = fill_ball(gas(), ball, {true, ppc, 1, 1}, grid_of(2, h));
  std::vector<double> radii;
  for (int p = 0; p < body.points.points(); ++p) {
    radii.push_back(std::hypot(body.points(column::position)[p], body.points(column::position, 1)[p]));
  }
  std::sort(radii.begin(), radii.end());
  double widest = 0;
  for (std::size_t k = 1; k < radii.size(); ++k) widest = std::max(widest, radii[k] - radii[k - 1]);
  return widest / h;
}

// Two a cell where points of one mass would stand farther apart, but no more than there shall be at the centre. Whole numbers of
// shells and the sectors' centres of mass move them by less than a quarter.
TEST(Fill, ShellsStandAtMostHalfACellApartWhereABallThins) {
  EXPECT_NEAR(widest_shell(4), 0.5, 0.125);
  EXPECT_NEAR(widest_shell(1), 1, 0.25);
}

TEST(Fill, PressureIsThatOfTheEnergy) {
  const Body body = fill_gas(gas(), smooth_box(0), {true, 4, 1, 1}, grid_of(1, 0.1));
  for (int p = 0; p < body.points.points(); ++p) {
    EXPECT_NEAR(body.points(column::pressure)[p],
                0.4 * body.points(column::density)[p] * body.points(column::energy)[p], 1e-15);  // [York 4.4]
  }
}

TEST(Fill, BoxesThatAreNoneAreRefused) {
  GasBox box = smooth_box(0);
  box.high[0] = 0;
  EXPECT_THROW(fill_gas(gas(), box, {}, grid_of(1, 0.1)), std::invalid_argument);
  box = smooth_box(1);
  box.low[0] = -0.5;
  EXPECT_THROW(fill_gas(gas(), box, {}, grid_of(2, 0.1, true)), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::fill_test
