// Every case goes on from its checkpoint to the same bits, and the gate that says so sees it when one does not.
#include "cases/harness/verify/restart_gate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "tests/cases/harness/scene_cases.hpp"
#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::restart_gate_test {
namespace {

// --- all cases ----------------------------------------------------------------------------------------------------------

// A problem as it is, but for an earlier end; or one that does not name what it has seen.
class EndsEarly final : public Problem {
 public:
  EndsEarly(std::unique_ptr<Problem> whole, double end, bool forgetful)
      : whole_(std::move(whole)),
        end_(end),
        forgetful_(forgetful) {}
  Scene scene() const override { return whole_->scene(); }
  double end_time() const override { return end_; }
  void observe(const Simulation& simulation) override { whole_->observe(simulation); }
  void history(Archive& archive) override {
    if (!forgetful_) whole_->history(archive);
  }
  std::vector<Measure> measures(const Simulation& simulation) const override { return whole_->measures(simulation); }
  Profile profile(const Simulation& simulation) const override { return whole_->profile(simulation); }

 private:
  std::unique_ptr<Problem> whole_;
  double end_;
  bool forgetful_;
};

double first_step(const Problem& problem, const Settings& settings) {
  Simulation run(problem.scene(), settings.text("integrator"), step_control(settings));
  run.step(problem.end_time());
  return run.last_dt();
}

// For one choice of settings: the end is found once, by a first step.
Case shortened(const Case& whole, long steps, bool forgetful = false) {
  Case made = whole;
  const auto step = std::make_shared<std::optional<double>>();
  made.problem = [=, of_whole = whole.problem](const Settings& settings) -> std::unique_ptr<Problem> {
    auto problem = of_whole(settings);
    if (!*step) *step = first_step(*problem, settings);
    const double end = std::min(problem->end_time(), static_cast<double>(steps) * **step);
    return std::make_unique<EndsEarly>(std::move(problem), end, forgetful);
  };
  return made;
}

// Of each case: three runs of them and three taken up again. A number that is lost shows in the step that follows.
constexpr long few_steps = 16;

// What is averaged over the last part of a run begins with an end of its own.
Settings settings_for(const Case& entry) {
  const double coarsest = entry.levels.front();
  Settings settings = entry.settings("default", {{"cells", coarsest}});
  if (!settings.has("t_end")) return settings;
  const auto problem = entry.problem(settings);
  Simulation run(problem->scene(), settings.text("integrator"), step_control(settings));
  run.step(problem->end_time());
  const double end = run.last_dt() * static_cast<double>(few_steps);
  if (end < problem->end_time()) settings.set("t_end", end, entry.name);
  return settings;
}

class EachCase : public testing::TestWithParam<const Case*> {};

TEST_P(EachCase, GoesOnToTheSameBits) {
  const Case entry = shortened(*GetParam(), few_steps);
  const Settings settings = settings_for(*GetParam());
  for (const double share : {0.0, 0.5, 1.0}) {
    const RestartDifference difference = restart_difference(entry, "default", settings, share);
    EXPECT_EQ(difference.numbers, 0) << "from " << share << " of the end time on: " << difference.first;
    EXPECT_GT(difference.compared, 20);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EachCase, testing::ValuesIn(scene_cases()), [](const auto& about) {
  std::string name = about.param->name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

// --- the gate -----------------------------------------------------------------------------------------------------------

JudgedGate judged(const Case& entry, const CaseGate& gate, std::int64_t steps) {
  StudyResult study;
  study.entry = &entry;
  study.plan = {.id = "default", .title = {}, .why = {}};
  study.levels.push_back({10, 0, RunResult(entry.name, "default", settings_for(entry)), {}});
  study.levels.front().run.steps = steps;
  return judge_gates({gate}, study).at(0);
}

TEST(RestartGate, ComparesEveryNumberOfARun) {
  const Case entry = shortened(find_case("string-vibration"), 40);
  const JudgedGate gate = judged(entry, restart_gate("default", "runs of a membrane"), 40);
  EXPECT_EQ(gate.gate.id, "default/restart");
  EXPECT_EQ(gate.judgement.verdict, Verdict::pass) << gate.measured.note;
  EXPECT_EQ(gate.measured.value, 0);
}

TEST(RestartGate, IsRedWhereAProblemDoesNotNameWhatItHasSeen) {
  for (const char* name : {"two-bar", "mms-bar", "ring-at-rest"}) {
    const Case entry = shortened(find_case(name), 40, true);
    const JudgedGate gate = judged(entry, restart_gate("default", "runs"), 40);
    EXPECT_EQ(gate.judgement.verdict, Verdict::fail) << name;
    EXPECT_GT(gate.measured.value.value_or(0), 0) << name;
    EXPECT_NE(gate.measured.note.find("the first in "), std::string::npos) << gate.measured.note;
  }
}

TEST(RestartGate, TakesOverridesAndASuffix) {
  const Case entry = shortened(find_case("bar-vibration"), 40);
  const CaseGate gate = restart_gate("default", "runs", {{"integrator", "generalized-alpha"}, {"transfer", "flip"}},
                                     "-x");
  EXPECT_EQ(gate.gate.id, "default/restart-x");
  EXPECT_EQ(judged(entry, gate, 40).judgement.verdict, Verdict::pass);
}

// The final state of another program has no steps: nothing can be said of it.
TEST(RestartGate, SaysNothingOfAFinalState) {
  const Case entry = shortened(find_case("sod"), 40);
  EXPECT_TRUE(judged(entry, restart_gate("default", "runs"), 0).measured.invalid);
}

// A run that stopped before its checkpoint: the same words each time, whatever file it would have been written to.
TEST(RestartGate, SaysNothingOfARunThatStopped) {
  StudyResult study;
  study.entry = &find_case("sod");
  study.plan = {.id = "default", .title = {}, .why = {}};
  const Settings settings = study.entry->settings("default", {{"cells", 20.0}, {"cfl", 5.0}});
  study.levels.push_back({20, 0, RunResult("sod", "default", settings), {}});
  study.levels.front().run.steps = 1;
  const JudgedGate gate = judge_gates({restart_gate("default", "runs")}, study).at(0);
  EXPECT_EQ(gate.judgement.verdict, Verdict::invalid);
  EXPECT_EQ(gate.measured.note, "the run ended before the half of its time: there is nothing to be taken up again");
}

// Gas that expands must split points before the restart and after it, or the gate of the case says nothing of that.
TEST(RestartGate, PointsAreSplitOnTheWay) {
  const Case& entry = find_case("gas-expansion");
  const Settings settings = entry.settings("default", {{"cells", 40.0}, {"split", 0.2}});
  const auto problem = entry.problem(settings);
  Simulation run(problem->scene(), settings.text("integrator"), step_control(settings));
  const long start = run.points();
  run.run_until(problem->end_time() / 2);
  const long half_way = run.points();
  run.run_until(problem->end_time());
  EXPECT_LT(start, half_way);
  EXPECT_LT(half_way, run.points());
}

}  // namespace
}  // namespace plumbline::restart_gate_test
