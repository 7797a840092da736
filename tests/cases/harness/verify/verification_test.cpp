// A whole verification: what is run, what is judged, and that nothing is skipped in silence.
#include "cases/harness/verify/verification.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "tests/cases/harness/temporary_folder.hpp"
#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::verification_test {
namespace {

// Two studies of one scheme each and a gate on each; generic gates are four a study.
Toy described() {
  Toy toy;
  toy.measures = [](const Settings& s, const Simulation&) { return power_law_error(1 / s.number("cells"), 1, 1); };
  toy.studies = {{.id = "default", .title = {}, .why = {}, .values = {4, 8}},
                 {.id = "york", .title = {}, .why = {}, .scheme = "york1997", .values = {4}},
                 {.id = "late", .title = {}, .why = {}, .values = {4}, .tier = Tier::full}};
  toy.gates = {gate("default/error", error_at("error", 8), at_most(0.2), wanted_by_test),
               gate("york/error", error_at("error", 4), at_most(0.2), wanted_by_test),
               gate("default/late", error_at("error", 4), at_most(1), wanted_by_test).in(Tier::full)};
  return toy;
}

Verification verified(const Case& entry, Tier tier = Tier::quick, const Selection& selection = {}, int threads = 1) {
  const TemporaryFolder folder;
  Verification verification;
  const ResultsFolder results(folder.path());
  RunStore store(results, Provenance{}, false);
  verify_case(entry, tier, selection, threads, store, {}, verification);
  return verification;
}

std::set<std::string> ids(const Verification& verification) {
  std::set<std::string> all;
  for (const JudgedGate& gate : verification.gates) EXPECT_TRUE(all.insert(gate.gate.id).second) << gate.gate.id;
  return all;
}

std::size_t executed(const Verification& verification) { return verification.gates.size(); }

TEST(VerifyCase, JudgesEveryDeclaredGateAndTheGenericOnes) {
  const Verification v = verified(toy_case(described()));
  EXPECT_EQ(v.declared, 10);
  EXPECT_EQ(executed(v), 10u);
  EXPECT_EQ(ids(v), (std::set<std::string>{"default/error", "default/finite", "default/mass", "default/momentum",
                                           "default/ledger", "york/error", "york/finite", "york/mass", "york/momentum",
                                           "york/ledger"}));
  for (const JudgedGate& gate : v.gates) {
    EXPECT_EQ(gate.judgement.verdict, gate.gate.id == "york/error" ? Verdict::fail : Verdict::pass) << gate.gate.id;
    EXPECT_EQ(gate.scheme, gate.study == "york" ? "york1997" : "default");
    EXPECT_FALSE(gate.run_ids.empty());
  }
}

TEST(VerifyCase, TheFullTierAddsItsStudiesAndGates) {
  const Verification v = verified(toy_case(described()), Tier::full);
  EXPECT_EQ(v.declared, 15);
  EXPECT_EQ(executed(v), 15u);
  EXPECT_TRUE(ids(v).count("default/late"));
  EXPECT_TRUE(ids(v).count("late/ledger"));
}

Regressions recorded_of_described() {
  const auto line = [](const std::string& study, const std::string& id, std::optional<Range> within) {
    return RecordedValue{"toy", study, id, "quick", 0.125, within, "2026-11-23 5825b24", {}};
  };
  return Regressions({line("default", "default/error", Range{0.05, 0.3}), line("default", "default/mass", {}),
                      line("york", "york/finite", {})});
}

Selection with(const Regressions& recorded, std::vector<std::string> schemes = {},
               std::vector<std::string> settings = {}) {
  Selection selection;
  selection.schemes = std::move(schemes);
  selection.settings = std::move(settings);
  selection.recorded = &recorded;
  return selection;
}

// Values of 0.125 and 0.25: the second has no recorded range.
TEST(VerifyCase, RecordedValuesAreGatesOfTheirOwn) {
  const Regressions recorded = recorded_of_described();
  const Verification v = verified(toy_case(described()), Tier::quick, with(recorded));
  EXPECT_EQ(v.declared, 11);
  EXPECT_EQ(v.regressions, 1);
  EXPECT_TRUE(complete(v));
  const auto on_record = std::find_if(v.gates.begin(), v.gates.end(), [](const JudgedGate& g) { return of_record(g); });
  ASSERT_NE(on_record, v.gates.end());
  EXPECT_EQ(on_record->gate.id, "default/error/regression");
  EXPECT_EQ(on_record->judgement.verdict, Verdict::pass);
  std::set<std::string> names;
  for (const auto& [case_name, study, id, tier] : v.unrecorded) names.insert(id);
  EXPECT_EQ(names, (std::set<std::string>{"default/finite", "default/momentum", "default/ledger", "york/mass",
                                          "york/momentum", "york/ledger"}));
}

// Which integrators are registered is not for the case to say.
TEST(VerifyCase, GatesOnIntegratorsNeedNoRecordedValue) {
  Toy toy = described();
  toy.any_integrator = true;
  const Regressions recorded = recorded_of_described();
  const Verification v = verified(toy_case(toy), Tier::quick, with(recorded));
  EXPECT_EQ(v.unrecorded.size(), 6u);
  for (const auto& [case_name, study, id, tier] : v.unrecorded)
    EXPECT_EQ(study.find("integrator/"), std::string::npos) << id;
}

TEST(VerifyCase, OtherChoicesAndTiersAreNotComparedWithRecordedValues) {
  const Regressions recorded = recorded_of_described();
  EXPECT_EQ(verified(toy_case(described()), Tier::full, with(recorded)).regressions, 0);
  const Verification v = verified(toy_case(described()), Tier::quick, with(recorded, {}, {"weight=2"}));
  EXPECT_EQ(v.regressions, 0);
  EXPECT_TRUE(v.unrecorded.empty());
  EXPECT_TRUE(complete(verified(toy_case(described()), Tier::quick, with(recorded, {"default"}))));
}

// A study that throws is invalid, with what was said; the other study of the case keeps its verdicts, and nothing is skipped.
TEST(VerifyCase, WhatThrowsFailsAlone) {
  Toy toy = described();
  toy.measures = [](const Settings& s, const Simulation&) {
    if (s.number("cells") == 8) throw std::runtime_error("no root in [0, 1]");
    return power_law_error(1 / s.number("cells"), 1, 1);
  };
  const Verification v = verified(toy_case(toy));
  EXPECT_TRUE(complete(v));
  for (const JudgedGate& gate : v.gates) {
    const Verdict expected = gate.study == "default"        ? Verdict::invalid
                             : gate.gate.id == "york/error" ? Verdict::fail
                                                            : Verdict::pass;
    EXPECT_EQ(gate.judgement.verdict, expected) << gate.gate.id;
    EXPECT_EQ(gate.measured.note, gate.study == "default" ? "no root in [0, 1]" : "") << gate.gate.id;
  }
}

// A measure that is no number is never green, unless the case says why it may be none.
TEST(VerifyCase, AMeasureThatIsNoNumberIsInvalid) {
  Toy toy = described();
  toy.measures = [](const Settings& s, const Simulation&) {
    std::vector<Measure> all = power_law_error(1 / s.number("cells"), 1, 1);
    all.push_back(scalar_measure("front", s.number("cells") == 8 ? std::nan("") : 1, 1, 0, "m"));
    return all;
  };
  const auto finite = [](const Verification& v) {
    const auto found = std::find_if(v.gates.begin(), v.gates.end(),
                                    [](const JudgedGate& gate) { return gate.gate.id == "default/finite"; });
    return std::pair{found->judgement.verdict, found->measured.note};
  };
  EXPECT_EQ(finite(verified(toy_case(toy))),
            (std::pair{Verdict::invalid, std::string("front is not a number at 8 cells")}));
  toy.may_be_undefined = {{"front", "no front is found on few cells"}};
  EXPECT_EQ(finite(verified(toy_case(toy))).first, Verdict::pass);
}

// Whatever keeps a gate from being judged, it is named: a misspelt study, a level that is not run, a line of the record.
TEST(VerifyCase, WhatIsNotExecutedIsLost) {
  const auto lost = [](const Toy& toy, const Selection& selection = {}) {
    const Verification v = verified(toy_case(toy), Tier::quick, selection);
    EXPECT_EQ(complete(v), v.lost.empty());
    std::vector<std::string> ids;
    for (const auto& [case_name, study, id, tier] : v.lost) ids.push_back(id);
    return ids;
  };
  EXPECT_TRUE(lost(described()).empty());

  Toy misspelt = described();
  misspelt.gates[0].study = "defualt";
  EXPECT_EQ(lost(misspelt), std::vector<std::string>{"default/error"});

  Toy unreached = described();
  unreached.gates[0].levels = {16};
  EXPECT_EQ(lost(unreached), std::vector<std::string>{"default/error"});

  Toy shorter = described();
  shorter.studies.erase(shorter.studies.begin() + 1);
  shorter.gates.erase(shorter.gates.begin() + 1);
  const Regressions recorded = recorded_of_described();
  EXPECT_TRUE(lost(described(), with(recorded)).empty());
  EXPECT_EQ(lost(shorter, with(recorded)), std::vector<std::string>{"york/finite"});
}

TEST(VerifyCase, WritesEveryRunAndStudy) {
  const TemporaryFolder folder;
  Verification verification;
  const ResultsFolder results(folder.path());
  RunStore store(results, Provenance{}, false);
  verify_case(toy_case(described()), Tier::quick, {}, 1, store, {}, verification);
  const auto names = folder.names();
  EXPECT_EQ(
      std::count_if(names.begin(), names.end(), [](const std::string& n) { return n.rfind("study-toy", 0) == 0; }), 2);
  EXPECT_EQ(std::count_if(names.begin(), names.end(), [](const std::string& n) { return n.rfind("toy-", 0) == 0; }), 3);
  for (const JudgedGate& gate : verification.gates) {
    for (const std::string& id : gate.run_ids) EXPECT_NE(std::find(names.begin(), names.end(), id), names.end()) << id;
  }
}

TEST(VerifyCase, DoesNotDependOnTheNumberOfThreads) {
  const Verification one = verified(toy_case(described())), three = verified(toy_case(described()), Tier::quick, {}, 3);
  ASSERT_EQ(executed(one), executed(three));
  for (std::size_t k = 0; k < one.gates.size(); ++k) {
    EXPECT_EQ(one.gates[k].gate.id, three.gates[k].gate.id);
    EXPECT_EQ(one.gates[k].measured.value, three.gates[k].measured.value);
  }
}

// A generic gate that the case declares itself, as expected to fail, stands once.
TEST(VerifyCase, ADeclaredGenericGateReplacesTheOther) {
  Toy toy = described();
  toy.gates.push_back(gate("york/finite", number_of("four", [](const StudyResult&) { return Measured::of(4); }),
                           at_most(5), wanted_by_test));
  const Verification v = verified(toy_case(toy));
  EXPECT_EQ(executed(v), 10u);
  const auto own = std::find_if(v.gates.begin(), v.gates.end(),
                                [](const JudgedGate& g) { return g.gate.id == "york/finite"; });
  ASSERT_NE(own, v.gates.end());
  EXPECT_EQ(own->measured.value, 4);
}

TEST(VerifyCase, AStoppedRunIsRed) {
  Toy toy = described();
  toy.change = [](Scene& scene) { scene.bodies[0].points(column::position)[1] = -0.5; };
  for (const JudgedGate& gate : verified(toy_case(toy)).gates) {
    if (gate.gate.id == "default/finite" || gate.gate.id == "default/error") {
      EXPECT_EQ(gate.judgement.verdict, Verdict::fail) << gate.gate.id;
    }
  }
}

// --- integrators ------------------------------------------------------------------------------------------------------

// One that no case knows, as a plug-in would bring it.
class Coasting final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();
    mpm.map_forces();
    mpm.advance_momentum(dt);
    mpm.move_points(dt);
  }
};

void register_coasting() {
  if (find_integrator("coasting")) return;
  RegisterIntegrator(
      {"coasting", "moves points and leaves stresses as they are", "this test",
       [] { return std::make_unique<Coasting>(); },
       [](const TimeIntegrator& now) { return std::make_unique<Coasting>(static_cast<const Coasting&>(now)); }});
}

TEST(VerifyCase, EveryRegisteredIntegratorAppearsWithGenericGates) {
  register_coasting();
  Toy toy = described();
  toy.any_integrator = true;
  const Verification v = verified(toy_case(toy));
  for (const IntegratorEntry& integrator : integrators()) {
    for (const char* gate : {"finite", "mass", "momentum", "ledger"}) {
      EXPECT_TRUE(ids(v).count("integrator/" + integrator.name + "/" + gate)) << integrator.name << "/" << gate;
    }
  }
  EXPECT_EQ(executed(v), 10 + 4 * integrators().size());
  EXPECT_EQ(static_cast<int>(executed(v)), v.declared);
  for (const JudgedGate& gate : v.gates) {
    const std::string wanted = gate.study == "integrator/coasting" ? "default+coasting" : "default";
    if (gate.study == "integrator/coasting" || gate.study == "integrator/leapfrog") {
      EXPECT_EQ(gate.scheme, wanted);
    }
  }
}

TEST(VerifyCase, WithoutAnyIntegratorNoneAppears) {
  register_coasting();
  for (const std::string& id : ids(verified(toy_case(described()))))
    EXPECT_EQ(id.find("integrator/"), std::string::npos);
}

TEST(IntegratorPlan, IsTheDefaultSchemeAtTheCoarsestLevel) {
  const Case entry = toy_case(described());
  const StudyPlan plan = integrator_plan(entry, "usl");
  EXPECT_EQ(plan.id, "integrator/usl");
  EXPECT_EQ(plan.scheme, "default");
  EXPECT_EQ(plan.values, std::vector<double>{4});
  EXPECT_EQ(planned_runs(entry, plan, Tier::quick).front().settings.text("integrator"), "usl");
  EXPECT_EQ(integrator_scheme(entry, "leapfrog"), "default");
  EXPECT_EQ(integrator_scheme(entry, "usl"), "default+usl");
}

// --- selections -------------------------------------------------------------------------------------------------------

TEST(Selection, OfASchemeJudgesItsStudies) {
  Toy toy = described();
  toy.any_integrator = true;
  const Verification v = verified(toy_case(toy), Tier::quick,
                                  {.schemes = {"york1997"}, .integrators = {}, .settings = {}});
  EXPECT_EQ(ids(v), (std::set<std::string>{"york/error", "york/finite", "york/mass", "york/momentum", "york/ledger"}));
  EXPECT_EQ(v.declared, 5);
}

TEST(Selection, OfAnIntegratorJudgesItByGenericGates) {
  const Verification v = verified(toy_case(described()), Tier::quick,
                                  {.schemes = {}, .integrators = {"usl"}, .settings = {}});
  EXPECT_EQ(ids(v), (std::set<std::string>{"integrator/usl/finite", "integrator/usl/mass", "integrator/usl/momentum",
                                           "integrator/usl/ledger"}));
  EXPECT_EQ(v.declared, 4);
}

// The declared numbers hold for the declared choices.
TEST(Selection, OfKeysLeavesTheGenericGates) {
  const Verification v = verified(toy_case(described()), Tier::quick,
                                  {.schemes = {}, .integrators = {}, .settings = {"weight=2"}});
  EXPECT_EQ(executed(v), 8u);
  EXPECT_EQ(v.declared, 8);
  for (const std::string& id : ids(v)) EXPECT_EQ(id.find("error"), std::string::npos) << id;
}

TEST(Selection, UnknownNamesAreRefusedBeforeAnythingRuns) {
  Toy toy = described();
  int runs = 0;
  toy.change = [&](Scene&) { ++runs; };
  const Case entry = toy_case(toy);
  EXPECT_THROW(verified(entry, Tier::quick, {.schemes = {"york1998"}, .integrators = {}, .settings = {}}), UsageError);
  EXPECT_THROW(verified(entry, Tier::quick, {.schemes = {"default"}, .integrators = {"uls"}, .settings = {}}),
               UsageError);
  EXPECT_THROW(verified(entry, Tier::quick, {.schemes = {}, .integrators = {}, .settings = {"wieght=2"}}), UsageError);
  EXPECT_EQ(runs, 0);
}

}  // namespace
}  // namespace plumbline::verification_test
