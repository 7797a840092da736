// Cases of known answers: an answer that is off makes its trial red, and is named.
#include "cases/catalog/estimators/known_answers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/verify/verification.hpp"

namespace plumbline::known_answers_test {
namespace {

KnownAnswers right() { return {{"one", 1.5, 1.5}, {"two", 20 * (1 + 1e-12), 20, 20}}; }
KnownAnswers one_off() { return {{"one", 1.5, 1.5}, {"two", 20 * (1 + 3e-9), 20, 20}}; }
KnownAnswers no_number() { return {{"one", NAN, 1.5}, {"two", 20, 20, 20}}; }

Findings findings_of(KnownAnswers (*answers)()) {
  const Case made = known_answers_case("known", {{"trial", "trial", "why", answers, 1e-9, "known"}});
  return made.trials.front().find();
}

double value_of(const Findings& findings, const std::string& name) {
  for (const Measure& measure : findings.measures) {
    if (measure.name == name) return measure.value.value_or(NAN);
  }
  ADD_FAILURE() << "no measure " << name;
  return NAN;
}

TEST(KnownAnswers, AreMeasuredByTheirLargestDeviationOverTheScale) {
  const Findings found = findings_of(right);
  ASSERT_EQ(found.measures.size(), 2u);
  EXPECT_NEAR(value_of(found, "deviation"), 1e-12, 1e-15);
  EXPECT_EQ(value_of(found, "answers"), 2);
}

TEST(KnownAnswers, NameWhatIsOff) {
  const Findings found = findings_of(one_off);
  EXPECT_NEAR(value_of(found, "deviation"), 3e-9, 1e-14);
  ASSERT_EQ(found.measures.size(), 3u);
  EXPECT_EQ(found.measures.front().name, "two");
  EXPECT_EQ(found.measures.front().reference, 20);
}

TEST(KnownAnswers, LoseNoNan) {
  const Findings found = findings_of(no_number);
  EXPECT_TRUE(std::isnan(value_of(found, "deviation")));
  EXPECT_EQ(found.measures.front().name, "one");
}

TEST(KnownAnswers, HaveAGateEachTrial) {
  const Case made = known_answers_case("known", {{"trial", "trial", "why", right, 1e-9, "because"}});
  ASSERT_EQ(made.gates.size(), 1u);
  EXPECT_EQ(made.gates.front().gate.id, "trial/deviation");
  EXPECT_EQ(made.gates.front().gate.expected.high, 1e-9);
  EXPECT_EQ(made.gates.front().gate.origin, Origin::identity);
}

}  // namespace
}  // namespace plumbline::known_answers_test
