// Set-ups of the vibrating string, the hanging chain and the catenary: tension, balance and mass as the references have them.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/run/experiment.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "reference/catenary.hpp"
#include "reference/hanging_chain.hpp"
#include "reference/string_vibration.hpp"

namespace plumbline::taut_strings_test {
namespace {

Scene scene_of(const std::string& name, const std::vector<std::string>& typed = {}) {
  const Case& entry = find_case(name);
  return entry.problem(entry.settings("default", {}, typed))->scene();
}

double total_mass(const Scene& scene) {
  double mass = 0;
  for (const double m : scene.bodies[0].points.values(column::mass)) mass += m;
  return mass;
}

const SegmentMembrane& segments_of(const Scene& scene) {
  return dynamic_cast<const SegmentMembrane&>(*scene.bodies[0].material);
}

TEST(TautStrings, TheVibratingStringsTensionAndPlace) {
  reference::StringVibrationProblem p;
  p.amplitude = 1e-4;
  const reference::StringVibration exact(p);
  const Scene scene = scene_of("string-vibration", {"cells=10"});
  const Columns& points = scene.bodies[0].points;
  ASSERT_EQ(points.points(), 41);
  for (int s = 0; s < 40; ++s) {
    EXPECT_NEAR(segments_of(scene).tension(points(column::strain)[s]), exact.tension().value, 1e-9);
  }
  EXPECT_NEAR(points(column::position, 1)[20], 1e-4, 1e-18);
  EXPECT_NEAR(total_mass(scene), 0.1 * 0.1, 1e-14);
  EXPECT_EQ(scene.grid.walls[0][0], Wall::no_slip);
  EXPECT_EQ(scene.grid.walls[0][1], Wall::no_slip);
}

// Each segment bears what hangs below its middle.
TEST(TautStrings, TheHangingChainCarriesItself) {
  for (const char* stretch : {"stretch=1e-3", "stretch=2e-2"}) {
    const Scene scene = scene_of("hanging-chain", {"cells=10", stretch});
    const Columns& points = scene.bodies[0].points;
    const int last = points.points() - 1;
    double below = 0;
    for (int s = last - 1; s >= 0; --s) {
      below += points(column::mass)[s + 1];
      EXPECT_NEAR(segments_of(scene).tension(points(column::strain)[s]), 9.81 * below, 1e-10) << s;
    }
    EXPECT_NEAR(total_mass(scene), 1, 1e-13);
    EXPECT_EQ(points(column::position)[last], 1e-3);
  }
}

// Supports at one height, mass exact, tension of each segment that of the catenary at its middle.
TEST(TautStrings, TheCatenaryStartsAtRest) {
  reference::CatenaryProblem p;
  p.weight = 9.81;
  p.compliance = 1e-3 / (9.81 * 1.2);
  const reference::Catenary exact(p);
  const Scene scene = scene_of("catenary", {"cells=20"});
  const Columns& points = scene.bodies[0].points;
  const int last = points.points() - 1;
  EXPECT_EQ(last, 96);
  EXPECT_EQ(points(column::position)[last], 1);
  EXPECT_EQ(points(column::position, 1)[last], 0);
  EXPECT_NEAR(-points(column::position, 1)[last / 2], exact.sag().value, 1e-14);
  EXPECT_NEAR(total_mass(scene), 1.2, 1e-13);
  for (int s = 0; s < last; ++s) {
    EXPECT_NEAR(segments_of(scene).tension(points(column::strain)[s]), exact.tension(1.2 * (s + 0.5) / last).value,
                1e-9);
    // A chord is shorter than its arc by (l kappa)^2/24, at the lowest point kappa = 1/a; twice that for the next order.
    const double bend = 1.2 / last / exact.parameter().value;
    EXPECT_NEAR(points(column::rest_length)[s], 1.2 / last, bend * bend / 12 * 1.2 / last) << s;
  }
}

// The walls bear the chain's weight over the run.
TEST(TautStrings, TheWallsBearTheCatenary) {
  const Case& entry = find_case("catenary");
  for (const char* strain : {"strain=segments", "strain=accumulated"}) {
    const RunResult result = run_experiment(entry, "default", entry.settings("default", {}, {"cells=10", strain}));
    ASSERT_TRUE(result.finished);
    EXPECT_NEAR(*result.find("reaction")->value, 9.81 * 1.2, 1e-3);
    EXPECT_EQ(result.find("tension.L1")->scale > 5, true);
  }
}

}  // namespace
}  // namespace plumbline::taut_strings_test
