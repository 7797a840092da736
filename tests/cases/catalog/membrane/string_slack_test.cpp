// Where the slack stands, and the times read off the support's reaction.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/run/experiment.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "reference/slack_string.hpp"
#include "tests/cases/catalog/run_by_name.hpp"

namespace plumbline::string_slack_test {
namespace {

const Case& slack() { return find_case("string-slack"); }

Scene scene_of(const std::string& scheme, const std::vector<std::string>& typed = {}) {
  return slack().problem(slack().settings(scheme, {}, typed))->scene();
}

// Ten points from 1.99 to 1.69; the fourth to the ninth less one start with a stress of -1e5, a strain of -0.1.
TEST(StringSlack, YorksTenPoints) {
  const Scene scene = scene_of("york1997");
  const Columns& points = scene.bodies[0].points;
  ASSERT_EQ(points.points(), 10);
  for (int p = 0; p < 10; ++p) {
    EXPECT_NEAR(points(column::position)[p], 1.99 - p / 30.0, 1e-14);
    EXPECT_NEAR(points(column::strain)[p], p >= 3 && p <= 8 ? -0.1 : 0.0, 1e-15) << p;
  }
  EXPECT_EQ(points(column::mass)[9], 3.33);
  EXPECT_DOUBLE_EQ(slack().settings("york1997", {}).number("dt"), 1.8e-6);
}

// The string hangs 0.02 shorter than it is: rest lengths sum to 0.3, and the mass starts 0.28 below the support.
TEST(StringSlack, EvenSlack) {
  const Scene scene = scene_of("default", {"cells=40"});
  const Columns& points = scene.bodies[0].points;
  const int last = points.points() - 1;
  EXPECT_EQ(points(column::position)[0], 2.0);
  EXPECT_NEAR(points(column::position)[last], 2.0 - 0.28, 1e-14);
  double rest = 0;
  for (int s = 0; s < last; ++s) rest += points(column::rest_length)[s];
  EXPECT_NEAR(rest, 0.3, 1e-14);
  EXPECT_NEAR(points(column::strain)[0], -0.02 / 0.3, 1e-15);
  double mass = 0;
  for (int p = 0; p <= last; ++p) mass += points(column::mass)[p];
  EXPECT_NEAR(mass, 3.33 + 0.1 * 0.1 * 0.3, 1e-12);
}

// Summed strain comes back to zero where the string is straight: the integral of dl/l from 0.28 to 0.3.
TEST(StringSlack, SummedStrainIsLogarithmic) {
  const Scene scene = scene_of("default", {"cells=40", "strain=accumulated"});
  EXPECT_NEAR(scene.bodies[0].points(column::strain)[3], std::log(0.28 / 0.3), 1e-15);
}

// All slack above what the kernel of the mass reaches, 1.5 cells of the unstretched string.
TEST(StringSlack, ClearOfTheMass) {
  const Scene scene = scene_of("default", {"cells=40", "layout=clear"});
  const Columns& points = scene.bodies[0].points;
  const int last = points.points() - 1;
  EXPECT_NEAR(points(column::position)[last], 2.0 - 0.28, 1e-14);
  for (int s = 0; s < last; ++s) {
    const bool reached = s >= last - 6;  // 1.5 cells of four points
    EXPECT_EQ(points(column::strain)[s] == 0, reached) << s;
  }
}

TEST(StringSlack, ReferencesMoveWithTheSettings) {
  reference::SlackStringProblem p;
  p.slack = 0.03;
  p.mass = 5;
  const reference::SlackString exact(p);
  const RunResult result = run_experiment(slack(), "default",
                                          slack().settings("default", {}, {"cells=20", "slack=0.03", "mass=5"}));
  EXPECT_EQ(*measure(result, "taut_time").reference, exact.taut_time().value);
  EXPECT_EQ(*measure(result, "release_time").reference, exact.release_time().value);
  EXPECT_EQ(*measure(result, "apex_time").reference, exact.apex_time().value);
  EXPECT_EQ(*measure(result, "max_displacement").reference, exact.max_displacement().value);
}

// Free fall until the string is straight: g t^2/2 without any pull but of the string's own few grams.
TEST(StringSlack, FallsFreelyWhileSlack) {
  const RunResult result = run_experiment(slack(), "default",
                                          slack().settings("default", {}, {"cells=80", "t_end=0.012"}));
  const auto &t = result.profile.find("time")->values, &u = result.profile.find("displacement")->values;
  ASSERT_GT(t.size(), 100u);
  // A step moves with the velocity it ends with: half a step more than g t^2 / 2 each time.
  const double dt = result.dt;
  for (std::size_t k = 10; k < t.size(); ++k) {
    EXPECT_NEAR(u[k], 125 * t[k] * (t[k] + dt), 1e-3 * 0.02) << t[k];
  }
}

// Times in order, each within 5 % at 80 cells: a wrong sign, a shift of the mean or a swapped crossing is further off.
TEST(StringSlack, TimesAreInOrder) {
  const RunResult result = run_experiment(slack(), "default", slack().settings("default", {}, {"cells=80"}));
  const double taut = *measure(result, "taut_time").value, release = *measure(result, "release_time").value;
  EXPECT_NEAR(taut, 0.012649, 0.05 * 0.012649);
  EXPECT_NEAR(release, 0.024127, 0.05 * 0.024127);
  EXPECT_NEAR(*measure(result, "apex_time").value, 0.036776, 0.05 * 0.036776);
}

}  // namespace
}  // namespace plumbline::string_slack_test
