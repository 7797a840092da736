// A final state handed in is judged as the run that it came from; what a problem saw on the way it says honestly.
#include "cases/harness/exchange/final_state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "cases/harness/run/experiment.hpp"
#include "kernel/materials/material_entry.hpp"
#include "tests/cases/harness/scene_cases.hpp"

namespace plumbline::final_state_test {
namespace {

constexpr int few_steps = 20;

// Rows by the points' numbers, as an export has them.
HandedIn by_number(const Body& body) {
  HandedIn in{body.points.points(), body.points};
  std::vector<int> order(body.id.size());
  for (std::size_t p = 0; p < body.id.size(); ++p) order[static_cast<std::size_t>(body.id[p])] = static_cast<int>(p);
  in.columns.reorder(order);
  return in;
}

struct SomeSteps {
  std::unique_ptr<Problem> problem;
  std::unique_ptr<Simulation> simulation;

  SomeSteps(const Case& entry, const Settings& settings) : problem(entry.problem(settings)) {
    Scene scene = problem->scene();
    scene.split = 0;
    simulation = std::make_unique<Simulation>(std::move(scene), settings.text("integrator"), step_control(settings));
    for (int k = 0; k < few_steps && simulation->time() < problem->end_time(); ++k) {
      simulation->step(problem->end_time() - simulation->time());
      problem->observe(*simulation);
    }
    simulation->refresh_density();
  }
};

int points_of(const Scene& scene) {
  int points = 0;
  for (const Body& body : scene.bodies) points += body.points.points();
  return points;
}

bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

Settings coarse(const Case& entry) {
  const std::vector<double> levels = entry.levels;
  return entry.settings("default", {{"cells", *std::min_element(levels.begin(), levels.end())}});
}

TEST(FinalState, MeasuresThatNeedNoWayAreTheSameForAProblemThatSawNone) {
  int judged = 0;
  for (const Case* entry : scene_cases()) {
    const Settings settings = coarse(*entry);
    if (!why_not_scored(*entry, settings).empty()) continue;
    if (points_of(entry->problem(settings)->scene()) > 5000) continue;  // the same classes as on a line, at more cost
    ++judged;
    const SomeSteps run(*entry, settings);
    const auto fresh = entry->problem(settings);
    fresh->scene();
    const auto seen = measures_at_end(*run.problem, *run.simulation), blind = measures_at_end(*fresh, *run.simulation);
    ASSERT_EQ(seen.size(), blind.size()) << entry->name;
    EXPECT_FALSE(seen.empty()) << entry->name;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      EXPECT_EQ(seen[k].name, blind[k].name);
      EXPECT_TRUE(same(seen[k].error, blind[k].error)) << entry->name << " " << seen[k].name;
    }
  }
  EXPECT_GT(judged, 20);
}

// No case ends where it begins: the start handed back is far from the end in some field, or nowhere near the place where it is
// judged, so that doing nothing is seen.
TEST(FinalState, TheStartIsNoEnd) {
  constexpr double far = 0.3;  // of the field's size
  for (const Case* entry : scene_cases()) {
    const Settings settings = coarse(*entry);
    if (!why_not_scored(*entry, settings).empty()) continue;
    double furthest = 0;
    for (const Measure& m : measures_of_start(*entry->problem(settings), settings)) {
      if (!m.name.ends_with(".L1") || m.scale <= m.reference_bound) continue;
      furthest = std::isfinite(m.error) ? std::max(furthest, m.error / m.scale) : HUGE_VAL;
    }
    EXPECT_GT(furthest, far) << entry->name;
  }
}

TEST(FinalState, HandedInPointsAreMeasuredAsTheRunTheyCameFrom) {
  for (const char* name : {"sod", "bar-riemann", "mms-bar", "mms-vortex", "plane-stress", "acoustic-pulse"}) {
    const Case& entry = find_case(name);
    const Settings settings = coarse(entry);
    const SomeSteps run(entry, settings);
    std::vector<HandedIn> points;
    for (const Body& body : run.simulation->scene().bodies) points.push_back(by_number(body));
    const auto again = simulation_of(*run.problem, settings, points, run.simulation->time());
    const auto expected = measures_at_end(*run.problem, *run.simulation), got = measures_at_end(*run.problem, *again);
    ASSERT_EQ(expected.size(), got.size());
    for (std::size_t k = 0; k < got.size(); ++k) {
      // Sums over other orders of the points.
      EXPECT_NEAR(got[k].error, expected[k].error, 1e-12 * (expected[k].error + expected[k].scale))
          << name << " " << got[k].name;
    }
  }
}

// Nothing that the file says may be worked out anew: another density shows in the measures as it is.
TEST(FinalState, DensitiesAreThoseHandedIn) {
  const Case& entry = find_case("sod");
  const Settings settings = entry.settings("default", {{"cells", 50.0}});
  const auto problem = entry.problem(settings);
  const Scene scene = problem->scene();
  HandedIn points{scene.bodies[0].points.points(), scene.bodies[0].points};
  for (int p = 0; p < points.points; ++p) points.columns(column::density)[p] = 7;
  const auto simulation = simulation_of(*problem, settings, {points}, 0.1);
  EXPECT_EQ(simulation->time(), 0.1);
  EXPECT_THAT(simulation->scene().bodies[0].points.values(column::density), testing::Each(7.0));
}

TEST(FinalState, AnyNumberOfPointsOfAGas) {
  const Case& entry = find_case("sod");
  const Settings settings = entry.settings("default", {{"cells", 20.0}});
  const auto problem = entry.problem(settings);
  for (const int count : {1, 7, 5000}) {
    HandedIn points{count, Columns(count)};
    for (const ColumnId& id : {column::position, column::velocity, column::mass, column::density, column::energy,
                               column::pressure, column::volume}) {
      points.columns.add(id);
      for (int p = 0; p < count; ++p) points.columns(id)[p] = (p + 0.5) / count;
    }
    const auto simulation = simulation_of(*problem, settings, {points}, problem->end_time());
    EXPECT_EQ(simulation->points(), count);
    EXPECT_FALSE(measures_at_end(*problem, *simulation).empty());
  }
}

TEST(FinalState, CasesJudgedOnTheWayAreRefused) {
  for (const char* name : {"pendulum", "two-disks", "stability-bar", "normals-cell", "airbag-200"}) {
    const Case& entry = find_case(name);
    EXPECT_NE(why_not_scored(entry, entry.settings("default", {})), "") << name;
  }
}

// Whoever exports a scene writes its materials down.
TEST(Exchange, EveryMaterialOfEveryCaseStatesItsParameters) {
  for (const Case* entry : scene_cases()) {
    for (const Body& body : entry->problem(coarse(*entry))->scene().bodies) {
      EXPECT_NO_THROW(EXPECT_FALSE(parameters_of(*body.material).empty())) << entry->name;
    }
  }
}

TEST(Exchange, ProblemIdFollowsPhysicsAlone) {
  const Case& sod = find_case("sod");
  const std::string id = problem_id(sod, sod.settings("default", {}));
  EXPECT_EQ(id, problem_id(sod, sod.settings("york1997", {{"cells", 37.0}})));
  EXPECT_NE(id, problem_id(sod, sod.settings("default", {{"gamma", 1.41}})));
}

}  // namespace
}  // namespace plumbline::final_state_test
