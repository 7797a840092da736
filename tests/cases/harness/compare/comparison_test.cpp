// What is said of two snapshots that differ in one thing.
#include "cases/harness/compare/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cases/harness/compare/parts.hpp"
#include "tests/cases/harness/compare/synthetic.hpp"

namespace plumbline::comparison_test {
namespace {

using ::testing::HasSubstr;

Comparison against(const Synthetic& after, const Synthetic& before = {}) {
  return compare(before.snapshot(), after.snapshot());
}

int status(const Comparison& comparison, const std::set<Change>& allowed = {}) {
  return exit_status(comparison, {}, {}, allowed);
}

// The findings of a kind that are not the same.
std::vector<Finding> changed(const Comparison& comparison, const std::string& kind) {
  std::vector<Finding> found;
  for (const Finding& f : comparison.findings) {
    if (f.kind == kind && f.change != Change::same) found.push_back(f);
  }
  return found;
}

std::string text(const Comparison& comparison) {
  std::string all;
  for (const std::string& line : table(comparison, {}, {}, 25)) all += line + "\n";
  return all;
}

TEST(Compare, IdenticalSaysThatNothingChanged) {
  const Comparison comparison = against({});
  EXPECT_TRUE(comparison.nothing_changed());
  EXPECT_EQ(comparison.count(Change::same), comparison.findings.size());
  EXPECT_GE(comparison.findings.size(), 7u) << "two verdicts, order, constant, error, two limits, cost";
  EXPECT_EQ(status(comparison), 0);
  EXPECT_THAT(text(comparison), HasSubstr("nothing changed"));
}

TEST(Compare, RoundingIsNoChange) {
  Synthetic after;
  after.study.constant *= 1 + 1e-11;
  EXPECT_TRUE(against(after).nothing_changed());
}

TEST(Compare, ASmallMoveIsSaidButIsNotWorse) {
  Synthetic after;
  after.study.constant *= 1.004;
  const Comparison comparison = against(after);
  EXPECT_FALSE(comparison.nothing_changed());
  EXPECT_EQ(status(comparison), 0);
  EXPECT_NEAR(comparison.largest_move(), 0.004, 1e-6);
  EXPECT_THAT(text(comparison), HasSubstr("moved"));
}

TEST(Compare, ALostOrderIsWorse) {
  Synthetic after;
  after.study.order = 1;
  const Comparison comparison = against(after);
  const auto orders = changed(comparison, "order");
  ASSERT_EQ(orders.size(), 1u);
  EXPECT_EQ(orders[0].change, Change::worse);
  EXPECT_NEAR(*orders[0].size, -1, 1e-9);
  EXPECT_EQ(changed(comparison, "error").at(0).change, Change::worse);
  EXPECT_TRUE(changed(comparison, "constant").empty()) << "constants of different orders are different units";
  EXPECT_EQ(status(comparison), 1);
  EXPECT_THAT(text(comparison), HasSubstr("toy / default / cells: density.L1  2 -> 1, -1"));
}

TEST(Compare, AGainedOrderIsBetter) {
  Synthetic before;
  before.study.order = 1.5;
  const Comparison comparison = against({}, before);
  EXPECT_EQ(changed(comparison, "order").at(0).change, Change::better);
  EXPECT_EQ(status(comparison), 0);
}

// What is off the power law in both studies cancels: intervals of both orders are +- 0.1, yet 0.08 is seen.
TEST(Compare, OrdersAreComparedLevelByLevel) {
  Synthetic before, after;
  before.study.noise = after.study.noise = {1.2, 0.8, 1.1, 0.9, 1.3, 0.7};
  after.study.order = 1.92;
  EXPECT_EQ(changed(against(after, before), "order").at(0).change, Change::worse);
}

TEST(Compare, ADifferenceThatScattersIsInconclusive) {
  Synthetic after;
  after.study.noise = {1, 1, 1, 1, 1, 1.5};  // one level alone is off
  const auto orders = changed(against(after), "order");
  ASSERT_EQ(orders.size(), 1u);
  EXPECT_EQ(orders[0].change, Change::inconclusive);
  ASSERT_TRUE(orders[0].interval);
  EXPECT_LT(orders[0].interval->first, 0);
  EXPECT_GT(orders[0].interval->second, 0);
  EXPECT_EQ(changed(against(after), "error").at(0).change, Change::worse) << "its error is not in doubt";
}

TEST(Compare, OtherLevelsAreComparedByWelchsTest) {
  Synthetic after;
  after.study.cells = {283, 400, 566, 800, 1131, 1600};
  const auto same = against(after);
  EXPECT_TRUE(changed(same, "order").empty());
  after.study.order = 1.8;
  const auto orders = changed(against(after), "order");
  ASSERT_EQ(orders.size(), 1u);
  EXPECT_EQ(orders[0].change, Change::worse);
  // Both intervals +- 0.1 with four degrees of freedom: +- t(8) sqrt(2) 0.1/t(4).
  EXPECT_NEAR(orders[0].interval->second - *orders[0].size, 2.306 * std::sqrt(2) * 0.1 / 2.7764, 1e-4);
  after.study.order = 1.9;
  EXPECT_EQ(changed(against(after), "order").at(0).change, Change::inconclusive);
}

// [Welch] Of six and of four levels, each +- t standard errors: s = 0.1/t(4) and 0.1/t(2) with (s1^2 + s2^2)^2/(s1^4/4 + s2^4/2)
// degrees of freedom. t(0.975) of 4, 2 and 5.9585 by scipy.stats.t.ppf.
TEST(Compare, WelchsTestCountsTheLevelsOfEachStudy) {
  Synthetic after;
  after.study.cells = {283, 566, 1131, 2262};
  after.study.order = 1.5;
  const double a = 0.1 / 2.7764451051977987, b = 0.1 / 4.302652729911275;
  const double variance = a * a + b * b, degrees = variance * variance / (a * a * a * a / 4 + b * b * b * b / 2);
  EXPECT_NEAR(degrees, 5.958480, 1e-4);
  const auto orders = changed(against(after), "order");
  ASSERT_EQ(orders.size(), 1u);
  EXPECT_NEAR(orders[0].interval->second - *orders[0].size, 2.451050941 * std::sqrt(variance), 1e-6);
  const auto back = changed(against({}, after), "order");
  EXPECT_NEAR(back.at(0).interval->second - *back[0].size, 2.451050941 * std::sqrt(variance), 1e-6);
}

// Two studies of one key on one side, one on the other: those with most levels are a pair, and the other one is lone.
TEST(Compare, TheStudyWithoutACounterpartIsNamed) {
  for (const bool is_first : {true, false}) {
    Synthetic longer, shorter, other;
    longer.study.cells = {50, 70, 110, 150, 220};
    shorter.study.cells = {60, 90, 130};
    other.study.cells = {50, 70, 110, 150};
    Snapshot one = other.snapshot(), two;
    take_study((is_first ? longer : shorter).study.document(), "study-toy.h5", two);
    take_study((is_first ? shorter : longer).study.document(), "study-toy.h5", two);
    auto& pair = two.studies.begin()->second;
    ASSERT_EQ(pair.size(), 2u);
    for (StudyRecord& study : pair) study.id = study.levels.size() == 3 ? "shorter" : "longer";
    const auto missing = changed(compare(two, one), "study"), added = changed(compare(one, two), "study");
    ASSERT_EQ(missing.size(), 1u);
    ASSERT_EQ(added.size(), 1u);
    EXPECT_EQ(missing[0].study, "shorter");
    EXPECT_EQ(missing[0].change, Change::missing);
    EXPECT_EQ(added[0].study, "shorter");
    EXPECT_EQ(added[0].change, Change::added);
  }
}

TEST(Compare, AWorseConstantAtTheSameOrderIsWorse) {
  Synthetic after;
  after.study.constant = 1.05;
  const auto constants = changed(against(after), "constant");
  ASSERT_EQ(constants.size(), 1u);
  EXPECT_EQ(constants[0].change, Change::worse);
  EXPECT_NEAR(*constants[0].size, 0.05, 1e-9);
  after.study.constant = 0.95;
  EXPECT_EQ(changed(against(after), "constant").at(0).change, Change::better);
}

TEST(Compare, ErrorsAtRoundingAreTheSame) {
  Synthetic before, after;
  before.study.constant = 1e-12;
  after.study.constant = 1.5e-12;  // of relative errors of 1: the reference's size is the error's here
  Snapshot a = before.snapshot(), b = after.snapshot();
  for (Snapshot* s : {&a, &b}) {
    for (LevelRecord& level : s->studies.begin()->second.front().levels) level.errors.at("density.L1").scale = 1;
  }
  EXPECT_TRUE(changed(compare(a, b), "error").empty());
}

TEST(Compare, ErrorsWithinTheReferencesBoundAreTheSame) {
  Synthetic after;
  after.study.constant = 1.05;
  Snapshot a = Synthetic{}.snapshot(), b = after.snapshot();
  EXPECT_FALSE(changed(compare(a, b), "error").empty());
  for (Snapshot* s : {&a, &b}) {
    for (LevelRecord& level : s->studies.begin()->second.front().levels)
      level.errors.at("density.L1").reference_bound = 0.03 * level.errors.at("density.L1").error;
  }
  EXPECT_TRUE(changed(compare(a, b), "error").empty());
}

TEST(Compare, ARunThatStopsIsWorse) {
  Synthetic after;
  after.study.stops = true;
  const Comparison comparison = against(after);
  const auto runs = changed(comparison, "run");
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_EQ(runs[0].change, Change::worse);
  EXPECT_THAT(runs[0].note, HasSubstr("stopped at step 7"));
  EXPECT_EQ(changed(comparison, "error").at(0).change, Change::worse);
}

TEST(Compare, OtherSettingsAreNamed) {
  Snapshot before = Synthetic{}.snapshot(), after = before;
  after.studies.begin()->second.front().settings["transfer"] = "\"flip\"";
  EXPECT_TRUE(compare(before, after).nothing_changed()) << "another choice with the same numbers";
  Synthetic worse;
  worse.study.order = 1;
  after = worse.snapshot();
  after.studies.begin()->second.front().settings["transfer"] = "\"flip\"";
  EXPECT_THAT(changed(compare(before, after), "order").at(0).note, HasSubstr("transfer \"apic\" -> \"flip\""));
}

TEST(Compare, AGateThatTurnsRedIsWorse) {
  Synthetic after;
  after.gates[0]["verdict"] = "FAIL";
  const auto verdicts = changed(against(after), "verdict");
  ASSERT_EQ(verdicts.size(), 1u);
  EXPECT_EQ(verdicts[0].change, Change::worse);
  EXPECT_EQ(changed(against({}, after), "verdict").at(0).change, Change::better);
}

TEST(Compare, VerdictsByTheirSeverity) {
  const std::vector<std::string> order{"PASS", "XFAIL", "NONE", "INCONCLUSIVE", "XPASS", "FAIL", "INVALID"};
  for (std::size_t k = 1; k < order.size(); ++k) {
    Synthetic before, after;
    before.gates[0]["verdict"] = order[k - 1];
    after.gates[0]["verdict"] = order[k];
    EXPECT_EQ(changed(against(after, before), "verdict").at(0).change, Change::worse) << order[k];
  }
}

TEST(Compare, AWidenedGateIsRedEvenIfItPasses) {
  Synthetic after;
  after.gates[0] = synthetic_gate("cells/density", "PASS", 0.008);
  const Comparison comparison = against(after);
  const auto bounds = changed(comparison, "bound");
  ASSERT_EQ(bounds.size(), 1u);
  EXPECT_EQ(bounds[0].change, Change::widened);
  EXPECT_THAT(bounds[0].note, HasSubstr("at most 0.007 became at most 0.008"));
  EXPECT_EQ(status(comparison), 1);
  EXPECT_EQ(status(comparison, {Change::widened}), 0);
  EXPECT_EQ(changed(against({}, after), "bound").at(0).change, Change::better) << "narrowed";
}

TEST(LookUpWidenings, ARecordedReasonIsNotRed) {
  Synthetic after;
  after.gates[0] = synthetic_gate("cells/density", "PASS", 0.008);
  const Snapshot a = Synthetic{}.snapshot(), b = after.snapshot();
  LedgerLine line;
  line.case_name = "toy";
  line.study = "cells";
  line.id = "cells/density";
  line.bounds.expected.high = 0.008;
  line.widened = Widening{{{{}, 0.007}, {}, {}, true}, "2026-11-22", "because"};
  const auto status_with = [&](const LedgerLine& recorded) {
    Comparison comparison = compare(a, b);
    look_up_widenings({recorded}, a, b, comparison);
    EXPECT_EQ(comparison.count(Change::widened), 1u) << "it is still said";
    return status(comparison);
  };
  EXPECT_EQ(status_with(line), 0);
  LedgerLine other = line;
  other.widened->from.expected.high = 0.006;
  EXPECT_EQ(status_with(other), 1) << "it was recorded for another change";
  other = line;
  other.bounds.expected.high = 0.0079;
  EXPECT_EQ(status_with(other), 1) << "not as far as this";
  other = line;
  other.widened.reset();
  EXPECT_EQ(status_with(other), 1);
}

TEST(Compare, AnExpectedFailureWhereNoneWasIsWidened) {
  Synthetic before, after;
  before.gates[0]["verdict"] = "FAIL";
  after.gates[0]["verdict"] = "XFAIL";
  after.gates[0]["band"] = {{"low", 0.01}, {"high", 0.02}};
  const Comparison comparison = against(after, before);
  EXPECT_EQ(changed(comparison, "bound").at(0).change, Change::widened);
  EXPECT_EQ(changed(comparison, "verdict").at(0).change, Change::better);
  EXPECT_EQ(status(comparison), 1);
}

TEST(Compare, ADroppedGateIsMissing) {
  Synthetic after;
  after.gates.pop_back();
  const Comparison comparison = against(after);
  EXPECT_EQ(changed(comparison, "verdict").at(0).change, Change::missing);
  EXPECT_EQ(comparison.gates_after, 1u);
  EXPECT_EQ(status(comparison), 1);
  EXPECT_THAT(text(comparison), HasSubstr("gates were dropped"));
  EXPECT_EQ(changed(against({}, after), "verdict").at(0).change, Change::added);
  EXPECT_EQ(status(against({}, after)), 0);
}

TEST(Compare, AMissingCaseIsOneLine) {
  Snapshot nothing;
  const Comparison comparison = compare(Synthetic{}.snapshot(), nothing);
  EXPECT_EQ(comparison.count(Change::missing), comparison.findings.size());
  EXPECT_EQ(status(comparison), 1);
  EXPECT_EQ(status(comparison, {Change::missing}), 0);
  EXPECT_THAT(text(comparison), HasSubstr("(and 1 more of this case)"));
}

TEST(Compare, Limits) {
  Synthetic after;
  after.stability = synthetic_stability(1.8 * (1 - 2e-4), 1.79, 1.81);
  const auto predicted = changed(against(after), "limit");
  ASSERT_EQ(predicted.size(), 1u);
  EXPECT_EQ(predicted[0].change, Change::worse);
  after.stability = synthetic_stability(1.8 * (1 - 5e-5), 1.80, 1.82);
  EXPECT_TRUE(changed(against(after), "limit").empty()) << "brackets overlap";
  after.stability = synthetic_stability(1.8, 1.82, 1.83);
  ASSERT_EQ(changed(against(after), "limit").size(), 1u);
  EXPECT_EQ(changed(against(after), "limit")[0].change, Change::better);
  after.stability = synthetic_stability(1.8, 1.7, 1.75);
  EXPECT_EQ(changed(against(after), "limit").at(0).change, Change::worse);
}

TEST(Compare, ALimitThatIsGoneIsWorse) {
  Synthetic after;
  after.stability["configurations"][0]["predicted"] = Json::array();
  after.stability["configurations"][0]["always"] = "unstable";
  EXPECT_EQ(changed(against(after), "limit").at(0).change, Change::worse);
  after.stability["configurations"][0]["always"] = nullptr;
  EXPECT_EQ(changed(against(after), "limit").at(0).change, Change::missing);
}

TEST(Compare, AHoleInTheStableStepsIsWorse) {
  Synthetic before, after;
  before.stability["configurations"][0]["predicted"] = {{{"low", 0}, {"high", 1.0}}, {{"low", 1.2}, {"high", 2.0}}};
  after.stability["configurations"][0]["predicted"] = {{{"low", 0}, {"high", 1.0}}, {{"low", 1.5}, {"high", 2.0}}};
  EXPECT_EQ(changed(against(after, before), "limit").at(0).change, Change::worse);
}

TEST(Compare, ASlowdownIsWorse) {
  Synthetic after;
  after.costs = synthetic_costs({1.20, 1.21, 1.22, 1.19, 1.20});
  const auto costs = changed(against(after), "cost");
  ASSERT_EQ(costs.size(), 1u);
  EXPECT_EQ(costs[0].change, Change::worse);
  EXPECT_NEAR(*costs[0].size, 1.2, 0.01);
  EXPECT_EQ(changed(against({}, after), "cost").at(0).change, Change::better);
}

TEST(Compare, TimesThatScatterAreInconclusive) {
  Synthetic after;
  after.costs = synthetic_costs({0.9, 1.2, 1.5, 0.95, 1.3});
  const Comparison comparison = against(after);
  EXPECT_EQ(changed(comparison, "cost").at(0).change, Change::inconclusive);
  EXPECT_EQ(status(comparison), 1);
  EXPECT_EQ(status(comparison, {Change::inconclusive}), 0);
  Synthetic before;
  before.costs = after.costs = synthetic_costs({1.0, 1.1, 1.2});
  after.costs["runs"][0]["wall_s"][0] = 1.01;
  EXPECT_THAT(changed(against(after, before), "cost").at(0).note, HasSubstr("are needed for an interval"));
}

TEST(Compare, InstructionsDecideWhereTimesDoNot) {
  Synthetic before, after;
  before.costs = synthetic_costs({1.0, 1.5, 0.9, 1.3, 1.1}, 1e9);
  after.costs = synthetic_costs({1.1, 1.4, 0.8, 1.3, 1.2}, 1.001e9);
  EXPECT_TRUE(changed(against(after, before), "cost").empty());
  after.costs["runs"][0]["instructions"] = 1.2e9;
  const auto costs = changed(against(after, before), "cost");
  ASSERT_EQ(costs.size(), 1u);
  EXPECT_EQ(costs[0].change, Change::worse);
  EXPECT_EQ(costs[0].quantity, "instructions") << "what decides leads";
  EXPECT_NEAR(*costs[0].size, 1.2, 1e-12);
  EXPECT_THAT(words(costs[0]), HasSubstr("1e+09 -> 1.2e+09, x 1.200; wall time in s 1.1 -> 1.2, x 1.0"));
  after.costs = synthetic_costs({2.0, 2.1, 2.2, 2.0, 2.1}, 1.2e9);
  EXPECT_THAT(words(changed(against(after, before), "cost").at(0)), HasSubstr("5 and 5 samples; instructions x 1.200"))
      << "a time that says so itself leads";
}

TEST(Compare, CostsOfLevelsAreAddedUp) {
  Synthetic before, after;
  for (Synthetic* s : {&before, &after}) {
    Json second = s->costs["runs"][0], once = second;
    second["value"] = 200;
    once["value"] = 400;
    once["wall_s"] = {100};
    s->costs["runs"].push_back(second);
    s->costs["runs"].push_back(once);
  }
  after.costs["runs"][1]["wall_s"] = {1.40, 1.41, 1.42, 1.39, 1.40};
  const auto costs = changed(against(after, before), "cost");
  ASSERT_EQ(costs.size(), 1u);
  EXPECT_EQ(costs[0].change, Change::worse);
  EXPECT_NEAR(*costs[0].size, 1.2, 0.01) << "of one level as before and one of 1.4, without what was timed once";
}

TEST(Compare, TimesOfStoredRunsAreNotCompared) {
  Synthetic before, after;
  after.costs["runs"][0]["source"] = before.costs["runs"][0]["source"] = "stored";
  EXPECT_TRUE(before.snapshot().costs.empty());
}

TEST(Compare, ATimeThatIsSurelyWorseStaysSo) {
  Synthetic before, after;
  before.costs["runs"][0]["instructions"] = 1e9;
  after.costs = synthetic_costs({2.0, 2.1, 2.2, 2.0, 2.1}, 1e9);
  EXPECT_EQ(changed(against(after, before), "cost").at(0).change, Change::worse) << "memory counts no instructions";
}

TEST(Compare, CostsOfAnotherMachineAreNotCompared) {
  Synthetic after;
  after.costs = synthetic_costs({9, 9, 9, 9, 9}, nullptr, "another");
  const Comparison comparison = against(after);
  EXPECT_TRUE(changed(comparison, "cost").empty());
  const auto machine = changed(comparison, "machine");
  ASSERT_EQ(machine.size(), 1u);
  EXPECT_EQ(machine[0].change, Change::inconclusive);
}

TEST(Compare, TheMostSeriousStandsFirst) {
  Synthetic after;
  after.study.order = 1;
  after.gates[0] = synthetic_gate("cells/density", "PASS", 0.008);
  after.gates.pop_back();
  const Comparison comparison = against(after);
  EXPECT_EQ(overall(comparison), Change::worse);
  EXPECT_LT(text(comparison).find("density.L1  2 -> 1"), text(comparison).find("  error "))
      << "a lost order, then the errors it leaves";
  for (std::size_t k = 1; k < comparison.findings.size(); ++k)
    EXPECT_LE(comparison.findings[k - 1].change, comparison.findings[k].change);
}

TEST(ExitStatus, OfDamagedFilesIsTheirs) {
  Snapshot damaged;
  damaged.damaged.emplace_back("study-toy.h5", "truncated");
  EXPECT_EQ(exit_status(against({}), damaged, {}, {}), 4);
  EXPECT_EQ(exit_status(against({}), {}, damaged, {}), 4);
}

TEST(Document, HoldsEveryFinding) {
  Synthetic after;
  after.study.order = 1;
  const Comparison comparison = against(after);
  const Json json = document(comparison, Synthetic{}.snapshot(), after.snapshot());
  EXPECT_EQ(json.at("findings").size(), comparison.findings.size());
  EXPECT_EQ(json.at("change"), "worse");
  EXPECT_EQ(json.at("counts").at("worse"), comparison.count(Change::worse));
  EXPECT_EQ(json.at("baseline").at("version"), "1.0.0");
  EXPECT_FALSE(json.at("nothing_changed").get<bool>());
}

}  // namespace
}  // namespace plumbline::comparison_test
