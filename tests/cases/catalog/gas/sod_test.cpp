// Sod's problem as published, and York's step and points for it.
#include <gtest/gtest.h>

#include <algorithm>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/judge/study.hpp"

namespace plumbline::sod_test {
namespace {

const Case& sod() { return find_case("sod"); }

// Sod 1978; the end time is York's. [York 4.1]
TEST(Sod, HasThePublishedStates) {
  const Settings s = sod().settings("default", {});
  EXPECT_EQ(s.number("left.density"), 1);
  EXPECT_EQ(s.number("left.velocity"), 0);
  EXPECT_EQ(s.number("left.pressure"), 1);
  EXPECT_EQ(s.number("right.density"), 0.125);
  EXPECT_EQ(s.number("right.velocity"), 0);
  EXPECT_EQ(s.number("right.pressure"), 0.1);
  EXPECT_EQ(s.number("gamma"), 1.4);
  EXPECT_EQ(s.number("diaphragm"), 0.5);
  EXPECT_EQ(s.number("t_end"), 0.143);
  EXPECT_EQ(s.number("cells"), 100);
}

// His fixed step of 1e-4 s at 100 cells, in proportion to h; three points per cell on a line.
TEST(Sod, YorksStepAndPoints) {
  const Settings york = sod().settings("york1997", {});
  EXPECT_DOUBLE_EQ(york.number("dt"), 1e-4);
  EXPECT_EQ(york.number("ppc"), 3);
  EXPECT_DOUBLE_EQ(sod().settings("york1997", {{"cells", 400.0}}).number("dt"), 2.5e-5);
  EXPECT_EQ(sod().problem(york)->scene().bodies[0].points.points(), 300);
}

TEST(Sod, AStepThatIsGivenIsKept) {
  EXPECT_EQ(sod().settings("york1997", {}, {"dt=3e-5"}).number("dt"), 3e-5);
  const Settings by_cfl = sod().settings("york1997", {}, {"cfl=0.2"});
  EXPECT_FALSE(by_cfl.is_set("dt"));
  EXPECT_FALSE(sod().settings("default", {}).is_set("dt"));
}

TEST(Sod, StatesOutOfRangeAreRefused) {
  for (const char* typed :
       {"gamma=1", "left.density=0", "right.pressure=0", "left.pressure=-1", "t_end=0", "diaphragm=0", "diaphragm=1"}) {
    EXPECT_THROW(sod().settings("default", {}, {typed}), UsageError) << typed;
  }
}

// The diaphragm's place within its cell, the step alone, points per cell and the mesh are each refined somewhere.
TEST(Sod, EveryRefinementHasAStudy) {
  std::vector<Vary> varied;
  for (const StudyPlan& plan : sod().studies) varied.push_back(plan.vary);
  for (const Vary vary : {Vary::cells, Vary::dt, Vary::ppc, Vary::offset}) {
    EXPECT_NE(std::find(varied.begin(), varied.end(), vary), varied.end()) << name(vary);
  }
}

TEST(Sod, OffsetsOfTheStudyShiftTheGridAlone) {
  for (const StudyPlan& plan : sod().studies) {
    if (plan.vary != Vary::offset) continue;
    for (const PlannedRun& run : planned_runs(sod(), plan, Tier::quick)) {
      const Scene scene = sod().problem(run.settings)->scene();
      EXPECT_DOUBLE_EQ(scene.grid.origin[0], -run.value * scene.grid.h);
      EXPECT_EQ(run.settings.number("diaphragm"), 0.5);
    }
  }
}

}  // namespace
}  // namespace plumbline::sod_test
