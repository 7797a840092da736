#include "cases/harness/laboratory/scene_limit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/run/experiment.hpp"
#include "tests/cases/harness/laboratory/made_up_integrators.hpp"

namespace plumbline::scene_limit_test {
namespace {

struct SampleRun {
  const char* name;
  std::vector<Override> overrides;
  std::set<std::string> problems;  // those that occur
  const char* scheme = "default";
};

// A case of every kind of scene, on few cells.
const std::vector<SampleRun>& runs() {
  static const std::vector<SampleRun> all{
      {"sod", {{"cells", 50.0}}, {"gas"}},
      {"gas-expansion", {{"cells", 10.0}}, {"gas", "bar-edge"}},
      {"noh", {{"cells", 20.0}}, {"gas"}},  // without pressure, and so without a speed of sound
      {"bar-vibration", {{"cells", 13.0}}, {"bar", "bar-edge"}},
      {"two-disks", {{"cells", 12.0}}, {"bar", "bar-edge", "contact"}},
      {"string-vibration", {{"cells", 20.0}}, {"membrane"}},
      {"spring-mass", {}, {"bar-edge", "membrane"}},
      {"membrane-expansion", {{"cells", 8.0}, {"t_end", 0.5}}, {"bar-edge", "coupled", "gas", "membrane"}}};
  return all;
}

Settings settings_of(const SampleRun& run, const Value& cfl) {
  std::vector<Override> overrides = run.overrides;
  overrides.emplace_back("cfl", cfl);
  return find_case(run.name).settings(run.scheme, overrides);
}

std::vector<SceneLimit> limits_of_run(const SampleRun& run) {
  const Case& entry = find_case(run.name);
  const Settings settings = settings_of(run, 0.5);
  return limits_in(entry.problem(settings)->scene(), settings);
}

TEST(SceneLimit, EveryProblemThatAppliesOccursAndAutoIsItsShareOfTheSmallest) {
  for (const SampleRun& run : runs()) {
    const std::vector<SceneLimit> limits = limits_of_run(run);
    const double cfl = settings_of(run, "auto").number("cfl");
    EXPECT_EQ(cfl, auto_share * limits.front().courant) << run.name;
    std::set<std::string> found;
    for (const SceneLimit& limit : limits) {
      found.insert(limit.problem->name());
      EXPECT_GT(limit.limit, 0) << run.name << " " << limit.problem->name();
      EXPECT_LE(cfl, auto_share * limit.courant) << run.name << " " << limit.problem->name();
    }
    EXPECT_EQ(found, run.problems) << run.name;
  }
}

double largest_store(const SampleRun& run, double cfl) {
  const RunResult result = run_experiment(find_case(run.name), run.scheme, settings_of(run, cfl));
  EXPECT_TRUE(result.finished) << run.name;
  double largest = 0;
  for (const auto& series : result.history.series) {
    if (series.quantity != "energy" || series.column != "store") continue;
    for (const double store : series.values) largest = std::max(largest, std::abs(store));
  }
  return largest;
}

// What grows from step to step soon exceeds any multiple of what a run at half the step has.
TEST(SceneLimit, RunsHoldAtIt) {
  for (const SampleRun& run : runs()) {
    const double cfl = settings_of(run, "auto").number("cfl");
    EXPECT_LE(largest_store(run, cfl), 2 * largest_store(run, 0.5 * cfl)) << run.name;
  }
}

// The limit of the free end is a fifth of that of the inside.
TEST(SceneLimit, FreeEdgesCount) {
  const std::vector<Override> choices{{"integrator", "usl"}, {"shape", "linear"}, {"transfer", "flip"}};
  SampleRun free{"bar-vibration", {{"cells", 13.0}}, {}};
  free.overrides.insert(free.overrides.end(), choices.begin(), choices.end());
  const SceneLimit smallest = limits_of_run(free).front();
  EXPECT_EQ(smallest.problem->name(), "bar-edge");
  EXPECT_NEAR(smallest.courant, std::sqrt(0.02), 0.01 * std::sqrt(0.02));
  EXPECT_LE(settings_of(free, "auto").number("cfl"), auto_share * std::sqrt(0.02) * 1.01);
}

// With one point a cell the problem `plane`, at a corner 1/sqrt(2); at an edge the line's limit over sqrt(2), and inside
// too where there are more points.
TEST(SceneLimit, InThePlaneWavesHaveTwoDirections) {
  SampleRun disks{"two-disks",
                  {{"cells", 12.0}, {"integrator", "musl"}, {"shape", "linear"}, {"transfer", "flip"}, {"ppc", 1.0}},
                  {}};
  double plane = HUGE_VAL;
  for (const SceneLimit& limit : limits_of_run(disks)) {
    if (limit.problem->name() == "plane") plane = std::min(plane, limit.courant);
    if (limit.problem->name() == "bar-edge") {
      EXPECT_NEAR(limit.courant, limit.limit / std::sqrt(2.0), 1e-12);
    }
  }
  EXPECT_NEAR(plane, 0.75129, 2e-3);  // the waves' own matrices, a hundredth of a cell beside the corner
  disks.overrides.back().second = 2.0;
  for (const SceneLimit& limit : limits_of_run(disks)) {
    EXPECT_NE(limit.problem->name(), "plane");
    EXPECT_NEAR(limit.courant, limit.limit / std::sqrt(2.0), 1e-12) << limit.problem->name();
  }
}

// In units of the membrane, which is faster than the gas.
TEST(SceneLimit, CoupledLimitsCountTheFastestWave) {
  const SampleRun bag{"membrane-expansion", {{"cells", 8.0}}, {}};
  for (const SceneLimit& limit : limits_of_run(bag)) {
    if (limit.problem->name() != "coupled") continue;
    const double ratio = limit.settings.number("stiffness_ratio") / limit.settings.number("density_ratio");
    EXPECT_GT(ratio, 100);
    EXPECT_NEAR(limit.courant, limit.limit * std::sqrt(ratio / 2), 1e-9 * limit.courant);
  }
}

TEST(SceneLimit, WithoutAStableStepTheErrorNamesTheProblem) {
  SampleRun bar{"bar-vibration",
                {{"cells", 13.0}, {"integrator", made_up::forward_euler}, {"shape", "linear"}, {"transfer", "flip"}},
                {}};
  try {
    settings_of(bar, "auto");
    FAIL() << "a step was found";
  } catch (const UsageError& error) {
    const std::string text = error.what();
    EXPECT_EQ(error.key, "cfl");
    EXPECT_NE(text.find("no stable step on problem bar"), std::string::npos) << text;
    EXPECT_NE(text.find("linear flip"), std::string::npos) << text;
  }
}

TEST(SceneLimit, IsTheSameAgain) {
  const SampleRun& run = runs().front();
  EXPECT_EQ(settings_of(run, "auto").number("cfl"), settings_of(run, "auto").number("cfl"));
}

}  // namespace
}  // namespace plumbline::scene_limit_test
