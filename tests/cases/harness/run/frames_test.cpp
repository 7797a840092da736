// Frames: when they are taken, what they hold, and that nobody's numbers change by being looked at.
#include "cases/harness/run/frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "cases/harness/judge/study.hpp"
#include "cases/harness/results/documents.hpp"
#include "cases/harness/run/experiment.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::frames_test {
namespace {

RunResult run(const Case& entry, const FrameRequest& frames,
              const std::vector<Override>& overrides = {{"cells", 8.0}}) {
  return run_experiment(entry, "default", entry.settings("default", overrides), 1, frames);
}

// Of a run with frames and one without, all numbers that a result has.
std::string numbers_of(RunResult run) {
  run.wall_s = 1;
  std::string all = run_document(run, {}, Provenance{}).dump();
  for (const LedgerHistory::Series& series : run.history.series) all += Json(series.values).dump();
  for (const ProfileColumn& column : run.profile.columns) all += Json(column.values).dump();
  return all;
}

TEST(Frames, NoneUnlessAskedFor) { EXPECT_TRUE(run(toy_case(), {}).frames.frames.empty()); }

class FrameCount : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Counts, FrameCount, ::testing::Values(2, 3, 4, 7, 11));

TEST_P(FrameCount, IsEvenlySpacedFromTheFirstInstantToTheLast) {
  const int count = GetParam();
  const FrameSet set = run(toy_case(), {count, 0}).frames;
  ASSERT_EQ(set.frames.size(), static_cast<std::size_t>(count));
  EXPECT_EQ(set.frames.front().time, 0);
  for (int k = 0; k < count; ++k) {
    const double wanted = 1e-2 * k / (count - 1), taken = set.frames[static_cast<std::size_t>(k)].time;
    EXPECT_GE(taken, wanted - 1e-14);
    EXPECT_LT(taken, wanted + 1e-3) << "of the first step at or after it";
  }
  EXPECT_NEAR(set.frames.back().time, 1e-2, 1e-14);
}

TEST(Frames, ARunOfFewStepsHasOneAStep) {
  const FrameSet set = run(toy_case(), {1000, 0}).frames;
  ASSERT_EQ(set.frames.size(), 11u);  // ten steps and the start
  std::set<double> times;
  for (const Frame& frame : set.frames) times.insert(frame.time);
  EXPECT_EQ(times.size(), 11u);
  EXPECT_NEAR(*times.rbegin(), 1e-2, 1e-14);
}

TEST(Frames, ChangeNoNumber) {
  for (const char* name : {"two-disks", "gas-expansion", "pendulum"}) {
    const Case& entry = find_case(name);
    const std::vector<Override> small{{"cells", 10.0}};
    EXPECT_EQ(numbers_of(run(entry, {}, small)), numbers_of(run(entry, {13, 0}, small))) << name;
  }
}

TEST(Frames, HoldThePointsAsTheyAre) {
  Toy toy;
  toy.dim = 2;
  std::vector<double> x, vx;
  toy.measures = [&](const Settings&, const Simulation& s) {
    const Columns& points = s.scene().bodies[0].points;
    x.assign(points(column::position), points(column::position) + 3);
    vx.assign(points(column::velocity), points(column::velocity) + 3);
    return std::vector<Measure>{};
  };
  const FrameSet set = run(toy_case(toy), {2, 0}).frames;
  ASSERT_EQ(set.bodies.size(), 1u);
  EXPECT_EQ(set.bodies[0].name, "toy");
  EXPECT_EQ(set.bodies[0].kind, "membrane");
  EXPECT_TRUE(set.bodies[0].chain);
  EXPECT_FALSE(set.bodies[0].closed);
  EXPECT_EQ(set.grid.dim, 2);
  const Frame& last = set.frames.back();
  EXPECT_EQ(last.points, std::vector<int>{3});
  EXPECT_EQ(last.id, (std::vector<int>{0, 1, 2}));
  ASSERT_EQ(last.position.size(), 9u);
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_EQ(last.position[3 * p], static_cast<float>(x[p]));
    EXPECT_EQ(last.position[3 * p + 1], 0.5F);
    EXPECT_EQ(last.position[3 * p + 2], 0.0F);
    EXPECT_EQ(last.velocity[3 * p], static_cast<float>(vx[p]));
    EXPECT_TRUE(std::isnan(last.pressure[p]));
  }
}

// A solid whose material keeps its pressure in a column is no gas: it has a stress to be drawn.
TEST(Frames, SolidsThatCarryAPressureAreSolids) {
  const FrameSet set = run(find_case("elastic-plastic-impact"), {2, 0}, {{"cells", 10.0}}).frames;
  EXPECT_EQ(set.bodies[0].kind, "solid");
  EXPECT_GT(set.frames.back().stress[0], 0.1F);  // behind the plastic wave, in units of the yield stress
}

TEST(Frames, ThePressureOfGasIsThereFromTheStart) {
  const FrameSet set = run(find_case("gas-expansion"), {2, 0}, {{"cells", 40.0}}).frames;
  EXPECT_EQ(set.bodies[0].kind, "gas");
  const Frame& first = set.frames[0];
  int inside = 0;
  for (std::size_t p = 0; p < first.pressure.size(); ++p) {
    EXPECT_TRUE(std::isnan(first.stress[p]));
    if (std::hypot(first.position[3 * p], first.position[3 * p + 1]) > 0.27F)
      continue;  // a map and a look back reach four cells
    ++inside;
    EXPECT_NEAR(first.pressure[p], 100, 1e-3);  // [York 4.2]
  }
  EXPECT_GT(inside, 100);
}

// --- stress, by hand ------------------------------------------------------------------------------------------------

Frame look(Body body, bool axisymmetric = false) {
  Scene scene;
  scene.grid.dim = 2;
  scene.grid.axisymmetric = axisymmetric;
  scene.grid.h = 0.1;
  scene.grid.cells = {10, 10, 1};
  scene.bodies.push_back(std::move(body));
  Simulation simulation(std::move(scene), "musl", {});
  FrameRecorder recorder({2, 0}, simulation.scene(), 1);
  recorder.look(simulation);
  return recorder.take().frames.at(0);
}

Body one_point(const std::shared_ptr<const Material>& material, const std::vector<double>& strain, bool rings = false) {
  Body body = make_body("body", material, 1, 2, rings);
  body.points(column::position)[0] = body.points(column::position, 1)[0] = 0.45;
  body.points(column::volume)[0] = body.points(column::mass)[0] = 0.001;
  for (std::size_t k = 0; k < strain.size(); ++k) body.points(column::strain, static_cast<int>(k))[0] = strain[k];
  return body;
}

std::shared_ptr<LinearElastic> unit_solid() {
  auto law = std::make_shared<LinearElastic>();
  law->youngs_modulus = 2;  // mu = 1, lambda = 0
  law->density = 1;
  return law;
}

// With lambda = 0 and mu = 1 the stress is twice the strain.
TEST(Frames, StressOfASolidIsTheDifferenceOfThePrincipalStresses) {
  const Frame pulled = look(one_point(unit_solid(), {0.03, 0.01, 0}));
  EXPECT_NEAR(pulled.stress[0], 0.04, 1e-7);
  EXPECT_NEAR(pulled.pressure[0], -0.04, 1e-7);
  const Frame sheared = look(one_point(unit_solid(), {0, 0, 0.02}));  // engineering shear: stress 0.02
  EXPECT_NEAR(sheared.stress[0], 0.04, 1e-7);
  EXPECT_NEAR(sheared.pressure[0], 0, 1e-7);
  const Frame hooped = look(one_point(unit_solid(), {0.01, 0.01, 0.05, 0}, true), true);
  EXPECT_NEAR(hooped.stress[0], 0.08, 1e-7) << "the hoop counts";
  EXPECT_NEAR(hooped.pressure[0], -0.14 / 3, 1e-7);
}

// Three points on a line at 30 degrees: E = 5, eps = 0.02.
TEST(Frames, StressOfAMembraneIsThatAlongIt) {
  auto law = std::make_shared<UniaxialMembrane>();
  law->youngs_modulus = 5;
  law->density = 1;
  law->closed = false;
  Body body = make_body("bag", law, 3, 2);
  for (int p = 0; p < 3; ++p) {
    body.points(column::position)[p] = 0.3 + 0.05 * p * std::sqrt(3) / 2;
    body.points(column::position, 1)[p] = 0.3 + 0.05 * p / 2;
    body.points(column::volume)[p] = body.points(column::mass)[p] = 0.001;
    body.points(column::strain)[p] = 0.02;
  }
  const Frame frame = look(std::move(body));
  for (const float stress : frame.stress) EXPECT_NEAR(stress, 0.1, 1e-7);
}

// A sphere stretched by l as a whole: S = E / (1 - nu) (l^2 - 1) / 2 along all directions of it, S l^2 / l^2 per thickness.
TEST(Frames, StressOfAMembraneInSpaceIsTheLargerPrincipalOne) {
  const FrameSet set = run(find_case("breathing-sphere"), {2, 0},
                           {{"cells", 4.0}, {"stretch", 1.1}, {"amplitude", 0.05}, {"poissons_ratio", 0.25}})
                           .frames;
  EXPECT_EQ(set.bodies[0].kind, "membrane");
  const Frame& first = set.frames[0];
  EXPECT_GT(first.stress.size(), 100U);
  for (const float stress : first.stress) EXPECT_NEAR(stress, (1.15 * 1.15 - 1) / 1.5, 1e-5);
  for (const float pressure : first.pressure) EXPECT_TRUE(std::isnan(pressure));
}

// --- thinning -------------------------------------------------------------------------------------------------------

TEST(Frames, LargerRunsAreThinnedEvenlyByNumber) {
  const Case& entry = find_case("gas-expansion");
  const FrameSet all = run(entry, {2, 0}, {{"cells", 40.0}}).frames;
  const long wanted = static_cast<long>(all.frames[0].id.size() + 3) / 4;
  const FrameSet set = run(entry, {2, wanted}, {{"cells", 40.0}}).frames;
  EXPECT_EQ(set.every, 4);
  const double most = static_cast<double>(wanted);
  for (const Frame& frame : set.frames) {
    EXPECT_NEAR(static_cast<double>(frame.id.size()), most, 0.1 * most);
    EXPECT_TRUE(std::is_sorted(frame.id.begin(), frame.id.end())) << "by number";
  }
  // A tenth of the numbers has a tenth of the points, but for one or two at either end.
  const int numbers = all.frames[0].id.back();
  for (int part = 0; part < 10; ++part) {
    const auto inside = std::count_if(set.frames[0].id.begin(), set.frames[0].id.end(), [&](int id) {
      return id >= part * numbers / 10 && id < (part + 1) * numbers / 10;
    });
    EXPECT_NEAR(static_cast<double>(inside), most / 10, 3);
  }
}

TEST(Frames, ChainsStayWhole) {
  const FrameSet set = run(find_case("ball-net"), {2, 200}, {{"cells", 10.0}}).frames;
  ASSERT_EQ(set.bodies[1].name, "net");
  const FrameSet all = run(find_case("ball-net"), {2, 0}, {{"cells", 10.0}}).frames;
  EXPECT_EQ(set.frames[0].points[1], all.frames[0].points[1]);
}

// --- studies ----------------------------------------------------------------------------------------------------------

TEST(Frames, AStudyAsksForThemAtItsLastLevelOrTheOneNamed) {
  const Case& entry = find_case("sod");
  StudyPlan plan{.id = "s", .title = "t", .why = "w"};
  plan.values = {4, 8, 16};
  plan.full_values = {4, 8, 16, 32};
  plan.frames = 5;
  const auto counts = [&](Tier tier) {
    std::vector<int> all;
    for (const PlannedRun& planned : planned_runs(entry, plan, tier)) all.push_back(planned.frames.count);
    return all;
  };
  EXPECT_EQ(counts(Tier::quick), (std::vector<int>{0, 0, 5}));
  EXPECT_EQ(counts(Tier::full), (std::vector<int>{0, 0, 0, 5}));
  plan.frames_at = 8;
  EXPECT_EQ(counts(Tier::quick), (std::vector<int>{0, 5, 0}));
  plan.offsets_in_full = true;
  const std::vector<int> full = counts(Tier::full);
  EXPECT_EQ(full.size(), 16u);
  EXPECT_EQ(std::accumulate(full.begin(), full.end(), 0), 5) << "no offset has any";
}

TEST(Frames, StudiesOfCasesAskForASensibleNumber) {
  for (const Case* entry : cases()) {
    for (const StudyPlan& plan : entry->studies) {
      EXPECT_TRUE(plan.frames == 0 || (plan.frames >= 2 && plan.frames <= 100)) << entry->name << " " << plan.id;
      const auto& values = plan.values;
      if (!plan.frames_at) continue;
      EXPECT_TRUE(std::find(values.begin(), values.end(), *plan.frames_at) != values.end())
          << entry->name << " " << plan.id << ": no level of that value";
    }
  }
}

}  // namespace
}  // namespace plumbline::frames_test
