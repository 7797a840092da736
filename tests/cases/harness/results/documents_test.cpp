// Results as JSON: numbers that are not finite are null, and every document says what it was made of.
#include "cases/harness/results/documents.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::documents_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
const Case toy = toy_case();

RunResult finished_run() {
  RunResult run("toy", "default", toy.settings("default", {}));
  run.finished = true;
  run.steps = 10;
  run.points = 3;
  run.h = 0.25;
  run.end_time = 1e-2;
  run.wall_s = 0.5;
  run.measures = {scalar_measure("period", 1.5, 1.0, 1e-15, "s"), {"density.L1", 0.25, 2, {}, {}, 1e-14, "kg/m^3"}};
  run.file = "toy.h5";
  return run;
}

JudgedGate judged_gate(Gate gate, Measured measured) {
  JudgedGate made{gate, "toy", "default", "s", measured, judge(gate, measured), {"a.h5"}};
  return made;
}

Measured number(double value) {
  Measured measured;
  measured.value = value;
  return measured;
}

// No number in a document may be infinite or NaN: JSON has none, and a dump would hide it as null without our knowing.
void expect_finite(const Json& document) {
  if (document.is_number_float()) {
    EXPECT_TRUE(std::isfinite(document.get<double>()));
  }
  if (document.is_structured()) {
    for (const Json& part : document) expect_finite(part);
  }
}

TEST(Documents, ValuesKeepTheirKind) {
  EXPECT_EQ(to_json(Value{100.0}).dump(), "100");
  EXPECT_EQ(to_json(Value{0.3}).dump(), "0.3");
  EXPECT_EQ(to_json(Value{std::string("cubic")}).dump(), "\"cubic\"");
  EXPECT_EQ(to_json(Value{}).dump(), "null");
  EXPECT_EQ(to_json(Value{1e300}).get<double>(), 1e300);
}

TEST(Documents, SettingsListAllResolvedChoices) {
  const Settings settings = find_case("sod").settings("default", {});
  const Json document = to_json(settings);
  EXPECT_EQ(document.size(), settings.keys().size());
  for (const Key& key : settings.keys()) EXPECT_TRUE(document.contains(key.name)) << key.name;
  EXPECT_EQ(document["cells"], 100);
  EXPECT_EQ(document["integrator"], "leapfrog");
  EXPECT_TRUE(document["dt"].is_null());
}

TEST(Documents, OfAFinishedRun) {
  const Json d = run_document(finished_run(), {judged_gate(toy_gate("g", {{}, 1}), number(0.5))}, Provenance{});
  EXPECT_EQ(d["case"], "toy");
  EXPECT_EQ(d["verdict"], "PASS");
  EXPECT_EQ(d["finished"], true);
  EXPECT_TRUE(d["stop"].is_null());
  EXPECT_EQ(d["steps"], 10);
  EXPECT_EQ(d["points"], 3);
  EXPECT_EQ(d["particle_steps_per_s"], 60);
  EXPECT_EQ(d["measures"]["period"]["error"], 0.5);
  EXPECT_EQ(d["measures"]["period"]["relative_error"], 0.5);
  EXPECT_EQ(d["measures"]["period"]["value"], 1.5);
  EXPECT_EQ(d["measures"]["period"]["reference"], 1);
  EXPECT_EQ(d["measures"]["period"]["unit"], "s");
  EXPECT_EQ(d["measures"]["density.L1"]["relative_error"], 0.125);
  EXPECT_TRUE(d["measures"]["density.L1"]["value"].is_null());
  EXPECT_EQ(d["measures"]["density.L1"]["reference_bound"], 1e-14);
  expect_finite(d);
}

TEST(Documents, ARunWithoutGatesHasNoVerdictButNone) {
  EXPECT_EQ(run_document(finished_run(), {}, Provenance{})["verdict"], "NONE");
}

TEST(Documents, OfAStoppedRun) {
  RunResult run = finished_run();
  run.finished = false;
  run.stop = Stop{"the density must be positive", "gas", "density", 7, 0.5, 3, nan};
  const Json d = run_document(run, {}, Provenance{});
  EXPECT_EQ(d["finished"], false);
  for (const char* key : {"reason", "step", "time", "point", "field", "value"})
    EXPECT_TRUE(d["stop"].contains(key)) << key;
  EXPECT_EQ(d["stop"]["step"], 7);
  EXPECT_EQ(d["stop"]["point"], 3);
  EXPECT_EQ(d["stop"]["field"], "density");
  EXPECT_TRUE(d["stop"]["value"].is_null());
}

TEST(Documents, NumbersThatAreNotFiniteAreNull) {
  RunResult run = finished_run();
  run.measures = {scalar_measure("period", nan, 1, infinity, "s"), {"x", infinity, 0, nan, -infinity, nan, "1"}};
  run.wall_s = nan;
  run.h = infinity;
  run.ledger.energy.open(nan, nan);
  const Json d = run_document(run, {judged_gate(toy_gate("g", {{}, 1}), number(nan))}, Provenance{});
  expect_finite(d);
  EXPECT_TRUE(d["measures"]["period"]["error"].is_null());
  EXPECT_TRUE(d["measures"]["period"]["value"].is_null());
  EXPECT_TRUE(d["measures"]["x"]["relative_error"].is_null());
  EXPECT_TRUE(d["h"].is_null());
  EXPECT_TRUE(d["ledger"]["energy"]["initial"].is_null());
  EXPECT_TRUE(d["gates"][0]["measured"].is_null());
  EXPECT_EQ(d["gates"][0]["verdict"], "INVALID");
}

TEST(Documents, OfAGate) {
  Gate gate = toy_gate("s/gate", {0.5, {}});
  gate.expected_failure = ExpectedFailure{"points cross cells", {0.1, 0.3}, {}, {}};
  Measured measured = number(0.2);
  measured.note = "as ever";
  const Json d = to_json(judged_gate(gate, measured));
  EXPECT_EQ(d["id"], "s/gate");
  EXPECT_EQ(d["case"], "toy");
  EXPECT_EQ(d["scheme"], "default");
  EXPECT_EQ(d["quantity"], "a number");
  EXPECT_EQ(d["expected"]["low"], 0.5);
  EXPECT_TRUE(d["expected"]["high"].is_null());
  EXPECT_EQ(d["origin"], "requirement");
  EXPECT_EQ(d["measured"], 0.2);
  EXPECT_TRUE(d["interval"].is_null());
  EXPECT_EQ(d["verdict"], "XFAIL");
  EXPECT_EQ(d["cause"], "points cross cells");
  EXPECT_EQ(d["run_ids"], Json::array({"a.h5"}));
  EXPECT_LT(d["margin"].get<double>(), 0);
}

TEST(Documents, AnIntervalWithoutEndIsNull) {
  Gate gate = toy_gate("g", {0.5, {}});
  gate.order = true;
  Measured measured = number(1);
  measured.interval = {0.9, 1.1};
  EXPECT_EQ(to_json(judged_gate(gate, measured))["interval"], Json::array({0.9, 1.1}));
  measured.interval = {-infinity, infinity};
  EXPECT_TRUE(to_json(judged_gate(gate, measured))["interval"].is_null());
}

TEST(Documents, TheLedgerHasEveryFlowOfEveryQuantity) {
  Ledger ledger;
  Totals totals;
  totals.energy = {1, 2, 3};
  ledger.open(totals);
  ledger.energy.book(Flow::body_force, 0.5);
  ledger.viscous = 0.25;
  const Json line = to_json(ledger, 1), plane = to_json(ledger, 2);
  EXPECT_FALSE(line.contains("momentum_y"));
  for (const char* quantity : {"momentum_x", "momentum_y", "angular_momentum", "energy"}) {
    for (const std::string_view flow : flow_names)
      EXPECT_TRUE(plane[quantity]["flows"].contains(std::string(flow))) << quantity;
  }
  EXPECT_EQ(plane["energy"]["flows"]["body_force"], 0.5);
  EXPECT_EQ(plane["energy"]["viscous"], 0.25);
  EXPECT_EQ(plane["energy"]["stores"], Json({{"kinetic", 1.0}, {"internal", 2.0}, {"elastic", 3.0}}));
  EXPECT_EQ(plane["energy"]["initial"], 6);
}

// Each account shows the drift that its gate judges: with booked impulse in the scale for momenta, without for energy.
TEST(Documents, DriftsAreThoseOfTheGates) {
  Ledger ledger;
  Totals totals;
  totals.mass = totals.grid_mass = 1;
  totals.momentum_scale = 1;
  totals.energy.internal = 1;
  ledger.open(totals);
  for (Account* account : {&ledger.momentum[0], &ledger.energy}) {
    account->book(Flow::walls, 1.5);
    account->book(Flow::walls, -1.5);
  }
  totals.momentum[0] = 1e-3;
  totals.energy.internal = 1.001;
  ledger.close_step(totals);
  const Json d = to_json(ledger, 1);
  EXPECT_NEAR(d["momentum_x"]["relative_drift"].get<double>(), 1e-3 / 4, 1e-15);
  EXPECT_NEAR(d["energy"]["relative_drift"].get<double>(), 1e-3 / 1.001, 1e-15);
}

TEST(Documents, OfAStudy) {
  StudyResult study{&toy, {.id = "s", .title = "t", .why = "w"}, "default", {}, {}, {}, nullptr};
  study.levels.push_back({4, 0.25, finished_run(), {}});
  study.fits.emplace_back("period", fit_order(std::vector<Level>(1, Level{0.25, 0.5, 0, 0, {}, {}}), Weighting::equal));
  const Json d = study_document(study, {}, Provenance{});
  EXPECT_EQ(d["scheme"], "default");
  EXPECT_EQ(d["vary"], "cells");
  EXPECT_EQ(d["id"], "s");
  EXPECT_EQ(d["levels"].size(), 1u);
  EXPECT_EQ(d["levels"][0]["value"], 4);
  EXPECT_EQ(d["levels"][0]["h"], 0.25);
  EXPECT_TRUE(d["measures"]["period"]["order"].is_null()) << "one level has no order";
  EXPECT_FALSE(d["measures"]["period"]["reason"].get<std::string>().empty());
  expect_finite(d);
}

TEST(Documents, CountsNameEveryVerdict) {
  const Json d = counts_document(
      {judged_gate(toy_gate("g", {{}, 1}), number(0.5)), judged_gate(toy_gate("g", {{}, 1}), number(2))});
  EXPECT_EQ(d.size(), all_verdicts.size());
  EXPECT_EQ(d["PASS"], 1);
  EXPECT_EQ(d["FAIL"], 1);
  EXPECT_EQ(d["XPASS"], 0);
}

TEST(Documents, TheCatalogHasEveryGateWithItsReason) {
  for (const Case* entry : cases()) {
    const Json d = catalog_entry(*entry);
    std::size_t in_plans = 0;
    for (const CaseGate& gate : entry->gates) in_plans += gate.study.rfind("integrator/", 0) != 0;
    EXPECT_EQ(d["gates"].size(), in_plans) << entry->name;
    EXPECT_EQ(d["studies"].size(), entry->studies.size()) << entry->name;
    for (const Json& gate : d["gates"]) EXPECT_FALSE(gate["reason"].get<std::string>().empty());
    expect_finite(d);
    EXPECT_EQ(d.contains("may_be_undefined"), !entry->may_be_undefined.empty()) << entry->name;
  }
}

TEST(Documents, OfErrors) {
  const Json usage = error_document(UsageError("cfl", "-1", "(0, inf)", {"cfl"}, "no"));
  EXPECT_EQ(usage["error"]["key"], "cfl");
  EXPECT_EQ(usage["error"]["value"], "-1");
  EXPECT_EQ(usage["error"]["allowed"], "(0, inf)");
  EXPECT_EQ(usage["error"]["nearest"], Json::array({"cfl"}));
  EXPECT_EQ(usage["error"]["message"], "no");
  const Json file = error_document("a/b", "cannot");
  EXPECT_EQ(file["error"]["key"], "a/b");
  EXPECT_TRUE(file["error"]["nearest"].is_array());
}

}  // namespace
}  // namespace plumbline::documents_test
