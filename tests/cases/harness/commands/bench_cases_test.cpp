// Which runs are timed, and how often, within a budget.
#include "cases/harness/commands/bench_cases.hpp"

#include <gtest/gtest.h>

#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::bench_cases_test {
namespace {

const Case& toy() {
  static const Case made = toy_case({.end = 0.2});  // 200 steps of three points: about a millisecond
  return made;
}

std::vector<CostRun> runs_of(const std::vector<double>& cells) {
  std::vector<CostRun> runs;
  for (const double value : cells) {
    runs.push_back(
        {&toy(), "default", "default", "cells", Vary::cells, value, toy().settings("default", {{"cells", value}})});
  }
  return runs;
}

TEST(TimedRuns, EachRoundTakesEachRunOnce) {
  const auto samples = time_cost_runs(runs_of({4, 8}), 3, {10, 10, 10}, "none");
  ASSERT_EQ(samples.size(), 2U);
  for (const CostSample& sample : samples) {
    EXPECT_EQ(sample.wall_s.size(), 3U);
    for (const double seconds : sample.wall_s) EXPECT_GT(seconds, 0);
    EXPECT_FALSE(sample.document.is_null());
  }
}

TEST(TimedRuns, EqualChoicesAreTimedOnce) {
  const auto samples = time_cost_runs(runs_of({4, 8, 4}), 2, {10, 10, 10}, "none");
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_EQ(samples[0].wall_s, samples[2].wall_s);
  EXPECT_NE(samples[0].wall_s, samples[1].wall_s);
}

// Repeats end where all of them together would take longer than the budget of a run: after some of 1000.
TEST(TimedRuns, RepeatsEndWithTheBudgetOfARun) {
  const auto samples = time_cost_runs(runs_of({4}), 1000, {10, 0.05, 10}, "none");
  EXPECT_GE(samples[0].wall_s.size(), 1U);
  EXPECT_LT(samples[0].wall_s.size(), 500U);  // each takes more than 0.1 ms
}

TEST(TimedRuns, LongOnesAreMadeOnceOrNotAtAll) {
  EXPECT_EQ(time_cost_runs(runs_of({4}), 7, {10, 1e-9, 10}, "none")[0].wall_s.size(), 1U);
  EXPECT_TRUE(time_cost_runs(runs_of({4}), 7, {1e-9, 10, 10}, "none")[0].wall_s.empty());
  EXPECT_TRUE(time_cost_runs(runs_of({4}), 7, {10, 10, 0}, "none")[0].wall_s.empty());
}

}  // namespace
}  // namespace plumbline::bench_cases_test
