// Gates on recorded values: which gates need one, its range, and its verdict.
#include "cases/harness/judge/regressions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/files/errors.hpp"
#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::regressions_test {
namespace {

using ::testing::HasSubstr;

std::optional<Range> range_beside(Range expected, double measured) {
  return recorded_range(expected, Origin::requirement, false, measured);
}

TEST(RecordedRange, StandsBesideBoundsThatLetPassThreeTimesTheValue) {
  EXPECT_FALSE(range_beside({{}, 0.3}, 0.1));
  const auto range = range_beside({{}, 0.31}, 0.1);
  ASSERT_TRUE(range);
  EXPECT_DOUBLE_EQ(*range->low, 0.1 / 3);
  EXPECT_DOUBLE_EQ(*range->high, 0.3);
  EXPECT_FALSE(range_beside({0.4, {}}, 1.0));
  EXPECT_TRUE(range_beside({0.3, {}}, 1.0));
  EXPECT_FALSE(range_beside({0.9, 1.1}, 1.0));
  EXPECT_FALSE(range_beside({{}, 1.0}, std::nan("")));
}

TEST(RecordedRange, NegativeValuesAndRangesAboutZero) {
  EXPECT_FALSE(range_beside({-2, -0.5}, -1));
  const auto range = range_beside({-10, -0.1}, -1);
  ASSERT_TRUE(range);
  EXPECT_DOUBLE_EQ(*range->low, -3);
  EXPECT_DOUBLE_EQ(*range->high, -1.0 / 3);
  EXPECT_TRUE(range_beside({-0.1, 0.1}, 0.05)) << "it may lose its sign";
  EXPECT_FALSE(range_beside({0, 0}, 0));
}

// A round-off identity may get better without a word; worse than thirty times, and above the least, it may not.
TEST(RecordedRange, RoundingHasAnUpperEndAlone) {
  const auto range = recorded_range({{}, 1e-12}, Origin::identity, false, 2e-15);
  ASSERT_TRUE(range);
  EXPECT_EQ(*range->low, 0);
  EXPECT_DOUBLE_EQ(*range->high, 6e-14);
  EXPECT_DOUBLE_EQ(*range_beside({{}, 1e-12}, 1e-17)->high, 64 * 0x1p-52);
  EXPECT_DOUBLE_EQ(*range_beside({{}, 0.5}, 0)->high, 64 * 0x1p-52);
  EXPECT_DOUBLE_EQ(*range_beside({-0.5, 0.5}, 1e-17)->low, -64 * 0x1p-52);
  EXPECT_FALSE(recorded_range({{}, 1e-12}, Origin::identity, false, 5e-14)) << "30 times it is beyond the bound itself";
}

TEST(RecordedRange, OrdersDiffer) {
  EXPECT_FALSE(recorded_range({0.9, {}}, Origin::theory, true, 1.2));
  const auto range = recorded_range({0.9, {}}, Origin::theory, true, 2.0);
  ASSERT_TRUE(range);
  EXPECT_DOUBLE_EQ(*range->low, 1.7);
  EXPECT_DOUBLE_EQ(*range->high, 2.3);
}

JudgedGate judged(double value) {
  JudgedGate gate;
  gate.gate = toy_gate("s/error", {{}, 1});
  gate.case_name = "toy";
  gate.study = "s";
  gate.measured.value = value;
  gate.measured.scale = 1;
  gate.measured.reference_bound = 1e-3;  // enough for the gate, not for the recorded range
  return gate;
}

RecordedValue recorded(double value) {
  return {"toy", "s", "s/error", "quick", value, range_beside({{}, 1}, value), "2026-11-23 5825b24", {}};
}

TEST(JudgeRegression, ATenfoldLossIsRedAndSoIsATenfoldGain) {
  const auto verdict = [](double value) { return judge_regression(judged(value), recorded(1e-3)).judgement.verdict; };
  EXPECT_EQ(verdict(1e-3), Verdict::pass);
  EXPECT_EQ(verdict(2.9e-3), Verdict::pass);
  EXPECT_EQ(verdict(1e-2), Verdict::fail);
  EXPECT_EQ(verdict(1e-4), Verdict::fail);
  const JudgedGate gate = judge_regression(judged(1e-2), recorded(1e-3));
  EXPECT_EQ(gate.gate.id, "s/error/regression");
  EXPECT_EQ(gate.gate.origin, Origin::regression);
  EXPECT_THAT(gate.gate.reason, HasSubstr("--record"));
  EXPECT_TRUE(of_record(gate));
  EXPECT_FALSE(of_record(judged(1)));
}

TEST(JudgeRegression, WhatIsInvalidOrStoppedStaysSo) {
  JudgedGate gate = judged(1e-3);
  gate.measured.invalid = true;
  EXPECT_EQ(judge_regression(gate, recorded(1e-3)).judgement.verdict, Verdict::invalid);
  gate.measured.invalid = false;
  gate.measured.stopped = Measured::Stop{3, "density"};
  EXPECT_EQ(judge_regression(gate, recorded(1e-3)).judgement.verdict, Verdict::fail);
}

constexpr const char* line =
    R"({"case":"toy","study":"s","id":"s/error","tier":"quick","measured":0.1,"low":0.03,"high":0.3,"since":"2026-11-23 5825b24"})";

std::string file_of(const std::string& lines) { return "{\"format\": 1, \"recorded\": [" + lines + "]}"; }

TEST(ParseRegressions, ReadsWhatIsRecorded) {
  const auto values = parse_regressions(file_of(line), "r.json");
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(*values[0].within->high, 0.3);
  const Regressions all(values);
  EXPECT_EQ(all.of_case("toy", "quick").size(), 1u);
  EXPECT_TRUE(all.of_case("toy", "full").empty());
  EXPECT_NE(all.find({"toy", "s", "s/error", "quick"}), nullptr);
  EXPECT_EQ(all.find({"toy", "s", "s/error", "full"}), nullptr);
}

TEST(ParseRegressions, RefusesWhatIsNone) {
  EXPECT_THROW(parse_regressions("{", "r.json"), FileError);
  EXPECT_THROW(parse_regressions("{\"format\": 2, \"recorded\": []}", "r.json"), FileError);
  EXPECT_THROW(parse_regressions(file_of(std::string(line) + "," + line), "r.json"), FileError);
  std::string moved = line;
  moved.back() = ',';
  EXPECT_THROW(parse_regressions(file_of(moved + R"("moved":{"from":1,"date":"2026-11-23","why":""}})"), "r.json"),
               FileError);
}

}  // namespace
}  // namespace plumbline::regressions_test
