// What a plan runs, and what is made of the runs: levels, distances between successive steps, fitted orders.
#include "cases/harness/judge/study.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/verify/verification.hpp"
#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::study_test {
namespace {

std::vector<double> values_of(const std::vector<PlannedRun>& planned, const std::string& key) {
  std::vector<double> values;
  for (const PlannedRun& run : planned) values.push_back(run.settings.number(key));
  return values;
}

using Numbers = std::vector<double>;

TEST(PlannedRuns, OfCells) {
  const Case entry = toy_case();
  const StudyPlan plan{
      .id = "s", .title = {}, .why = {}, .overrides = {{"ppc", 2.0}}, .values = {4, 8}, .full_values = {4, 8, 16}};
  const auto quick = planned_runs(entry, plan, Tier::quick), full = planned_runs(entry, plan, Tier::full);
  EXPECT_EQ(values_of(quick, "cells"), (Numbers{4, 8}));
  EXPECT_EQ(values_of(quick, "ppc"), (Numbers{2, 2}));
  EXPECT_EQ(values_of(full, "cells"), (Numbers{4, 8, 16}));
  EXPECT_EQ(quick[1].value, 8);
  EXPECT_FALSE(quick[1].is_offset);
}

TEST(PlannedRuns, TypedSettingsHoldForEveryRun) {
  const Case entry = toy_case();
  const StudyPlan plan{.id = "s", .title = {}, .why = {}, .values = {4, 8}};
  EXPECT_EQ(values_of(planned_runs(entry, plan, Tier::quick, {"weight=3"}), "weight"), (Numbers{3, 3}));
}

TEST(PlannedRuns, OffsetsInTheFullTierOnly) {
  Toy toy;
  toy.kind = Kind::gas;
  const Case entry = toy_case(toy);
  const StudyPlan plan{.id = "s", .title = {}, .why = {}, .values = {4, 8}, .offsets_in_full = true};
  EXPECT_EQ(planned_runs(entry, plan, Tier::quick).size(), 2u);
  const auto full = planned_runs(entry, plan, Tier::full);
  EXPECT_EQ(values_of(full, "offset"), (Numbers{0, 0.25, 0.5, 0.75, 0, 0.25, 0.5, 0.75}));
  EXPECT_EQ(values_of(full, "cells"), (Numbers{4, 4, 4, 4, 8, 8, 8, 8}));
  for (std::size_t k = 0; k < full.size(); ++k) EXPECT_EQ(full[k].is_offset, k % 4 != 0) << k;
}

// The finest level is measured against one more run, with half its step.
TEST(PlannedRuns, OfTheStepHaveOneMore) {
  const Case entry = toy_case();
  const StudyPlan plan{.id = "s", .title = {}, .why = {}, .vary = Vary::dt, .values = {1, 0.5, 0.25}};
  const auto planned = planned_runs(entry, plan, Tier::quick);
  EXPECT_EQ(values_of(planned, "dt"), (Numbers{1e-3, 5e-4, 2.5e-4, 1.25e-4}));
  EXPECT_EQ(planned.back().value, 0.125);
  const auto by_cfl = planned_runs(entry, plan, Tier::quick, {"dt=none", "cfl=0.4"});
  EXPECT_EQ(values_of(by_cfl, "cfl"), (Numbers{0.4, 0.2, 0.1, 0.05}));
  EXPECT_FALSE(by_cfl[0].settings.is_set("dt"));
}

TEST(PlannedRuns, OfPointsAndOffsets) {
  Toy toy;
  toy.kind = Kind::gas;
  const Case entry = toy_case(toy);
  const StudyPlan points{.id = "s", .title = {}, .why = {}, .vary = Vary::ppc, .values = {8, 16}};
  EXPECT_EQ(values_of(planned_runs(entry, points, Tier::quick), "ppc"), (Numbers{8, 16}));
  const StudyPlan offsets{.id = "s", .title = {}, .why = {}, .vary = Vary::offset, .values = {0, 0.5}};
  EXPECT_EQ(values_of(planned_runs(entry, offsets, Tier::quick), "offset"), (Numbers{0, 0.5}));
}

// --- assembling -----------------------------------------------------------------------------------------------------

const Case toy = toy_case();

RunResult made_run(double h, double dt, std::vector<Measure> measures) {
  RunResult run("toy", "default", toy.settings("default", {}));
  run.h = h;
  run.dt = dt;
  run.steps = 10;
  run.finished = true;
  run.measures = std::move(measures);
  return run;
}

StudyResult assembled(Vary vary, const Numbers& values, const std::vector<RunResult>& runs,
                      std::vector<bool> is_offset = {}) {
  StudyPlan plan{.id = "s", .title = {}, .why = {}, .vary = vary, .values = values};
  std::vector<PlannedRun> planned;
  is_offset.resize(values.size(), false);
  for (std::size_t k = 0; k < values.size(); ++k)
    planned.push_back({values[k], toy.settings("default", {}), is_offset[k]});
  return assemble_study(toy, plan, planned, runs);
}

TEST(AssembleStudy, FindsTheOrderAndConstantOfAPowerLaw) {
  Numbers values;
  std::vector<RunResult> runs;
  for (const double cells : {10, 20, 40, 80, 160}) {
    values.push_back(cells);
    runs.push_back(made_run(1 / cells, 1e-3, power_law_error(1 / cells, 3, 1.5)));
  }
  const StudyResult study = assembled(Vary::cells, values, runs);
  ASSERT_EQ(study.levels.size(), 5u);
  EXPECT_DOUBLE_EQ(study.levels[2].h, 1.0 / 40);
  EXPECT_EQ(study.levels[2].value, 40);
  const OrderFit* fit = study.fit("error");
  ASSERT_NE(fit, nullptr);
  EXPECT_TRUE(fit->usable);
  EXPECT_NEAR(fit->order, 1.5, 1e-12);
  EXPECT_NEAR(fit->constant, 3, 1e-11);
  EXPECT_EQ(fit->weighting, Weighting::equal);
  EXPECT_EQ(study.fit("no such"), nullptr);
  EXPECT_EQ(study.level(80), &study.levels[3]);
  EXPECT_EQ(study.level(81), nullptr);
}

// h is the spacing of points in a study of points, the step in a study of the step; an offset has no order.
TEST(AssembleStudy, RefinesWhatThePlanVaries) {
  Numbers values{1, 2, 4, 8, 16};
  std::vector<RunResult> by_points, by_offset;
  for (const double ppc : values) {
    by_points.push_back(made_run(0.1, 1e-3, power_law_error(0.1 / ppc, 1, 2)));
    by_offset.push_back(made_run(0.1, 1e-3, power_law_error(0.1, 1, 2)));
  }
  const StudyResult points = assembled(Vary::ppc, values, by_points);
  EXPECT_DOUBLE_EQ(points.levels[2].h, 0.1 / 4);
  EXPECT_NEAR(points.fit("error")->order, 2, 1e-12);
  EXPECT_TRUE(assembled(Vary::offset, {0, 0.1, 0.2, 0.3, 0.4}, by_offset).fits.empty());
}

TEST(AssembleStudy, OffsetsJoinTheirLevelAndWeightTheFit) {
  Numbers values;
  std::vector<bool> is_offset;
  std::vector<RunResult> runs;
  for (const double cells : {10, 20, 40, 80, 160}) {
    for (const double factor : {1.0, 1.1, 0.9, 1.05}) {
      values.push_back(cells);
      is_offset.push_back(factor != 1.0);
      runs.push_back(made_run(1 / cells, 1e-3, power_law_error(1 / cells, factor, 1)));
    }
  }
  const StudyResult study = assembled(Vary::cells, values, runs, is_offset);
  ASSERT_EQ(study.levels.size(), 5u);
  for (const StudyLevel& at : study.levels) EXPECT_EQ(at.offsets.size(), 3u);
  const OrderFit* fit = study.fit("error");
  ASSERT_NE(fit, nullptr);
  EXPECT_EQ(fit->weighting, Weighting::offsets);
  EXPECT_NEAR(fit->order, 1, 1e-12);
  EXPECT_NEAR(fit->constant, std::pow(1.0 * 1.1 * 0.9 * 1.05, 0.25), 1e-12) << "the mean of ln E over the offsets";
}

TEST(AssembleStudy, ALevelWithoutTheMeasureSpoilsTheFitLoudly) {
  Numbers values;
  std::vector<RunResult> runs;
  for (const double cells : {10, 20, 40, 80, 160, 320}) {
    values.push_back(cells);
    runs.push_back(made_run(1 / cells, 1e-3, cells == 40 ? std::vector<Measure>{} : power_law_error(1 / cells, 3, 1)));
  }
  EXPECT_TRUE(assembled(Vary::cells, values, runs).fit("error")->invalid);
}

// Levels whose error the reference's bound or rounding may have made do not enter.
TEST(AssembleStudy, PassesReferenceBoundAndRoundingOn) {
  Numbers values;
  std::vector<RunResult> runs;
  for (const double cells : {10, 20, 40, 80, 160, 320, 640}) {
    values.push_back(cells);
    runs.push_back(made_run(1 / cells, 1e-3, power_law_error(1 / cells, 3, 1)));
  }
  runs[6].measures[0].reference_bound = 0.06 * runs[6].measures[0].error;
  runs[5].measures[0].scale = 1e15 * runs[5].measures[0].error;  // ten steps of rounding are above a tenth of it
  const OrderFit fit = *assembled(Vary::cells, values, runs).fit("error");
  EXPECT_EQ(fit.used, (std::vector<bool>{true, true, true, true, true, false, false}));
}

// a(dt) = 2 + dt^p at one point of weight 1, and 5 + 2 dt^p at another of weight 3: successive distances, averaged with
// the weights, are 7/4 dt^p (1 - 2^-p).
TEST(AssembleStudy, SuccessiveDistancesFallWithTheOrderOfTheStep) {
  for (const double order : {1.0, 2.0}) {
    Numbers values;
    std::vector<RunResult> runs;
    for (int k = 0; k < 6; ++k) {
      const double dt = 1e-2 * std::pow(0.5, k), e = std::pow(dt, order);
      values.push_back(std::pow(0.5, k));
      RunResult run = made_run(0.1, dt, {scalar_measure("period", 3 + e, 3, 0, "s")});
      run.measures[0].error = 7;  // the mesh's own error, which the step does not change
      run.profile.columns = {{"x", "m", "", {0, 1}},
                             {"mass", "kg", "", {1, 3}},
                             {"a", "Pa", "", {2 + e, 5 + 2 * e}},
                             {"a_reference", "Pa", "", {0, 0}}};
      runs.push_back(run);
    }
    const StudyResult study = assembled(Vary::dt, values, runs);
    ASSERT_EQ(study.levels.size(), 5u) << "the extra run is no level";
    EXPECT_DOUBLE_EQ(study.levels[3].h, 1e-2 / 8);
    const double share = 1 - std::pow(0.5, order);
    const Measure* field = study.levels[0].run.find("a.step");
    const Measure* scalar = study.levels[4].run.find("period.step");
    ASSERT_NE(field, nullptr);
    ASSERT_NE(scalar, nullptr);
    EXPECT_NEAR(field->error, 7.0 / 4 * std::pow(1e-2, order) * share, 1e-15);
    EXPECT_NEAR(field->scale, (2 + std::pow(1e-2, order) + 3 * (5 + 2 * std::pow(1e-2, order))) / 4, 1e-14);
    EXPECT_EQ(field->unit, "Pa");
    EXPECT_NEAR(scalar->error, std::pow(1e-2 / 16, order) * share, 1e-15);
    // ln of distances known to 1e-15 absolute, the least of them 1e-7: slopes to 1e-8.
    EXPECT_NEAR(study.fit("a.step")->order, order, 1e-7);
    EXPECT_NEAR(study.fit("period.step")->order, order, 1e-7);
    EXPECT_EQ(study.levels[0].run.find("x.step"), nullptr) << "no reference, no distance";
  }
}

TEST(AssembleStudy, AStoppedRunHasNoDistance) {
  std::vector<RunResult> runs;
  for (int k = 0; k < 3; ++k) {
    runs.push_back(made_run(0.1, std::pow(0.5, k), {scalar_measure("period", 3, 3, 0, "s")}));
    runs.back().profile.columns = {{"mass", "kg", "", {1}}, {"a", "Pa", "", {2}}, {"a_reference", "Pa", "", {0}}};
  }
  runs[1].profile = {};
  runs[1].measures.clear();
  const StudyResult study = assembled(Vary::dt, {1, 0.5, 0.25}, runs);
  EXPECT_EQ(study.levels[0].run.find("a.step"), nullptr);
  EXPECT_EQ(study.levels[0].run.find("period.step"), nullptr);
}

TEST(AssembleStudy, SiblingsAreFoundByName) {
  StudySet set;
  set.push_back(assembled(Vary::cells, {1}, {made_run(1, 1, {})}));
  set.push_back(set.front());
  set.back().plan.id = "other";
  EXPECT_EQ(set.front().sibling("other"), nullptr);
  set.front().siblings = &set;
  EXPECT_EQ(set.front().sibling("other"), &set.back());
  EXPECT_EQ(set.front().sibling("third"), nullptr);
}

TEST(AssembleStudy, OfNothingIsEmpty) {
  const StudyResult study = assembled(Vary::cells, {}, {});
  EXPECT_TRUE(study.levels.empty());
  EXPECT_TRUE(study.fits.empty());
}

// --- running --------------------------------------------------------------------------------------------------------

// The whole way: a synthetic case of order 2, run and fitted, on one thread and on three.
TEST(RunStudy, OfASyntheticCaseGivesItsOrderOnAnyNumberOfThreads) {
  Toy described;
  described.measures = [](const Settings& s, const Simulation&) {
    return power_law_error(1 / s.number("cells"), 3, 2);
  };
  const Case entry = toy_case(described);
  const StudyPlan plan{.id = "s", .title = {}, .why = {}, .values = {4, 8, 16, 32, 64}};
  const auto planned = planned_runs(entry, plan, Tier::quick);
  std::vector<std::size_t> seen;
  const StudyResult one = run_study(entry, plan, planned, 1,
                                    [&](std::size_t done, std::size_t of, const RunResult& last) {
                                      seen.push_back(done);
                                      EXPECT_EQ(of, 5u);
                                      EXPECT_EQ(last.case_name, "toy");
                                    });
  const StudyResult three = run_study(entry, plan, planned, 3);
  EXPECT_EQ(seen, (std::vector<std::size_t>{1, 2, 3, 4, 5}));
  EXPECT_NEAR(one.fit("error")->order, 2, 1e-12);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(one.levels[k].value, plan.values[k]) << "levels keep the plan's order, whatever ran first";
    EXPECT_EQ(one.levels[k].run.settings.number("cells"), plan.values[k]);
    EXPECT_EQ(one.levels[k].run.ledger.energy.store(), three.levels[k].run.ledger.energy.store());
    EXPECT_EQ(one.levels[k].run.file, three.levels[k].run.file);
    EXPECT_FALSE(one.levels[k].run.file.empty());
  }
}

TEST(RunStudy, NamesTheSchemeAfterTheIntegrator) {
  const Case entry = toy_case();
  const auto scheme_of = [&](const StudyPlan& plan) {
    return run_study(entry, plan, planned_runs(entry, plan, Tier::quick), 1).scheme;
  };
  EXPECT_EQ(scheme_of({.id = "s", .title = {}, .why = {}, .values = {4}}), "default");
  EXPECT_EQ(scheme_of({.id = "s", .title = {}, .why = {}, .overrides = {{"integrator", "usl"}}, .values = {4}}),
            "default+usl");
  EXPECT_EQ(scheme_of({.id = "s", .title = {}, .why = {}, .overrides = {{"integrator", "leapfrog"}}, .values = {4}}),
            "default");
  EXPECT_EQ(scheme_of({.id = "s", .title = {}, .why = {}, .scheme = "york1997", .values = {4}}), "york1997");
}

}  // namespace
}  // namespace plumbline::study_test
