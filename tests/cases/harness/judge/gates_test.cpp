// Gates on studies made by hand: which number each reads, and that each can fail.
#include "cases/harness/judge/gates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::gates_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
const Case toy = toy_case();

// A run that conserved everything, of these masses and energies.
struct Spoilt {
  double grid_mass = 1, energy = 1;
  std::array<double, 3> angular{1, 1, 1}, momentum{0, 0, 0};
};

Ledger ledger(const Spoilt& end = {}) {
  Totals totals;
  totals.mass = totals.grid_mass = 1;
  totals.momentum_scale = 1;
  totals.angular_momentum = {1, 1, 1};
  totals.angular_scale = 1;
  totals.energy.internal = 1;
  Ledger made;
  made.open(totals);
  totals.grid_mass = end.grid_mass;
  totals.momentum = end.momentum;
  totals.angular_momentum = end.angular;
  totals.energy.internal = end.energy;
  made.close_step(totals);
  return made;
}

RunResult finished_run(std::vector<Measure> measures = {}, const Spoilt& end = {}, int dim = 1) {
  RunResult run("toy", "default", toy.settings("default", {}));
  run.dim = dim;
  run.finished = true;
  run.steps = 10;
  run.measures = std::move(measures);
  run.ledger = ledger(end);
  return run;
}

RunResult stopped_run(long step, const std::string& field) {
  RunResult run = finished_run();
  run.finished = false;
  run.stop = Stop{"it had to", "toy", field, step, 0.1, 0, 1};
  return run;
}

StudyResult study(const std::vector<std::pair<double, RunResult>>& levels) {
  StudyResult made{&toy, {.id = "s", .title = {}, .why = {}}, "default", {}, {}, {}, nullptr};
  for (const auto& [value, run] : levels) made.levels.push_back({value, 1 / value, run, {}});
  for (StudyLevel& at : made.levels) at.run.file = "run-" + std::to_string(static_cast<int>(at.value)) + ".h5";
  return made;
}

std::vector<Measure> errors(double error, double bound = 0) { return {{"error", error, 1.0, {}, {}, bound, "m"}}; }

// The one verdict of one gate.
JudgedGate judged(const CaseGate& gate, const StudyResult& on) {
  const auto all = judge_gates({gate}, on);
  if (all.size() != 1) throw std::logic_error("not one gate judged");
  return all.front();
}
Verdict verdict(const CaseGate& gate, const StudyResult& on) { return judged(gate, on).judgement.verdict; }

// A gate on the study `s`.
CaseGate on_s(Number number, Range expected) { return gate("s/gate", std::move(number), expected, wanted_by_test); }

// --- numbers of one level ---------------------------------------------------------------------------------------------

TEST(Gates, AnEarlierMeasurementMayDriftByItsShareAndNoFurther) {
  const Gate gate = recorded("s/drift", energy_drift(), -4, 0.1, "2026-11-21 a1b2c3d", "as it was").gate;
  EXPECT_NEAR(*gate.expected.low, -4.4, 1e-15);
  EXPECT_NEAR(*gate.expected.high, -3.6, 1e-15);
  EXPECT_EQ(gate.origin, Origin::regression);
  EXPECT_EQ(gate.measured_on, "2026-11-21 a1b2c3d");
}

TEST(ErrorGate, ReadsTheErrorOfItsLevel) {
  const StudyResult on = study({{10, finished_run(errors(0.5))}, {20, finished_run(errors(0.25))}});
  const JudgedGate gate = judged(on_s(error_at("error", 20), at_most(0.3)), on);
  EXPECT_EQ(gate.measured.value, 0.25);
  EXPECT_EQ(gate.judgement.verdict, Verdict::pass);
  EXPECT_EQ(gate.gate.quantity, "error at 20");
  EXPECT_EQ(gate.run_ids, std::vector<std::string>{"run-20.h5"});
  EXPECT_EQ(gate.case_name, "toy");
  EXPECT_EQ(gate.scheme, "default");
  EXPECT_EQ(gate.study, "s");
  EXPECT_EQ(verdict(on_s(error_at("error", 10), at_most(0.3)), on), Verdict::fail);
}

// It is the error, not the relative error: a scale that is not 1 must not change it.
TEST(ErrorGate, ReadsNotTheRelativeError) {
  RunResult run = finished_run(errors(0.5));
  run.measures[0].scale = 10;
  EXPECT_EQ(judged(on_s(error_at("error", 10), at_most(1)), study({{10, run}})).measured.value, 0.5);
}

TEST(ErrorGate, AReferenceThatIsNotGoodEnoughIsInvalid) {
  EXPECT_EQ(verdict(on_s(error_at("error", 10), at_most(1)), study({{10, finished_run(errors(0.5, 0.009))}})),
            Verdict::pass);
  EXPECT_EQ(verdict(on_s(error_at("error", 10), at_most(1)), study({{10, finished_run(errors(0.5, 0.011))}})),
            Verdict::invalid);
  EXPECT_EQ(verdict(on_s(error_at("error", 10), at_most(1)), study({{10, finished_run(errors(0.5, nan))}})),
            Verdict::invalid);
}

TEST(ValueGate, ReadsTheValueOfItsLevel) {
  const StudyResult on = study({{10, finished_run({scalar_measure("coverage", 0.985, 1, 0, "1"), errors(1)[0]})}});
  EXPECT_EQ(judged(on_s(value_at("coverage", 10), between(0.98, 1.02)), on).measured.value, 0.985);
  EXPECT_EQ(verdict(on_s(value_at("coverage", 10), between(0.98, 1.02)), on), Verdict::pass);
  EXPECT_EQ(verdict(on_s(value_at("coverage", 10), between(0.99, 1.01)), on), Verdict::fail);
  EXPECT_EQ(verdict(on_s(value_at("error", 10), at_most(9)), on), Verdict::invalid) << "a norm has no value";
}

TEST(RatioGate, IsTheFirstLevelOverTheSecond) {
  const StudyResult on = study({{400, finished_run(errors(0.2))}, {800, finished_run(errors(0.3))}});
  const JudgedGate gate = judged(on_s(ratio_of("error", 800, 400), at_least(1.3)), on);
  EXPECT_DOUBLE_EQ(*gate.measured.value, 1.5);
  EXPECT_EQ(gate.judgement.verdict, Verdict::pass);
  EXPECT_EQ(gate.run_ids.size(), 2u);
  EXPECT_EQ(verdict(on_s(ratio_of("error", 400, 800), at_least(1.3)), on), Verdict::fail);
}

TEST(RatioGate, CarriesTheReferencesBoundOfBoth) {
  const StudyResult on = study({{1, finished_run(errors(0.2, 0.001))}, {2, finished_run(errors(0.4, 0.002))}});
  // (0.002 + 2 * 0.001) / 0.2
  EXPECT_DOUBLE_EQ(judged(on_s(ratio_of("error", 2, 1), at_least(1)), on).measured.reference_bound, 0.02);
}

TEST(RatioGate, OverAnErrorOfNothingIsNoNumber) {
  const StudyResult on = study({{1, finished_run(errors(0))}, {2, finished_run(errors(0.4))}});
  EXPECT_EQ(verdict(on_s(ratio_of("error", 2, 1), at_least(1)), on), Verdict::invalid);
  EXPECT_EQ(verdict(on_s(ratio_of("error", 1, 1), at_least(1)), on), Verdict::invalid);
}

TEST(MeasureGate, ReadsWhatItIsTold) {
  const auto twice = [](const RunResult&, const Measure& m) {
    Measured measured;
    measured.value = 2 * m.error;
    return measured;
  };
  const CaseGate gate = on_s(number_at("twice the error", "error", 10, twice), at_most(1));
  EXPECT_EQ(judged(gate, study({{10, finished_run(errors(0.25))}})).measured.value, 0.5);
  EXPECT_EQ(verdict(gate, study({{10, finished_run()}})), Verdict::invalid);
  EXPECT_EQ(verdict(gate, study({{10, stopped_run(7, "energy")}})), Verdict::fail);
}

// Every gate that reads one level, on a study that lacks what it needs.
std::vector<CaseGate> level_gates() {
  return {on_s(error_at("error", 10), at_most(1)), on_s(value_at("error", 10), at_most(1)),
          on_s(ratio_of("error", 10, 20), at_most(1)), on_s(ratio_of("error", 20, 10), at_most(1))};
}

CaseGate stopping(CaseGate gate, StopBand stops) {
  return std::move(gate).fails("it had to", {}).or_stops(std::move(stops));
}

TEST(LevelGates, AreNotJudgedWithoutTheirLevel) {
  for (const CaseGate& gate : level_gates()) {
    EXPECT_TRUE(judge_gates({gate}, study({{40, finished_run(errors(0.5))}})).empty());
  }
}

TEST(LevelGates, WithoutTheirMeasureAreInvalid) {
  for (const CaseGate& gate : level_gates()) {
    EXPECT_EQ(verdict(gate, study({{10, finished_run()}, {20, finished_run()}})), Verdict::invalid);
  }
}

TEST(LevelGates, OfANanAreInvalid) {
  for (const CaseGate& gate : level_gates()) {
    EXPECT_EQ(verdict(gate, study({{10, finished_run(errors(nan))}, {20, finished_run(errors(nan))}})),
              Verdict::invalid);
  }
}

TEST(LevelGates, OfAStoppedRunFailUnlessTheBandNamesTheStop) {
  const StudyResult on = study({{10, stopped_run(77, "energy")}, {20, finished_run(errors(0.5))}});
  for (const CaseGate& gate : level_gates()) EXPECT_EQ(verdict(gate, on), Verdict::fail);
  for (const CaseGate& gate : level_gates()) {
    EXPECT_EQ(verdict(stopping(gate, {70, 80, "energy"}), on), Verdict::xfail);
    EXPECT_EQ(verdict(stopping(gate, {78, 90, "energy"}), on), Verdict::fail);
    EXPECT_EQ(verdict(stopping(gate, {70, 80, "position"}), on), Verdict::fail);
  }
}

// --- orders -----------------------------------------------------------------------------------------------------------

StudyResult power_law(double order, double perturbation = 0) {
  std::vector<std::pair<double, RunResult>> levels;
  std::vector<Level> data;
  int sign = 1;
  for (const double cells : {10, 20, 40, 80, 160}) {
    Level level;
    level.h = 1 / cells;
    level.error = std::pow(level.h, order) * (1 + perturbation * sign);
    sign = -sign;
    data.push_back(level);
    levels.emplace_back(cells, finished_run(errors(level.error)));
  }
  StudyResult made = study(levels);
  made.fits.emplace_back("error", fit_order(data, Weighting::equal));
  return made;
}

TEST(OrderGate, JudgesTheIntervalAndNotTheEstimate) {
  EXPECT_EQ(verdict(on_s(order_of("error"), at_least(0.9)), power_law(1)), Verdict::pass);
  EXPECT_EQ(verdict(on_s(order_of("error"), at_least(1.1)), power_law(1)), Verdict::fail);
  EXPECT_EQ(verdict(on_s(order_of("error"), at_least(0.95)), power_law(1, 0.1)), Verdict::inconclusive);
  const JudgedGate gate = judged(on_s(order_of("error"), at_least(0.9)), power_law(1));
  EXPECT_TRUE(gate.gate.order);
  EXPECT_TRUE(gate.measured.interval);
  EXPECT_EQ(gate.run_ids.size(), 5u);
}

TEST(FittedOrderGate, JudgesTheEstimate) {
  EXPECT_EQ(verdict(on_s(fitted_order_of("error"), at_least(0.95)), power_law(1, 0.1)), Verdict::pass);
  EXPECT_EQ(verdict(on_s(fitted_order_of("error"), at_least(1.05)), power_law(1, 0.1)), Verdict::fail);
}

TEST(OrderGates, NeedEnoughLevels) {
  StudyResult few = power_law(1);
  few.fits[0].second = fit_order(std::vector<Level>{{0.1, 0.1, 0, 0, {}, {}}, {0.05, 0.05, 0, 0, {}, {}}},
                                 Weighting::equal);
  EXPECT_EQ(verdict(on_s(order_of("error"), at_least(0.9)), few), Verdict::inconclusive);
  EXPECT_EQ(verdict(on_s(fitted_order_of("error"), at_least(0.9)), few), Verdict::inconclusive);
}

TEST(OrderGates, WithoutAFitAreInvalid) {
  StudyResult spoilt = power_law(1);
  spoilt.fits[0].second = fit_order(std::vector<Level>{}, Weighting::equal);
  for (const StudyResult& on : {study({{10, finished_run()}}), spoilt}) {
    EXPECT_EQ(verdict(on_s(order_of("error"), at_least(0.9)), on), Verdict::invalid);
    EXPECT_EQ(verdict(on_s(fitted_order_of("error"), at_least(0.9)), on), Verdict::invalid);
  }
}

TEST(OrderGates, OfAStudyWithAStopFailUnlessTheBandNamesIt) {
  StudyResult on = power_law(1);
  on.levels[2].run = stopped_run(77, "energy");
  for (const CaseGate& gate : {on_s(order_of("error"), at_least(0.9)), on_s(fitted_order_of("error"), at_least(0.9))}) {
    EXPECT_EQ(verdict(gate, on), Verdict::fail);
    EXPECT_EQ(verdict(stopping(gate, {70, 80, "energy"}), on), Verdict::xfail);
  }
}

// --- the ledger -------------------------------------------------------------------------------------------------------

TEST(DriftGate, IsTheLargestOfAllLevels) {
  const StudyResult on = study(
      {{1, finished_run({}, {.energy = 1 + 1e-13})}, {2, finished_run({}, {.energy = 1 - 1e-9})}, {3, finished_run()}});
  const JudgedGate gate = judged(on_s(energy_drift(), at_most(1e-12)), on);
  EXPECT_NEAR(*gate.measured.value, 1e-9, 1e-15);
  EXPECT_EQ(gate.judgement.verdict, Verdict::fail);
  EXPECT_EQ(verdict(on_s(energy_drift(), at_most(1e-8)), on), Verdict::pass);
}

TEST(DriftGate, OfANanIsInvalidWhereverItStands) {
  for (int bad = 0; bad < 3; ++bad) {
    StudyResult on = study({{1, finished_run()}, {2, finished_run()}, {3, finished_run()}});
    on.levels[static_cast<std::size_t>(bad)].run.ledger = ledger({.energy = nan});
    EXPECT_EQ(verdict(on_s(energy_drift(), at_most(1)), on), Verdict::invalid) << bad;
  }
}

// --- generic gates ------------------------------------------------------------------------------------------------------

// The generic gates that are not PASS on a study whose second level is `run`, by what follows the study's name.
std::vector<std::string> red(const RunResult& run, Verdict expected = Verdict::fail, bool as_offset = false) {
  StudyResult on = study({{1, finished_run({}, {}, run.dim)},
                          {2, as_offset ? finished_run({}, {}, run.dim) : run},
                          {3, finished_run({}, {}, run.dim)}});
  if (as_offset) on.levels[1].offsets.push_back(run);
  std::vector<std::string> names;
  for (const JudgedGate& gate : judge_gates(generic_gates("s", run.dim), on)) {
    if (gate.judgement.verdict == Verdict::pass) continue;
    EXPECT_EQ(gate.judgement.verdict, expected) << gate.gate.id;
    names.push_back(gate.gate.id.substr(2));
  }
  return names;
}
using Names = std::vector<std::string>;

TEST(GenericGates, AreFourOnALineAndFiveInThePlane) {
  EXPECT_EQ(judge_gates(generic_gates("s", 1), study({{1, finished_run()}})).size(), 4u);
  EXPECT_EQ(judge_gates(generic_gates("s", 2), study({{1, finished_run({}, {}, 2)}})).size(), 5u);
  for (const CaseGate& gate : generic_gates("s", 2)) {
    EXPECT_NO_THROW(validate(gate.gate));
    EXPECT_EQ(gate.gate.origin, Origin::identity);
  }
}

TEST(GenericGates, PassWhereNothingIsWrong) {
  EXPECT_EQ(red(finished_run()), Names{});
  EXPECT_EQ(red(finished_run({}, {}, 2)), Names{});
  // A tenth of the tolerance of 1e-12.
  const double close = 1 + 1e-13;
  const Spoilt rounding{close, close, {close, close, close}, {1e-13, 1e-13, 1e-13}};
  for (const int dim : {2, 3}) EXPECT_EQ(red(finished_run({}, rounding, dim)), Names{});
}

// Ten times the tolerance turns red the gate of that quantity, and that one alone; at an offset as at a level.
TEST(GenericGates, EachFailsWhereItsQuantityIsSpoilt) {
  for (const bool as_offset : {false, true}) {
    for (const int dim : {1, 2, 3}) {
      const auto spoilt = [&](const Spoilt& end) { return red(finished_run({}, end, dim), Verdict::fail, as_offset); };
      EXPECT_EQ(spoilt({.grid_mass = 1 + 1e-11}), Names{"mass"});
      EXPECT_EQ(spoilt({.energy = 1 - 1e-11}), Names{"ledger"});
      EXPECT_EQ(spoilt({.momentum = {1e-11, 0}}), Names{"momentum"});
      EXPECT_EQ(spoilt({.momentum = {0, -1e-11, 0}}), dim >= 2 ? Names{"momentum"} : Names{});
      EXPECT_EQ(spoilt({.momentum = {0, 0, 1e-11}}), dim == 3 ? Names{"momentum"} : Names{});
      for (const std::array<double, 3>& turned :
           {std::array{1 + 1e-11, 1.0, 1.0}, std::array{1.0, 1 - 1e-11, 1.0}, std::array{1.0, 1.0, 1 + 1e-11}}) {
        EXPECT_EQ(spoilt({.angular = turned}), dim >= 2 ? Names{"angular-momentum"} : Names{});
      }
    }
    EXPECT_EQ(red(stopped_run(5, "density"), Verdict::fail, as_offset), Names{"finite"});
  }
}

TEST(GenericGates, ANanIsInvalid) {
  for (const bool as_offset : {false, true}) {
    const auto spoilt = [&](const Spoilt& end) { return red(finished_run({}, end, 2), Verdict::invalid, as_offset); };
    EXPECT_EQ(spoilt({.grid_mass = nan}), Names{"mass"});
    EXPECT_EQ(spoilt({.energy = nan}), Names{"ledger"});
    EXPECT_EQ(spoilt({.momentum = {nan, 0}}), Names{"momentum"});
    EXPECT_EQ(spoilt({.momentum = {0, nan}}), Names{"momentum"});
    EXPECT_EQ(spoilt({.angular = {1, 1, nan}}), Names{"angular-momentum"});
  }
}

// Impulses of walls may be large where the momentum they leave is small; energy has no such allowance.
TEST(GenericGates, BookedImpulseCountsInTheScaleOfMomentum) {
  RunResult run = finished_run({}, {.momentum = {1e-11, 0}});
  Totals totals;
  totals.momentum_scale = 1;
  run.ledger.momentum[0].open(0, 1);
  run.ledger.momentum[0].book(Flow::walls, 100);
  run.ledger.momentum[0].book(Flow::walls, -100);
  run.ledger.momentum[0].close(1e-11, 1);
  EXPECT_EQ(red(run), Names{});
}

// What falls freely is given the same increment in every step, and each addition is rounded alike: errors grow as the steps
// do, not as their root. So the ledger of a long run may be off by a rounding of twice the velocity's a step.
TEST(GenericGates, EqualStepsRoundAlikeAndTheLedgerOfALongRunMayBeOffByAsMuch) {
  const int steps = 20'000;
  const double increment = 9.8 * 5e-6;
  double velocity = 2;
  for (int n = 0; n < steps; ++n) velocity += increment;
  const double exact = std::fma(steps, increment, 2.0), energy = (velocity * velocity) / (exact * exact);
  EXPECT_GT(std::abs(energy - 1), 2e-12);

  RunResult run = finished_run({}, {.energy = energy});
  EXPECT_EQ(red(run), Names{"ledger"}) << "in 10 steps";
  run.steps = steps;
  EXPECT_EQ(red(run), Names{});
  run = finished_run({}, {.energy = 1 + 1e-11});
  run.steps = steps;
  EXPECT_EQ(red(run), Names{"ledger"});
  run = finished_run({}, {.grid_mass = 1 + 1e-11});
  run.steps = 1'000'000;
  EXPECT_EQ(red(run), Names{"mass"}) << "of the last step alone";
}

TEST(GenericGates, SayWhereARunStopped) {
  const auto gates = judge_gates(generic_gates("s", 1), study({{1, stopped_run(5, "density")}}));
  ASSERT_EQ(gates[0].gate.id, "s/finite");
  EXPECT_NE(gates[0].measured.note.find("step 5"), std::string::npos);
  EXPECT_NE(gates[0].measured.note.find("density"), std::string::npos);
}

TEST(GenericGates, OfNothingAreInvalid) {
  const auto gates = judge_gates(generic_gates("s", 1), study({}));
  ASSERT_EQ(gates.size(), 4u);
  for (const JudgedGate& gate : gates) EXPECT_EQ(gate.judgement.verdict, Verdict::invalid) << gate.gate.id;
  EXPECT_EQ(verdict(on_s(energy_drift(), at_most(1)), study({})), Verdict::invalid);
}

// --- judging ----------------------------------------------------------------------------------------------------------

TEST(JudgeGates, AGateThatThrowsIsInvalid) {
  const CaseGate gate = on_s(
      number_of("no number", [](const StudyResult&) -> Measured { throw std::runtime_error("no idea"); }), at_most(1));
  const JudgedGate result = judged(gate, study({{1, finished_run()}}));
  EXPECT_EQ(result.judgement.verdict, Verdict::invalid);
  EXPECT_EQ(result.measured.note, "no idea");
}

TEST(JudgeGates, AGateThatMeasuresNothingIsInvalid) {
  const CaseGate gate = on_s(number_of("nothing", [](const StudyResult&) { return Measured{}; }), at_most(1));
  EXPECT_EQ(verdict(gate, study({{1, finished_run()}})), Verdict::invalid);
}

TEST(JudgeGates, AGateOnAnInfiniteNumberIsNotGreen) {
  const CaseGate gate = on_s(number_of("infinity", [](const StudyResult&) { return Measured::of(infinity); }),
                             at_least(1));
  EXPECT_EQ(verdict(gate, study({{1, finished_run()}})), Verdict::invalid);
}

TEST(JudgeGates, WaitsForTheStudiesThatItComparesWith) {
  const auto others_error = [](const StudyResult& s) {
    return Measured::of(s.sibling("other")->levels.front().run.measures.front().error);
  };
  const CaseGate gate = on_s(number_of("error of the other", others_error), at_most(1)).beside({"other"});
  StudySet set{study({{1, finished_run()}})};
  set[0].siblings = &set;
  EXPECT_TRUE(judge_gates({gate}, set[0]).empty());
  set.push_back(study({{1, finished_run(errors(0.5))}}));
  set[1].plan.id = "other";
  EXPECT_EQ(judged(gate, set[0]).measured.value, 0.5);
}

}  // namespace
}  // namespace plumbline::gates_test
