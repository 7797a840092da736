// One run: what is recorded of it, how it stops, and that a signal ends it.
#include "cases/harness/run/experiment.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <limits>
#include <set>
#include <thread>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/signals.hpp"
#include "tests/cases/harness/toy_case.hpp"

namespace plumbline::experiment_test {
namespace {

RunResult run(const Case& entry, const std::vector<Override>& overrides = {{"cells", 8.0}}) {
  return run_experiment(entry, "default", entry.settings("default", overrides));
}

TEST(Experiment, RunsToItsEndAndSaysWhatItDid) {
  Toy toy;
  toy.measures = [](const Settings&, const Simulation& s) {
    return std::vector{scalar_measure("time", s.time(), 0, 0, "s")};
  };
  toy.profile = [](const Settings&, const Simulation&) {
    Profile profile;
    profile.columns = {{"x", "m", "position", {1}}};
    return profile;
  };
  long observed = 0;
  toy.observe = [&](const Simulation&) { ++observed; };
  const RunResult result = run(toy_case(toy));
  EXPECT_TRUE(result.finished);
  EXPECT_FALSE(result.stop);
  EXPECT_EQ(result.case_name, "toy");
  EXPECT_EQ(result.scheme, "default");
  EXPECT_EQ(result.steps, 10);
  EXPECT_EQ(observed, 10);
  EXPECT_EQ(result.points, 3);
  EXPECT_EQ(result.dim, 1);
  EXPECT_DOUBLE_EQ(result.h, 1.0 / 8);
  EXPECT_NEAR(result.dt, 1e-3, 1e-15);
  EXPECT_EQ(result.end_time, 1e-2);
  EXPECT_GT(result.doubles_per_point, 0);
  ASSERT_NE(result.find("time"), nullptr);
  EXPECT_NEAR(*result.find("time")->value, 1e-2, 1e-16);
  EXPECT_EQ(result.find("no such"), nullptr);
  EXPECT_EQ(result.profile.columns.size(), 1u);
  EXPECT_GT(result.ledger.energy.initial(), 0);
}

// The energy-conserving step with a force that is forgotten: the gas heats without end, and steps become ever shorter.
class Heating final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();
    mpm.evaluate_stress(NodalVelocity::start);
    mpm.map_forces();
    mpm.advance_momentum(dt);
    if (mpm.reverse_cooling()) mpm.advance_momentum(dt);
    mpm.move_points(dt);
    mpm.strain_points(dt, NodalVelocity::midpoint);
    mpm.return_transfer_loss();
  }
};
PLUMBLINE_INTEGRATOR(Heating, "test-heating", "forgets a force", "this test");

TEST(Experiment, ARunWhoseStepsBecomeTooShortEnds) {
  const Case& sod = find_case("sod");
  const RunResult result = run_experiment(
      sod, "default",
      sod.settings("default", {{"cells", 20.0}, {"sharpening", 0.0}, {"integrator", std::string("test-heating")}}));
  ASSERT_TRUE(result.stop);
  EXPECT_EQ(result.stop->field, "dt");
  EXPECT_GT(result.stop->value, 0);
  EXPECT_EQ(result.stop->step, result.steps);
  EXPECT_LT(result.steps, 100000);
  EXPECT_LT(result.stop->time, result.end_time);
}

TEST(Experiment, TakesTheStepFromTheSettings) {
  const Case entry = toy_case();
  const auto control = [&](const std::vector<std::string>& typed) {
    return step_control(entry.settings("default", {}, typed));
  };
  EXPECT_EQ(control({}).dt, 1e-3);
  EXPECT_FALSE(control({"dt=none", "cfl=0.25"}).dt);
  EXPECT_EQ(control({"dt=none", "cfl=0.25"}).cfl, 0.25);
  EXPECT_THROW(control({"dt=none", "cfl=none"}), UsageError);
}

// Only stepping counts: neither making the scene nor measuring.
TEST(Experiment, WallTimeIsThatOfStepping) {
  Toy toy;
  const auto pause = [] { std::this_thread::sleep_for(std::chrono::milliseconds(60)); };
  toy.measures = [&](const Settings&, const Simulation&) {
    pause();
    return std::vector<Measure>{};
  };
  toy.change = [&](Scene&) { pause(); };
  const RunResult result = run(toy_case(toy));
  EXPECT_GT(result.wall_s, 0);
  EXPECT_LT(result.wall_s, 0.05);
  EXPECT_DOUBLE_EQ(result.particle_steps_per_s(), 30 / result.wall_s);
}

TEST(Experiment, AStopIsRecordedWithStepPointAndField) {
  Toy toy;
  toy.end = 1;
  toy.change = [](Scene& scene) {  // the last point, at 0.6, leaves a grid of length 1 in the 41st step
    scene.bodies[0].points(column::velocity)[0] = scene.bodies[0].points(column::velocity)[1] = 0;
    scene.bodies[0].points(column::velocity)[2] = 10;
  };
  toy.measures = [](const Settings&, const Simulation&) { return std::vector{scalar_measure("time", 1, 0, 0, "s")}; };
  const RunResult result = run(toy_case(toy), {{"cells", 50.0}});
  EXPECT_FALSE(result.finished);
  ASSERT_TRUE(result.stop);
  EXPECT_EQ(result.stop->step, 41);
  EXPECT_NEAR(result.stop->time, 0.040, 1e-12);
  EXPECT_EQ(result.stop->point, 2);
  EXPECT_EQ(result.stop->field, "position");
  EXPECT_EQ(result.stop->body, "toy");
  EXPECT_GT(result.stop->value, 1);
  EXPECT_FALSE(result.stop->reason.empty());
  EXPECT_TRUE(result.measures.empty());
  EXPECT_TRUE(result.profile.columns.empty());
  EXPECT_EQ(result.history.step.back(), 40) << "the ledger up to the stop is kept";
}

TEST(Experiment, ANanStopsTheRunAtOnce) {
  Toy toy;
  toy.change = [](Scene& scene) {
    scene.bodies[0].points(column::velocity)[1] = std::numeric_limits<double>::quiet_NaN();
  };
  const RunResult result = run(toy_case(toy));
  ASSERT_TRUE(result.stop);
  EXPECT_EQ(result.stop->step, 1);
  EXPECT_FALSE(result.finished);
}

TEST(Experiment, AnInadmissibleStartIsAStopToo) {
  Toy toy;
  toy.change = [](Scene& scene) { scene.bodies[0].points(column::position)[1] = -0.5; };
  const RunResult result = run(toy_case(toy));
  ASSERT_TRUE(result.stop);
  EXPECT_EQ(result.stop->field, "position");
  EXPECT_FALSE(result.finished);
}

// --- the ledger's history -----------------------------------------------------------------------------------------

const std::vector<double>& series(const LedgerHistory& history, const std::string& quantity,
                                  const std::string& column) {
  for (const auto& one : history.series) {
    if (one.quantity == quantity && one.column == column) return one.values;
  }
  throw std::out_of_range(quantity + "/" + column);
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

class History : public ::testing::TestWithParam<int> {};
// Below, at and above the numbers of steps where rows are thinned out; odd ones end between two kept rows.
INSTANTIATE_TEST_SUITE_P(Steps, History,
                         ::testing::Values(1, 7, 1997, 1998, 1999, 2000, 2001, 3001, 3997, 3999, 4001, 8003, 9999));

TEST_P(History, IsEvenlySpacedAndHoldsTheExtremeAndTheLastRow) {
  Toy toy;
  toy.dt = 1e-5;
  toy.end = 1e-5 * GetParam();
  const RunResult result = run(toy_case(toy));
  ASSERT_EQ(result.steps, GetParam());
  const LedgerHistory& history = result.history;
  ASSERT_FALSE(history.step.empty());
  EXPECT_LE(history.step.size(), 2000u);
  EXPECT_GE(history.step.size(), std::min<std::size_t>(900, static_cast<std::size_t>(GetParam())));
  EXPECT_EQ(history.step.back(), GetParam());
  EXPECT_NEAR(history.time.back(), toy.end, 1e-12 * toy.end);
  EXPECT_TRUE(std::is_sorted(history.step.begin(), history.step.end()));
  EXPECT_EQ(std::set<double>(history.step.begin(), history.step.end()).size(), history.step.size()) << "a row twice";
  const double stride = history.step.front();
  int uneven = 0;
  for (const double step : history.step) uneven += std::fmod(step, stride) != 0;
  EXPECT_LE(uneven, 2) << "only the last and the extreme row stand between the even ones";
  EXPECT_EQ(largest(series(history, "energy", "residual")), std::abs(result.ledger.energy.largest_residual()));
  for (const auto& one : history.series) EXPECT_EQ(one.values.size(), history.step.size());
}

TEST(Experiment, HistoryOfALine) {
  const LedgerHistory history = run(toy_case()).history;
  std::set<std::string> quantities;
  for (const auto& one : history.series) quantities.insert(one.quantity);
  EXPECT_EQ(quantities, (std::set<std::string>{"mass", "momentum_x", "energy"}));
  for (const char* column : {"store", "walls", "body_force", "contact", "transfer", "constitutive", "integration",
                             "released", "residual", "kinetic", "internal", "elastic", "viscous"}) {
    EXPECT_EQ(series(history, "energy", column).size(), 10u) << column;
  }
}

TEST(Experiment, HistoryOfAPlaneHasAngularMomentum) {
  Toy toy;
  toy.dim = 2;
  const LedgerHistory history = run(toy_case(toy)).history;
  EXPECT_EQ(series(history, "momentum_y", "store").size(), 10u);
  EXPECT_EQ(series(history, "angular_momentum", "residual").size(), 10u);
}

// The rows are the ledger's own numbers: store and stores agree, and identity holds in each row.
TEST(Experiment, RowsOfTheHistoryAreTheLedgersNumbers) {
  const RunResult result = run(toy_case());
  const LedgerHistory& history = result.history;
  for (std::size_t k = 0; k < history.step.size(); ++k) {
    const double store = series(history, "energy", "store")[k];
    const double sum = series(history, "energy", "kinetic")[k] + series(history, "energy", "internal")[k] +
                       series(history, "energy", "elastic")[k];
    EXPECT_DOUBLE_EQ(store, sum);
    EXPECT_DOUBLE_EQ(history.time[k], 1e-3 * history.step[k]);
  }
  EXPECT_EQ(series(history, "energy", "store").back(), result.ledger.energy.store());
  EXPECT_EQ(series(history, "energy", "transfer").back(), result.ledger.energy.flow(Flow::transfer));
  EXPECT_EQ(series(history, "energy", "integration").back(), result.ledger.energy.flow(Flow::integration));
}

// --- signals, each in a process of its own --------------------------------------------------------------------------

int status_after(int signal_number) {
  Toy toy;
  toy.observe = [=](const Simulation& simulation) {
    if (simulation.steps() == 4) std::raise(signal_number);
    if (simulation.steps() > 4) std::_Exit(77);
  };
  end_runs_on_signals();
  try {
    run(toy_case(toy));
  } catch (const Interrupted& error) {
    return error.signal;
  }
  return 78;
}

TEST(ExperimentDeathTest, ASignalEndsTheRunAtItsNextStep) {
  EXPECT_EXIT(std::_Exit(status_after(SIGTERM)), ::testing::ExitedWithCode(SIGTERM), "");
  EXPECT_EXIT(std::_Exit(status_after(SIGINT)), ::testing::ExitedWithCode(SIGINT), "");
}

TEST(ExperimentDeathTest, WithoutASignalNothingIsInterrupted) { EXPECT_NO_THROW(throw_if_interrupted()); }

}  // namespace
}  // namespace plumbline::experiment_test
