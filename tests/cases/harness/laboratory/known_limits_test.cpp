#include "cases/harness/laboratory/known_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/cases/harness/laboratory/made_up_integrators.hpp"

namespace plumbline::known_limits_test {
namespace {

std::vector<const StabilityProblem*> problems(const std::vector<std::string>& names) {
  std::vector<const StabilityProblem*> found;
  for (const std::string& name : names) found.push_back(&find_stability_problem(name));
  return found;
}

const KnownLimit& row_of(const std::vector<KnownLimit>& rows, const std::string& problem) {
  for (const KnownLimit& row : rows) {
    if (row.problem->name() == problem) return row;
  }
  throw std::out_of_range(problem);
}

// The light node behind a point at the depth d of its cell alone is stable to sqrt(2 d), to the order of d.
TEST(KnownLimits, TheSmallestStandsFirstAndNamesItsProblem) {
  const std::vector<KnownLimit> rows = limits_of({"usl", {}}, 1, problems({"bar", "bar-edge", "oscillator"}));
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0].problem->name(), "bar-edge");
  EXPECT_EQ(rows[0].words(), "linear flip, ppc 2, depth 0.01");
  EXPECT_NEAR(rows[0].limit, std::sqrt(0.02), 0.01 * std::sqrt(0.02));
  EXPECT_EQ(smallest_of(rows), &rows[0]);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_EQ(rows[k].smallest, k == 0);
    EXPECT_EQ(rows[k].unit, k < 4 ? "h/c" : "1/omega");
    if (k > 0 && k < 4) {
      EXPECT_GE(rows[k].limit, rows[k - 1].limit);
    }
    ASSERT_TRUE(rows[k].closed_form) << rows[k].words();
    EXPECT_NEAR(rows[k].limit / rows[k].closed_form->limit, 1, 1e-5) << rows[k].words();
  }
}

// Every explicit integrator of the tree whose limits on a bar are known by linear algebra.
TEST(KnownLimits, FreeEndsMeetTheirClosedForm) {
  for (const char* integrator : {"usf", "musl", "usavg"}) {
    for (const KnownLimit& row : limits_of({integrator, {}}, 1, problems({"bar", "bar-edge"}))) {
      ASSERT_TRUE(row.closed_form) << integrator << " " << row.words();
      EXPECT_NEAR(row.limit / row.closed_form->limit, 1, 1e-5) << integrator << " " << row.words();
    }
  }
}

// The list scans up to the first limit, the command over all steps.
TEST(KnownLimits, AreThoseThatTheCommandPrints) {
  for (const KnownLimit& row : limits_of({"musl", {}}, 1, problems({"bar", "contact", "plane"}))) {
    const Configuration found = examine(*row.problem, "default", *row.settings, false);
    EXPECT_NEAR(row.limit / found.predicted.limit(), 1, 1e-5) << row.words();
  }
}

TEST(KnownLimits, WithoutAStableStepThereIsGrowthAndNoLimit) {
  const std::vector<KnownLimit> rows = limits_of({made_up::forward_euler, {}}, 1, problems({"bar", "oscillator"}));
  EXPECT_EQ(smallest_of(rows), nullptr);
  for (const KnownLimit& row : rows) {
    EXPECT_TRUE(row.no_stable_step()) << row.words();
    EXPECT_TRUE(row.note.empty());
  }
  const KnownLimit& oscillator = row_of(rows, "oscillator");
  EXPECT_NEAR(oscillator.growth.per_step, std::hypot(1, oscillator.growth.dt), 1e-9);
}

TEST(KnownLimits, LimitsInOtherUnitsAreNotCompared) {
  std::vector<KnownLimit> rows(5);
  const double limits[] = {3, 0, 0.001, std::numeric_limits<double>::quiet_NaN(), 2};
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].limit = limits[k];
  rows[2].unit = "1/omega";
  put_in_order(rows);
  EXPECT_EQ(rows[0].limit, 2);
  EXPECT_TRUE(rows[0].smallest);
  EXPECT_EQ(rows[1].limit, 3);
  EXPECT_EQ(rows[4].limit, 0.001);
  EXPECT_FALSE(rows[4].smallest);
}

// Integrators that cannot work with a problem's own choices take FLIP, or do without losses given back; else a row says
// why there is nothing.
TEST(KnownLimits, ConcessionsAreMadeAndSaid) {
  const KnownLimit of_lines = rows_of({"rk4", {}}, problems({"membrane"})).front();
  ASSERT_TRUE(of_lines.settings);
  EXPECT_EQ(of_lines.settings->text("transfer"), "flip");
  EXPECT_EQ(of_lines.words().rfind("quadratic flip, ppc 2", 0), 0U) << of_lines.words();
  const KnownLimit lossless = rows_of({"musl", {}}, problems({"coupled"})).front();
  ASSERT_TRUE(lossless.settings);
  EXPECT_EQ(lossless.settings->text("membrane.loss"), "booked");
  EXPECT_EQ(rows_of({"leapfrog", {}}, problems({"coupled"})).front().settings->text("membrane.loss"), "gas");
  KnownLimit refused = rows_of({"leapfrog", {}}, problems({"bar"})).front();
  if (!refused.settings) {
    find_limit(refused);
    EXPECT_FALSE(refused.note.empty());
    EXPECT_TRUE(std::isnan(refused.limit));
  }
}

TEST(KnownLimits, DoNotDependOnThreads) {
  const auto one = limits_of({"usf", {}}, 1, problems({"bar", "bar-edge"}));
  const auto three = limits_of({"usf", {}}, 3, problems({"bar", "bar-edge"}));
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].limit, three[k].limit);
    EXPECT_EQ(one[k].words(), three[k].words());
  }
}

// A parameter changes the limit: generalized-alpha between no damping and most.
TEST(KnownLimits, OfParametersAsChosen) {
  for (const double rho : {0.2, 0.9}) {
    const auto rows = limits_of({"generalized-alpha", {{"rho_b", rho}}}, 1, problems({"oscillator"}));
    const double limit = std::sqrt(12 * (1 + rho) * (2 - rho) / (10 - 5 * rho + rho * rho));  // [Generalized-Alpha 1]
    EXPECT_NEAR(rows.front().limit, limit, 1e-5);
  }
}

// A result within 1e-4 of the list's smallest counts as that: limits of a list are not found more finely.
TEST(SmallestKnown, IsAResultItselfWithinTheListsAccuracy) {
  const StabilityProblem& edge = find_stability_problem("bar-edge");
  KnownList list{{"usl", {}}, {}, limits_of({"usl", {}}, 1, problems({"bar-edge"}))};
  Configuration result = examine(edge, "default", stability_settings(edge, "default", {{"integrator", "usl"}}), false);
  const double least = smallest_of(list.rows)->comparable() / edge.fastest(result.settings);
  for (const double factor : {0.5, 0.999, 1.0, 1.00005, 1.0002, 1.01, 3.0}) {
    result.predicted.stable = {{0, factor * least}};
    const SmallestKnown found = smallest_known(result, list);
    EXPECT_EQ(found.is_this, factor < 1.0001) << factor;
    EXPECT_NEAR(found.limit, least * edge.fastest(result.settings) * (found.is_this ? factor : 1), 1e-12) << factor;
  }
}

// What a command finds beside the list may be smaller than all of it.
TEST(SmallestKnown, IsAResultItselfWhereNoneIsSmaller) {
  const StabilityProblem &edge = find_stability_problem("bar-edge"), &bar = find_stability_problem("bar");
  const KnownList list{{"usl", {}}, {}, limits_of({"usl", {}}, 1, problems({"bar-edge"}))};
  const auto found_with = [&](const StabilityProblem& problem, const std::vector<Override>& overrides) {
    return examine(problem, "default", stability_settings(problem, "default", overrides), false);
  };
  const SmallestKnown shallower = smallest_known(found_with(edge, {{"integrator", "usl"}, {"depth", 1e-3}}), list);
  EXPECT_TRUE(shallower.is_this);
  EXPECT_NEAR(shallower.limit, std::sqrt(2e-3), 1e-3 * std::sqrt(2e-3));
  EXPECT_NE(shallower.words.find("depth 0.001"), std::string::npos) << shallower.words;
  const Configuration inside = found_with(bar, {{"integrator", "usl"}});
  const SmallestKnown smaller = smallest_known(inside, list);
  EXPECT_FALSE(smaller.is_this);
  EXPECT_EQ(smaller.problem, "bar-edge");
  EXPECT_EQ(limit_in_words(inside), "0.7071 h/c");
  EXPECT_TRUE(smallest_known(found_with(edge, {{"integrator", "usl"}, {"depth", 0.01}}), list).is_this);
  const StabilityProblem& oscillator = find_stability_problem("oscillator");
  EXPECT_FALSE(smallest_known(found_with(oscillator, {{"integrator", "usl"}}), {{"usl", {}}, {}, {}}).is_this);
}

}  // namespace
}  // namespace plumbline::known_limits_test
