// The tube that starts in balance with its load.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "cases/harness/description/case.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "reference/geo_tube.hpp"

namespace plumbline::geo_tube_test {
namespace {

std::array<double, 2> force(const Body& body, int p) {
  const double m = body.points(column::mass)[p];
  return {m * body.points(column::body_force)[p], m * body.points(column::body_force, 1)[p]};
}

Scene tube_scene(const std::vector<std::string>& typed) {
  const Case& entry = find_case("geo-tube");
  return entry.problem(entry.settings("default", {}, typed))->scene();
}

// Tension and load cancel at every point off the floor, as far as chords are an arc of changing curvature; on the floor
// the load is downward and the tension pulls along.
TEST(GeoTube, StartsInBalance) {
  Scene scene = tube_scene({"cells=160"});
  Body& tube = scene.bodies[0];
  tube.points.add(column::body_force, 2);
  tube.load(0, tube.points, tube.id);
  std::vector<double> pull;
  dynamic_cast<const SegmentMembrane&>(*tube.material).point_forces(tube.points, pull);
  const int n = tube.points.points();
  ASSERT_EQ(n, 321);
  const reference::GeoTube exact(reference::GeoTubeProblem{.compliance = 1 / 2e5});
  const double contact = 0.5 * exact.contact_width().value, push = exact.bottom_pressure().value * 2.0 / 320;
  for (int p = 1; p + 1 < n; ++p) {
    const double x = tube.points(column::position)[p], y = tube.points(column::position, 1)[p];
    const double net[] = {force(tube, p)[0] + pull[static_cast<std::size_t>(p)],
                          force(tube, p)[1] + pull[static_cast<std::size_t>(n + p)]};
    if (y == 0 && x < contact - 0.01) {
      EXPECT_NEAR(net[0], 0, 1e-9);
      EXPECT_NEAR(net[1], -push * (1 + exact.strain().value), 1e-9);
    } else if (y > 1e-3) {
      EXPECT_LT(std::hypot(net[0], net[1]), 1e-3 * push) << p;  // (l/R)^2 = 6e-4 at the smallest radius
    }
  }
  EXPECT_NEAR(tube.points(column::position, 1)[n - 1], exact.height().value, 1e-12);
  double mass = 0;
  for (const double m : tube.points.values(column::mass)) mass += m;
  EXPECT_NEAR(mass, 20, 1e-12);
}

TEST(GeoTube, StartsAsACircleOfItsOwnLength) {
  const Scene scene = tube_scene({"cells=80", "start=circle"});
  const Columns& points = scene.bodies[0].points;
  const int top = points.points() - 1;
  const reference::GeoTube exact(reference::GeoTubeProblem{.compliance = 1 / 2e5});
  const double radius = 2 * (1 + exact.strain().value) / 3.141592653589793;
  EXPECT_NEAR(points(column::position, 1)[top], 2 * radius, 1e-12);
  for (int p = 0; p <= top; ++p) {
    EXPECT_NEAR(std::hypot(points(column::position)[p], points(column::position, 1)[p] - radius), radius, 1e-12);
  }
  EXPECT_GT(scene.grid.h * scene.grid.cells[1], 2 * radius);
}

}  // namespace
}  // namespace plumbline::geo_tube_test
