// The small scenes are what their words say.
#include "cases/harness/integrators/small_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/laboratory/scene_contents.hpp"
#include "kernel/materials/segment_membrane.hpp"

namespace plumbline::small_scenes_test {
namespace {

// Cells and waves of speed one, so that an end is so many crossings of a cell: E (1 - nu)/((1 + nu)(1 - 2 nu)) = 0.996 where
// the sides cannot move, E = 0.74 in a bar whose sides are free; sound where the gas is hottest, by 5 % of its energy.
TEST(SmallScenes, WavesHaveTheSpeedOne) {
  for (const SmallScene& small : small_scenes()) {
    const Scene scene = small.make();
    EXPECT_EQ(scene.grid.h, 1) << small.name;
    for (const auto& part : contents_of(scene).parts) {
      const bool bar = small.name.rfind("bar", 0) == 0 && small.name != "bar-filtered",
                 hot = small.name.rfind("gas", 0) == 0 && small.maps.transfer == "flip";
      const double square = bar || small.name == "free-bar" ? 0.74 : hot ? 1.05 : 1;
      EXPECT_NEAR(part.speed, std::sqrt(square), 0.004) << small.name << ", " << part.body;
    }
  }
}

// The plate turns by 0.15, swells by 0.3 of 0.03 in both directions and moves on by 0.03 along x: a velocity that is affine,
// its symmetric part the same in all directions.
TEST(SmallScenes, ThePlateTurnsSwellsAndMovesOn) {
  const Scene scene = small_scene("plate-turning").make();
  const Columns& points = scene.bodies[0].points;
  double centre[2] = {}, moves[2] = {};
  for (int p = 0; p < points.points(); ++p) {
    for (int d = 0; d < 2; ++d) {
      centre[d] += points(column::position, d)[p] / points.points();
      moves[d] += points(column::velocity, d)[p] / points.points();
    }
  }
  EXPECT_NEAR(moves[0], 0.03, 1e-14);
  EXPECT_NEAR(moves[1], 0, 1e-14);
  for (int p = 0; p < points.points(); ++p) {
    const double x = points(column::position, 0)[p] - centre[0], y = points(column::position, 1)[p] - centre[1];
    const double u = points(column::velocity, 0)[p] - moves[0], v = points(column::velocity, 1)[p] - moves[1];
    const double square = x * x + y * y;
    EXPECT_NEAR((u * x + v * y) / square, 0.3 * 0.03, 1e-13);
    EXPECT_NEAR((v * x - u * y) / square, 0.15, 1e-13);
  }
}

// A taut string: each segment of the bent line is longer than at rest, by 5 % along a straight one.
TEST(SmallScenes, TheStringIsTaut) {
  const Columns points = small_scene("string").make().bodies[0].points;
  double end = 0, rest = 0;
  for (int p = 0; p + 1 < points.points(); ++p) {
    const double along = points(column::position, 0)[p + 1] - points(column::position, 0)[p];
    const double across = points(column::position, 1)[p + 1] - points(column::position, 1)[p];
    EXPECT_NEAR(along / points(column::rest_length)[p], 1.05, 1e-12);
    EXPECT_GT(std::hypot(along, across), points(column::rest_length)[p]);
    end += along;
    rest += points(column::rest_length)[p];
  }
  EXPECT_NEAR(end / rest, 1.05, 1e-12);
}

// Of the second plate three times the mass of its volume, and the same velocity of waves.
TEST(SmallScenes, TheSecondPlateIsThreeTimesAsDense) {
  const Scene scene = small_scene("two-bodies").make();
  ASSERT_EQ(scene.bodies.size(), 2U);
  for (std::size_t b = 0; b < 2; ++b) {
    const Columns& points = scene.bodies[b].points;
    for (int p = 0; p < points.points(); ++p)
      EXPECT_NEAR(points(column::mass)[p], (b == 0 ? 1 : 3) * points(column::volume)[p], 1e-14);
  }
}

// At rest on the walls of the corner, and nowhere else: what holds a wall has a part in every step.
TEST(SmallScenes, VelocitiesVanishTowardsTheWallsTheyWouldCross) {
  for (const char* name : {"plate", "block", "solid-rings", "gas-plane"}) {
    const Scene scene = small_scene(name).make();
    const Columns& points = scene.bodies[0].points;
    for (int p = 0; p < points.points(); ++p) {
      for (int d = 0; d < scene.grid.dim; ++d) {
        const double x = points(column::position, d)[p], v = points(column::velocity, d)[p];
        EXPECT_LE(std::abs(v), 0.03 * (1 + 0.3 * d) * (0.45 + 0.11 * d) * x) << name;  // sin(k x) <= k x
      }
    }
  }
}

}  // namespace
}  // namespace plumbline::small_scenes_test
