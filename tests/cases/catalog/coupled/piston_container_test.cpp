// The scene of the piston between gas and spring.
#include <gtest/gtest.h>

#include <numeric>

#include "cases/harness/description/case.hpp"

namespace plumbline::piston_container_test {
namespace {

Scene scene_of(const std::string& scheme, const std::vector<Override>& overrides = {}) {
  const Case& entry = find_case("piston-container");
  return entry.problem(entry.settings(scheme, overrides))->scene();
}

double sum(const Body& body, const ColumnId& id) {
  const double* values = body.points(id);
  return std::accumulate(values, values + body.points.points(), 0.0);
}

TEST(PistonContainer, PressureFollowsTheDisplacement) {  // [York 6.1]
  const Scene scene = scene_of("default");
  Columns gas = scene.bodies[0].points;
  gas(column::strain)[3] = 2e-5;  // div U
  scene.bodies[0].material->evaluate_stress(gas, {0, gas.points()}, {});
  EXPECT_NEAR(gas(column::stress)[3], 1.58e6 * 2e-5, 1e-12 * 1.58e6);
  EXPECT_EQ(gas(column::stress)[4], 0);
}

TEST(PistonContainer, MassesAreThoseOfTheProblem) {
  const Scene scene = scene_of("default");
  EXPECT_NEAR(sum(scene.bodies[0], column::mass), 1e-4 * 20, 1e-15);
  EXPECT_NEAR(sum(scene.bodies[1], column::mass), 0.1 + 1e-5 * 20, 1e-15);
  EXPECT_EQ(scene.bodies[1].points(column::position)[0], 20);
}

TEST(PistonContainer, YorksPoints) {  // [York A.4.10]
  const Scene scene = scene_of("york1997");
  const Columns &gas = scene.bodies[0].points, &spring = scene.bodies[1].points;
  ASSERT_EQ(gas.points(), 20);
  ASSERT_EQ(spring.points(), 20);
  EXPECT_NEAR(gas(column::position)[0], 0.5, 1e-12);
  EXPECT_NEAR(spring(column::position)[0], 20.5, 1e-12);
  EXPECT_NEAR(spring(column::position)[19], 39.5, 1e-12);
  EXPECT_NEAR(spring(column::mass)[0], 0.1, 1e-15);  // 100 times the others'
  EXPECT_NEAR(spring(column::mass)[1], 1e-3, 1e-15);
  EXPECT_EQ(spring(column::velocity)[0], -1);
  EXPECT_EQ(spring(column::velocity)[1], 0);
}

}  // namespace
}  // namespace plumbline::piston_container_test
