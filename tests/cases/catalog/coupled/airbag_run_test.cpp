// The probe, and the scene of a probe on an airbag.
#include "cases/catalog/coupled/airbag_run.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "cases/catalog/solid/collision.hpp"
#include "cases/harness/files/errors.hpp"

namespace plumbline::airbag_run_test {
namespace {

const AirbagSpec narrow{.name = "probe", .mass = 6.03, .radius = 0.1, .speed = 3.9, .crown = 0.318, .end_time = 0.1};

// On any mesh the probe has its mass, and its points fill it.
TEST(AirbagRun, ProbeIsWhole) {
  for (const int cells : {12, 25, 36}) {
    const Body probe = airbag_probe(narrow, airbag_grid(cells), 2, 0.3);
    double mass = 0, volume = 0;
    for (int p = 0; p < probe.points.points(); ++p) {
      mass += probe.points(column::mass)[p];
      volume += probe.points(column::volume)[p];
    }
    EXPECT_NEAR(2 * std::numbers::pi * mass, 6.03, 1e-12);
    EXPECT_NEAR(volume, 0.5 * 0.1 * 0.1 * 0.08, 1e-15);
    EXPECT_NEAR(motion_of(probe, 2).position[1], 0.34, 1e-12);
    EXPECT_NEAR(probe.spacing, 0.5 * airbag_grid(cells).h, 0.2 * airbag_grid(cells).h);
  }
}

// The face stands at the pole, the probe alone moves and has a velocity field of its own.
TEST(AirbagRun, SceneAtImpact) {
  const Settings settings = find_case("airbag-200").settings("default", {{"cells", 12.0}});
  const Scene scene = find_case("airbag-200").problem(settings)->scene();
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[0].field, scene.bodies[1].field);
  EXPECT_NE(scene.bodies[2].field, scene.bodies[1].field);
  EXPECT_DOUBLE_EQ(motion_of(scene.bodies[2], 2).velocity[1], -3.9);
  EXPECT_EQ(motion_of(scene.bodies[1], 2).velocity[1], 0);
  const double row = scene.bodies[2].points(column::position, 1)[0] - highest_point(scene.bodies[1], 1);
  EXPECT_NEAR(row, 0.5 * 0.08 / 4, 1e-12);  // four rows of points in the probe at h = 41.7 mm, two a cell
}

TEST(AirbagRun, AccumulatedStrainIsRefused) {
  const Settings settings = find_case("airbag-200").settings("default", {{"membrane.strain", "accumulated"}});
  EXPECT_THROW(find_case("airbag-200").problem(settings), UsageError);
}

}  // namespace
}  // namespace plumbline::airbag_run_test
