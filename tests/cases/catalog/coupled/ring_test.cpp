// Cut cells, the equilibrium of a ring of chords, its modes and their share in a scene.
#include "cases/catalog/coupled/ring.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/description/case.hpp"
#include "kernel/materials/segment_membrane.hpp"

namespace plumbline::ring_test {
namespace {

constexpr double rounding = 1e-13;

const Curve unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Settings settings_of(const std::string& name, const std::vector<std::string>& typed = {}) {
  return find_case(name).settings("default", {}, typed);
}

TEST(Cut, LeavesTheSideThatIsAskedFor) {
  const Curve corner = cut(unit_square, 1, 1, 0.5);  // x + y <= 1/2
  ASSERT_EQ(corner.size(), 3u);
  EXPECT_NEAR(enclosed(corner), 0.125, rounding);
  EXPECT_NEAR(centroid(corner)[0], 0.5 / 3, rounding);
  EXPECT_NEAR(centroid(corner)[1], 0.5 / 3, rounding);
  const Curve rest = cut(unit_square, -1, -1, -0.5);
  EXPECT_NEAR(enclosed(rest), 0.875, rounding);  // and counter-clockwise still
  EXPECT_EQ(cut(unit_square, 1, 0, 2).size(), 4u);
  EXPECT_TRUE(cut(unit_square, 1, 0, -1).empty());
}

TEST(Cut, CentroidsKeepTheirDigitsFarFromTheOrigin) {
  const double x = 1e4, side = 1e-3;
  const Curve triangle{{x, 0}, {x + side, 0}, {x, side}};
  EXPECT_NEAR((centroid(triangle)[0] - x) / side, 1.0 / 3, 1e-8);  // ulp(1e4)/1e-3 = 2e-9
}

// Area and first moments of the gas are those of the polygon, and every point is inside.
TEST(FillCut, IsExactInMassAndCentre) {
  const RestingRing ring = resting_ring(reference::GasRingProblem{}, 30, true);
  Curve polygon = ring.curve;
  polygon.push_back({0, 0});
  GridSpec grid;
  grid.dim = 2;
  grid.cells = {16, 16, 1};
  grid.h = 0.11;
  const Body gas = fill_cut("gas", std::make_shared<IdealGas>(), grid, 8, polygon, 0.3, 250);
  double mass = 0, x = 0, y = 0, volume = 0;
  for (int p = 0; p < gas.points.points(); ++p) {
    const double m = gas.points(column::mass)[p];
    mass += m;
    x += m * gas.points(column::position)[p];
    y += m * gas.points(column::position, 1)[p];
    volume += gas.points(column::volume)[p];
    EXPECT_TRUE(inside(polygon, gas.points(column::position)[p], gas.points(column::position, 1)[p])) << p;
    EXPECT_EQ(gas.points(column::energy)[p], 250);
    EXPECT_EQ(gas.points(column::density)[p], 0.3);
  }
  EXPECT_NEAR(volume, ring.area, rounding);
  EXPECT_NEAR(mass, 0.3 * ring.area, rounding);
  EXPECT_NEAR(x / mass, centroid(polygon)[0], rounding);
  EXPECT_NEAR(y / mass, centroid(polygon)[1], rounding);
}

TEST(RestingRing, EachVertexIsInEquilibrium) {
  const reference::GasRingProblem problem;
  for (const int chords : {4, 25}) {
    const RestingRing ring = resting_ring(problem, chords, true);
    ASSERT_EQ(ring.curve.size(), static_cast<std::size_t>(chords) + 1);
    EXPECT_EQ(ring.curve.front()[1], 0);
    EXPECT_EQ(ring.curve.back()[0], 0);
    const double tension = ring.material.plane_modulus() * ring.material.thickness * ring.strain;
    for (std::size_t p = 1; p + 1 < ring.curve.size(); ++p) {
      double net[2] = {};
      for (const std::size_t q : {p - 1, p + 1}) {
        const double dx = ring.curve[q][0] - ring.curve[p][0], dy = ring.curve[q][1] - ring.curve[p][1];
        const double side = q > p ? 1 : -1, l = std::hypot(dx, dy);
        net[0] += tension * dx / l + side * 0.5 * problem.pressure * dy;
        net[1] += tension * dy / l - side * 0.5 * problem.pressure * dx;
      }
      EXPECT_NEAR(net[0], 0, 1e-12);
      EXPECT_NEAR(net[1], 0, 1e-12);
    }
  }
}

// Tension times length is 2 p A = 2 (gamma - 1) U, for either law; the ring weighs m_l a metre; its strain is that of
// the circle, as far as chords are an arc.
TEST(RestingRing, KeepsTheVirialIdentity) {
  for (const std::string law : {"segments", "accumulated"}) {
    const Settings settings = settings_of("ring-at-rest", {"cells=10", "membrane.strain=" + law});
    const reference::GasRingProblem problem = ring_problem(settings);
    const RestingRing ring = resting_ring(settings);
    const Scene scene = ring_scene(settings, ring);
    const Body &gas = scene.bodies[0], &membrane = scene.bodies[1];
    double energy = 0, pull = 0, mass = 0;
    for (int p = 0; p < gas.points.points(); ++p) {
      energy += gas.points(column::mass)[p] * gas.points(column::energy)[p];
    }
    for (const double m : membrane.points.values(column::mass)) mass += m;
    const double around = length(ring.curve);
    if (law == "segments") {
      pull = ring.material.plane_modulus() * ring.material.thickness * ring.strain * around;
      EXPECT_NEAR(membrane.points(column::rest_length)[0] * (1 + ring.strain), around / 63, rounding);
    } else {
      const double* strain = membrane.points(column::strain);
      for (int p = 0; p < membrane.points.points(); ++p) {
        pull += ring.material.plane_modulus() * strain[p] * membrane.points(column::volume)[p];
      }
    }
    EXPECT_NEAR(pull, 2 * (problem.gamma - 1) * energy, 1e-11) << law;
    EXPECT_NEAR(mass, problem.line_mass * around, rounding) << law;
    const double arc = 1 - std::cos(0.25 * 3.141592653589793 / 63);
    EXPECT_NEAR(ring.strain / reference::GasRing(problem).strain().value, 1, 1.01 * arc) << law;
  }
}

TEST(RingMode, GradientIsThatOfTheDisplacement) {
  const reference::GasRingProblem problem;
  const reference::GasRing exact(problem);
  for (const int n : {1, 3}) {
    const RadialMode mode = ring_mode(exact, n, problem.radius);
    EXPECT_NEAR(mode.at({problem.radius, 0, 0}).displacement[0], 1, 1e-12);
    EXPECT_EQ(mode.at({0, 0, 0}).displacement[0], 0);
    const double x = 0.5, y = 0.8, step = 1e-5;
    const auto here = mode.at({x, y, 0});
    for (std::size_t d = 0; d < 2; ++d) {
      const double along_x = (mode.at({x + step, y, 0}).displacement[d] - mode.at({x - step, y, 0}).displacement[d]) /
                             (2 * step);
      const double along_y = (mode.at({x, y + step, 0}).displacement[d] - mode.at({x, y - step, 0}).displacement[d]) /
                             (2 * step);
      EXPECT_NEAR(here.gradient[d][0], along_x, 1e-7);  // k^3 step^2 and rounding over the step
      EXPECT_NEAR(here.gradient[d][1], along_y, 1e-7);
    }
    // dp = -gamma p div xi
    const double pressure = exact.pressure_shape(std::hypot(x, y), n).value;
    EXPECT_NEAR(here.gradient[0][0] + here.gradient[1][1], -pressure / (problem.gamma * problem.pressure), 1e-10);
  }
}

TEST(ModeShare, FindsItsModeAndNoOther) {
  const Settings settings = settings_of("ring-breathing", {"cells=10"});
  const reference::GasRing exact(ring_problem(settings));
  Scene scene = ring_scene(settings, resting_ring(settings));
  const RadialMode first = ring_mode(exact, 1, 1.4), second = ring_mode(exact, 2, 1.4);
  start_mode(scene, first, 0.01);
  EXPECT_NEAR(ModeShare(scene, first).of(scene), 0.01, 1e-15);
  // Orthogonal as far as the points are a quadrature of the disc: (a k)^2/24 of a = 0.05.
  EXPECT_NEAR(ModeShare(scene, second).of(scene), 0, 0.01 * 2e-3);
  const Columns& gas = scene.bodies[0].points;
  const auto at = first.at({gas(column::position)[40], gas(column::position, 1)[40], 0});
  EXPECT_EQ(gas(column::velocity, 1)[40], 0.01 * at.displacement[1]);
  EXPECT_EQ(gas(column::affine, 1)[40], 0.01 * at.gradient[0][1]);
  EXPECT_EQ(gas(column::affine, 2)[40], 0.01 * at.gradient[1][0]);
}

TEST(RingScene, HasMirrorsAndRoomForTheKernel) {
  const Settings settings = settings_of("ring-at-rest", {"cells=12", "radius=1.2"});
  const Scene scene = ring_scene(settings, resting_ring(settings));
  EXPECT_NEAR(scene.grid.h, 0.1, 1e-16);
  EXPECT_EQ(scene.grid.cells[0], 15);
  for (std::size_t d = 0; d < 2; ++d) EXPECT_EQ(scene.grid.walls[d][0], Wall::symmetry);
  ASSERT_TRUE(scene.bodies[0].enclosure);
  EXPECT_EQ(scene.bodies[0].enclosure->chain, "ring");
  const Columns& ring = scene.bodies[1].points;
  EXPECT_EQ(ring.points(), 76);  // 12 pi/2 cells, four chords a cell
  EXPECT_EQ(ring(column::position)[75], 0);
}

// York's step: 0.99 of the time in which a bar's wave crosses a cell.
TEST(RingScene, YorksStep) {
  const Settings settings =
      find_case("ring-at-rest").settings("york1997", {}, {"youngs_modulus=1e6", "radius=1.4006", "cells=28"});
  EXPECT_NEAR(settings.number("dt"), 0.99 * 1.4006 / 28 / std::sqrt(1e6 / 0.5), 1e-3 * settings.number("dt"));
}

}  // namespace
}  // namespace plumbline::ring_test
