// The bar's points, its start, and what is measured of it.
#include "cases/catalog/solid/elastic_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "cases/harness/run/experiment.hpp"
#include "reference/bar_vibration.hpp"
#include "tests/cases/catalog/solid/ordered_profile.hpp"

namespace plumbline::elastic_bar_test {
namespace {

Scene scene_of(const std::string& name, const std::vector<std::string>& typed = {}) {
  const Case& entry = find_case(name);
  return entry.problem(entry.settings("default", {}, typed))->scene();
}

TEST(ElasticBar, FixedAndFreeEnds) {
  const Scene fixed = scene_of("bar-vibration", {"cells=10"}), loose = scene_of("bar-riemann", {"cells=10"});
  EXPECT_EQ(fixed.grid.walls[0][0], Wall::symmetry);
  EXPECT_EQ(fixed.grid.walls[0][1], Wall::free);
  EXPECT_EQ(fixed.grid.origin[0], 0);
  EXPECT_EQ(loose.grid.walls[0][0], Wall::free);
  EXPECT_LT(loose.grid.origin[0], -1.9 * loose.grid.h);
  for (const Scene* scene : {&fixed, &loose}) {
    const Columns& points = scene->bodies[0].points;
    const auto volume = points.values(column::volume);
    const double length = scene == &fixed ? 25 : 1;
    EXPECT_NEAR(std::accumulate(volume.begin(), volume.end(), 0.0), length, 1e-12 * length);
    EXPECT_NEAR(points(column::position)[0], length / 40, 1e-12);
  }
}

TEST(ElasticBar, StartsInTheExactState) {
  const Scene scene = scene_of("bar-vibration", {"velocity=0.3"});
  const Columns& points = scene.bodies[0].points;
  reference::BarVibrationProblem problem;
  problem.velocity = 0.3;
  const reference::BarVibration exact(problem);
  const double k = std::acos(-1.0) / 50;
  for (int p = 0; p < points.points(); ++p) {
    const double x = points(column::position)[p];
    EXPECT_DOUBLE_EQ(points(column::velocity)[p], exact.velocity(x, 0).value);
    EXPECT_NEAR(points(column::affine)[p], 0.3 * k * std::cos(k * x), 1e-15);
    EXPECT_EQ(points(column::strain)[p], 0);
  }
}

// Against the reference that the settings ask for, with its bound; energy can only be lost.
TEST(ElasticBar, MeasuresAgainstTheReference) {
  const Case& entry = find_case("bar-vibration");
  const RunResult run = run_experiment(
      entry, "default",
      entry.settings("default", {}, {"cells=16", "velocity=0.001", "youngs_modulus=400", "t_end=12"}));
  ASSERT_TRUE(run.finished);
  EXPECT_NEAR(*run.find("period")->reference, 5, 1e-12);
  EXPECT_NEAR(*run.find("period")->value, 5, 0.01);
  EXPECT_GT(run.find("displacement.L2")->reference_bound, 0);
  EXPECT_EQ(*run.find("energy_rise")->value, 0);
  EXPECT_GT(*run.find("energy_lost")->value, 0);
  EXPECT_NEAR(*run.find("energy_lost")->value, 1 - run.ledger.stores.total() / run.ledger.initial_stores.total(),
              1e-3 * *run.find("energy_lost")->value);
  // v0/omega over a bar of 25, at t = 12 of a period of 5 near its crest again; the norm of sin over it is sqrt(25/2).
  EXPECT_NEAR(run.find("displacement.worst")->scale, 0.001 / (0.4 * std::acos(-1.0)) * std::sqrt(12.5), 1e-4);
}

TEST(ElasticBar, ProfilesAreInTheOrderOfThePoints) {
  const Case& entry = find_case("bar-riemann");
  const RunResult run = run_experiment(entry, "default", entry.settings("default", {}, {"cells=20"}));
  expect_ordered_profile(run, 40);
}

}  // namespace
}  // namespace plumbline::elastic_bar_test
