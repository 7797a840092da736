// The pendulum's points and boxes, York's and the default's, and what is measured of the swing.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/run/experiment.hpp"
#include "reference/elastic_pendulum.hpp"
#include "tests/cases/catalog/run_by_name.hpp"

namespace plumbline::pendulum_test {
namespace {

const Case& pendulum() { return find_case("pendulum"); }

Scene scene_of(const std::string& scheme, const std::vector<std::string>& typed = {}) {
  return pendulum().problem(pendulum().settings(scheme, {}, typed))->scene();
}

RunResult run(const std::vector<std::string>& typed) {
  const RunResult result = run_experiment(pendulum(), "default", pendulum().settings("default", {}, typed));
  EXPECT_TRUE(result.finished);
  return result;
}

// 20, 40, 80 and 320 points on the four meshes, from (0.33333, 0.99990) to (0.101, 0.303). [York section A.4.5]
TEST(Pendulum, YorksPoints) {
  const std::pair<const char*, int> meshes[] = {{"cells=5", 20}, {"cells=10", 40}, {"cells=20", 80}, {"cells=40", 320}};
  for (const char* scheme : {"default", "york1997"}) {
    for (const auto& [cells, points] : meshes) {
      const Scene scene = scene_of(scheme, {cells});
      ASSERT_EQ(scene.bodies[0].points.points(), points) << scheme << cells;
    }
  }
  const Scene scene = scene_of("york1997");
  const Columns& points = scene.bodies[0].points;
  EXPECT_NEAR(points(column::position)[1], 0.32738, 1e-5);
  EXPECT_NEAR(points(column::position, 1)[1], 0.98203, 1e-5);
  EXPECT_NEAR(points(column::position)[39], 0.101, 1e-15);
  EXPECT_NEAR(points(column::position, 1)[39], 0.303, 1e-15);
}

// York's bob weighs 3.3 with its share of the string, the default's beside it.
TEST(Pendulum, TheBobsMass) {
  const double half = 0.1 * 0.1 * 0.7346067 / 79 / 2;
  EXPECT_EQ(scene_of("york1997").bodies[0].points(column::mass)[39], 3.3);
  EXPECT_NEAR(scene_of("default").bodies[0].points(column::mass)[79], 3.3 + half, 1e-11);
}

TEST(Pendulum, PointsPerCellWhereAsked) {
  EXPECT_EQ(scene_of("default", {"layout=ppc", "cells=20", "ppc=3"}).bodies[0].points.points(), 1 + 44);
}

// York's box is 0.7 x 1, four cells wide at h = 0.2; its top is above the string's. The wide box keeps walls away from
// the string by two cells and more, and its top is where the string is held.
TEST(Pendulum, Boxes) {
  const GridSpec york = scene_of("york1997").grid, coarse = scene_of("york1997", {"cells=5"}).grid;
  EXPECT_EQ(york.cells[0], 7);
  EXPECT_EQ(york.cells[1], 10);
  EXPECT_EQ(york.origin[0], 0);
  EXPECT_NEAR(york.origin[1] + 10 * york.h, 1, 1e-15);
  EXPECT_EQ(coarse.cells[0], 4);
  for (const char* cells : {"cells=5", "cells=10", "cells=20"}) {
    const GridSpec wide = scene_of("default", {cells}).grid;
    EXPECT_NEAR(wide.origin[1] + wide.cells[1] * wide.h, 0.99990, 1e-14);
    EXPECT_LE(wide.origin[0], 0.101 - 2 * wide.h);
    EXPECT_GE(wide.origin[0] + wide.cells[0] * wide.h, 2 * 0.33333 - 0.101 + 2 * wide.h);
    EXPECT_LE(wide.origin[1], 0.99990 - 0.7347 - 2 * wide.h);
    EXPECT_EQ(wide.walls[1][1], Wall::no_slip);
  }
}

TEST(Pendulum, YorksStep) {
  EXPECT_DOUBLE_EQ(pendulum().settings("york1997", {}).number("dt"), 2e-5);
  EXPECT_DOUBLE_EQ(pendulum().settings("york1997", {{"cells", 20.0}}).number("dt"), 1e-5);
  EXPECT_FALSE(pendulum().settings("default", {}).is_set("dt"));
  EXPECT_EQ(pendulum().settings("york1997", {}).text("strain"), "accumulated");
}

// The angle starts at -18.437 degrees and moves as the reference does.
TEST(Pendulum, TheAngleIsThatOfTheReference) {
  const RunResult result = run({"cells=10", "t_end=0.1"});
  const auto &angle = result.profile.find("angle")->values, &exact = result.profile.find("angle_reference")->values;
  ASSERT_EQ(angle.size(), exact.size());
  ASSERT_GT(angle.size(), 100u);
  EXPECT_NEAR(angle.front(), -18.437 * std::acos(-1.0) / 180, 1e-4);
  for (std::size_t k = 0; k < angle.size(); ++k) EXPECT_NEAR(angle[k], exact[k], 1e-3) << k;
}

TEST(Pendulum, TheReferenceMovesWithTheSettings) {
  for (const char* typed : {"mass=5", "gravity=30", "youngs_modulus=3e5", "string_density=0.3", "one_way=no"}) {
    reference::ElasticPendulumProblem p;
    const std::string key = typed;
    if (key == "mass=5") p.mass = 5;
    if (key == "gravity=30") p.gravity = 30;
    if (key == "youngs_modulus=3e5") p.youngs_modulus = 3e5;
    if (key == "string_density=0.3") p.density = 0.3;
    if (key == "one_way=no") p.one_way = false;
    const RunResult result = run({"cells=5", typed});
    EXPECT_EQ(*measure(result, "period").reference, reference::ElasticPendulum(p).heavy_period().value) << typed;
  }
}

// No turning point yet: no period and no loss, and that is no small error.
TEST(Pendulum, WithoutATurnThereIsNoPeriod) {
  const RunResult result = run({"cells=5", "t_end=0.2"});
  EXPECT_ANY_THROW(measure(result, "period"));
  EXPECT_ANY_THROW(measure(result, "amplitude_loss"));
  EXPECT_ANY_THROW(measure(result, "half_loss"));
  EXPECT_GT(*measure(result, "misalignment").value, 0);
}

// A whole swing on the coarsest mesh: the added inertia m h^2/4 makes the period too long by the share h^2/(8 L^2), 0.93 %.
TEST(Pendulum, SwingsAndComesBack) {
  const RunResult result = run({"cells=5"});
  EXPECT_NEAR(*measure(result, "period").value / *measure(result, "period").reference, 1.0093, 0.005);
  const double half = *measure(result, "half_loss").value, whole = *measure(result, "amplitude_loss").value;
  EXPECT_GT(half, 0);
  EXPECT_GT(whole, half);
  EXPECT_LT(whole, 0.05);
}

}  // namespace
}  // namespace plumbline::pendulum_test
