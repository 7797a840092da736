// Whose failures the expected ones are.
#include "cases/harness/judge/expected_failures.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::expected_failures_test {
namespace {

FailureOf of(const std::string& scheme, std::vector<Override> overrides = {}, Kind kind = Kind::membrane) {
  Toy toy;
  toy.kind = kind;
  return failure_of(toy_case(toy),
                    {.id = "s", .title = {}, .why = {}, .scheme = scheme, .overrides = std::move(overrides)},
                    toy_gate("s/error", {{}, 1}));
}

TEST(FailureOf, StudiesOfYorksSchemeAndMethodsAreYorks) {
  EXPECT_EQ(of("york1997"), FailureOf::york);
  EXPECT_EQ(of("york1997", {{"shape", "cubic"}}), FailureOf::york);
  EXPECT_EQ(of("default", {{"normals", "york-cubic"}}, Kind::coupled), FailureOf::york);
}

TEST(FailureOf, MeshStepAndTheCasesOwnKeysLeaveTheDefault) {
  EXPECT_EQ(of("default"), FailureOf::standard);
  EXPECT_EQ(of("default", {{"cells", 40.0}, {"dt", 1e-3}, {"cfl", 0.1}, {"ppc", 2.0}, {"weight", 2.0}}),
            FailureOf::standard);
  EXPECT_EQ(of("default", {{"shape", "quadratic"}}), FailureOf::standard);  // it is the default's own
}

TEST(FailureOf, ChoicesOfASchemeMakeAnother) {
  EXPECT_EQ(of("default", {{"shape", "linear"}}), FailureOf::other);
  EXPECT_EQ(of("default", {{"cells", 40.0}, {"integrator", "usl"}}), FailureOf::other);
  EXPECT_EQ(of("default", {{"membrane.strain", "accumulated"}}, Kind::coupled), FailureOf::other);
}

FailureOf of_study(const std::string& name, const std::string& id) {
  const Case& entry = find_case(name);
  for (const StudyPlan& plan : entry.studies) {
    if (plan.id == id) return failure_of(entry, plan, toy_gate(id + "/time", {{}, 1}));
  }
  throw std::out_of_range(id);
}

// A case of membranes has choices of its own; where York's points stand is the problem's.
TEST(FailureOf, OwnChoicesOfTheMethodCount) {
  EXPECT_EQ(of_study("string-slack", "accumulated"), FailureOf::other);
  EXPECT_EQ(of_study("string-slack", "aligned"), FailureOf::standard);
  EXPECT_EQ(of_study("string-slack", "york1997"), FailureOf::york);
  EXPECT_EQ(of_study("pulled-strip", "default"), FailureOf::standard);
  EXPECT_EQ(of_study("pulled-strip", "fitted"), FailureOf::other);
  EXPECT_EQ(of_study("drum", "markers"), FailureOf::other);
  EXPECT_EQ(of_study("twisted-annulus", "two-way"), FailureOf::other);
  EXPECT_EQ(of_study("elastic-plastic-impact", "default"), FailureOf::standard);
  EXPECT_EQ(of_study("elastic-plastic-impact", "inviscid"), FailureOf::other);
}

// By how much a strip is pulled is its problem, though coupled scenes have a choice `membrane.strain`.
TEST(FailureOf, OwnKeysOfTheProblemDoNotCount) {
  const StudyPlan plan{.id = "s", .title = {}, .why = {}, .overrides = {{"strain", 0.1}}};
  EXPECT_EQ(failure_of(find_case("pulled-strip"), plan, toy_gate("s/error", {{}, 1})), FailureOf::standard);
}

// A number that York published is his, whatever scheme the study has; of a case with another source it is not.
TEST(FailureOf, PublishedNumbersOfHisReportAreYorks) {
  const Case& his = find_case("stability-york");
  const Case& not_his = find_case("stability-catalog");
  const StudyPlan plan{.id = "s", .title = {}, .why = {}};
  Gate gate = toy_gate("s/first", {{}, 1});
  EXPECT_EQ(failure_of(his, plan, gate), FailureOf::standard);
  gate.origin = Origin::literature;
  EXPECT_EQ(failure_of(his, plan, gate), FailureOf::york);
  EXPECT_EQ(failure_of(not_his, plan, gate), FailureOf::standard);
}

TEST(FailureOf, TrialsOfAnotherSchemeAreItsOwn) {
  EXPECT_EQ(of_study("riemann-draws", "default"), FailureOf::standard);
  EXPECT_EQ(of_study("riemann-draws", "sharper"), FailureOf::other);
  EXPECT_EQ(of_study("riemann-draws", "nodes"), FailureOf::other);
}

// Trials of the laboratory have no scene: what they look at is named by the gate.
TEST(FailureOf, TrialsLookAtWhatTheirGatesName) {
  const Case& entry = find_case("stability-gas");
  const StudyPlan plan{.id = "plane", .title = {}, .why = {}, .overrides = {{"trial", "plane"}}};
  EXPECT_EQ(failure_of(entry, plan, toy_gate("plane/york1997-rate", {{}, 1})), FailureOf::york);
  EXPECT_EQ(failure_of(entry, plan, toy_gate("plane/default-rate", {{}, 1})), FailureOf::standard);
  EXPECT_EQ(failure_of(entry, plan, toy_gate("bar-vibration-flip/at-1.1", {{}, 1})), FailureOf::other);
}

JudgedGate judged(Verdict verdict, const std::string& scheme) {
  JudgedGate gate;
  gate.case_name = "unknown";
  gate.scheme = scheme;
  gate.judgement.verdict = verdict;
  return gate;
}

TEST(ExpectedFailures, AreCountedAndSaidByOwner) {
  const FailureCounts counts = expected_failures(
      {judged(Verdict::xfail, "york1997"), judged(Verdict::xfail, "york1997"), judged(Verdict::xfail, "default+usl"),
       judged(Verdict::xfail, "default"), judged(Verdict::pass, "default"), judged(Verdict::fail, "default")});
  EXPECT_EQ(words(counts), "4 expected: 2 York's own, 1 of other schemes, 1 of the default");
  EXPECT_EQ(words(expected_failures({judged(Verdict::pass, "default")})), "");
}

}  // namespace
}  // namespace plumbline::expected_failures_test
