// The laboratory takes integrators as black boxes: those of this file are found by their names alone, their growth and their limits
// as only their author knows them.
#include "tests/cases/harness/laboratory/made_up_integrators.hpp"

#include <gtest/gtest.h>

#include "cases/harness/laboratory/problem.hpp"
#include "kernel/time_integrator.hpp"
#include "reference/bar_stability.hpp"

namespace plumbline::made_up_integrators_test {
namespace {

class ForwardEuler final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override { mpm.set_state(mpm.state() + dt * mpm.rate()); }
};
PLUMBLINE_INTEGRATOR(ForwardEuler, "test-forward-euler", "unstable at every step", "this test");

class Stiff final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();
    mpm.map_forces();
    mpm.advance_momentum(made_up::stiffer * made_up::stiffer * dt);
    mpm.move_points(dt);
    mpm.map_momentum();
    mpm.update_stress(dt);
  }
};
PLUMBLINE_INTEGRATOR(Stiff, "test-stiff", "limit 2/1.37 of omega dt", "this test");

class ThreeStages final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    const State y = mpm.state();
    mpm.set_state(y + 0.4 * dt * mpm.rate());
    mpm.set_state(y + 0.5 * dt * mpm.rate());
    mpm.set_state(y + dt * mpm.rate());
  }
};
PLUMBLINE_INTEGRATOR(ThreeStages, "test-three-stages", "limit sqrt(15/4) of omega dt", "this test");

struct Known {
  const char* integrator;
  double limit;  // of omega dt
};
const Known known[] = {{made_up::stiff, made_up::stiff_limit}, {made_up::three_stages, made_up::three_stages_limit}};

double observed_limit(const Observation& seen) {
  EXPECT_EQ(seen.brackets.size(), 1U);
  if (seen.brackets.size() != 1) return 0;
  EXPECT_TRUE(seen.brackets[0].stable_below);
  return 0.5 * (seen.brackets[0].low + seen.brackets[0].high);
}

TEST(MadeUpIntegrators, LimitsOnAnOscillator) {
  const StabilityProblem& oscillator = find_stability_problem("oscillator");
  for (const Known& k : known) {
    const Configuration found = examine(
        oscillator, "default", stability_settings(oscillator, "default", {{"integrator", k.integrator}}), true);
    EXPECT_NEAR(found.predicted.limit(), k.limit, 1e-6) << k.integrator;
    EXPECT_EQ(found.predicted.stable.size(), 1U) << k.integrator;
    EXPECT_NEAR(observed_limit(*found.observed), k.limit, 0.01 * k.limit) << k.integrator;
    EXPECT_FALSE(found.closed_form.has_value());
  }
}

// York's limit of stress last belongs to omega dt = 2, so the fastest wave is known.
TEST(MadeUpIntegrators, LimitsOnABar) {
  const StabilityProblem& bar = find_stability_problem("bar");
  for (const double place : {0.5, 0.3}) {
    const double fastest = 2 / reference::frozen_courant_limit(reference::StressUpdate::modified_last, place).value;
    for (const Known& k : known) {
      const Settings settings = stability_settings(bar, "default", {{"integrator", k.integrator}, {"N", place}});
      const double limit = k.limit / fastest;
      const Scan scan{0.8 * limit, 1.3 * limit, 4};
      const Prediction predicted = predict(experiment_of(bar, settings), scan);
      EXPECT_NEAR(predicted.limit(), limit, 1e-6) << k.integrator << " " << place;
      const Observation seen = observe(experiment_of(bar, settings), scan, bar.watch(settings), predicted.reach);
      EXPECT_NEAR(observed_limit(seen), limit, 0.01 * limit) << k.integrator << " " << place;
    }
  }
}

TEST(MadeUpIntegrators, ForwardEulerGrowsAtEveryStepOnAnOscillator) {
  const StabilityProblem& oscillator = find_stability_problem("oscillator");
  const Configuration found = examine(
      oscillator, "default", stability_settings(oscillator, "default", {{"integrator", made_up::forward_euler}}), true);
  EXPECT_TRUE(found.predicted.always_unstable());
  EXPECT_TRUE(found.observed->always_unstable);
  EXPECT_TRUE(found.observed->brackets.empty());
  ASSERT_EQ(found.predicted.growth.size(), found.observed->growth.size());
  for (std::size_t k = 0; k < found.predicted.growth.size(); ++k) {
    const double rate = std::hypot(1, found.predicted.growth[k].dt);
    EXPECT_NEAR(found.predicted.growth[k].per_step, rate, 1e-14 * rate);
    EXPECT_NEAR(found.observed->growth[k].per_step, rate, 1e-12 * rate);  // every state of it grows alike
  }
}

// The eigenvalues of the semi-discrete bar are -+ i sin(theta) at N = 1/2: the fastest wave is a quarter of a turn a cell.
TEST(MadeUpIntegrators, ForwardEulerGrowsAtEveryStepOnABar) {
  const StabilityProblem& bar = find_stability_problem("bar");
  const Settings settings = stability_settings(bar, "default", {{"integrator", made_up::forward_euler}});
  const Scan scan{0.05, 2, 5};
  const Prediction predicted = predict(experiment_of(bar, settings), scan);
  EXPECT_TRUE(predicted.always_unstable());
  for (const Growth& g : predicted.growth) {
    EXPECT_NEAR(g.per_step, std::hypot(1, g.dt), 1e-8);
    EXPECT_NEAR(std::sin(g.theta[0]), 1, 1e-4);
  }
  Watch watch;
  watch.core = 12;
  const Observation seen = observe(experiment_of(bar, settings), scan, watch, predicted.reach);
  EXPECT_TRUE(seen.always_unstable);
  // Runs begin with waves of all lengths: the slower ones still show when the run ends.
  for (const Growth& g : seen.growth) {
    EXPECT_GT(g.per_step, 1 + 0.3 * (std::hypot(1, g.dt) - 1)) << g.dt;
    EXPECT_LT(g.per_step, std::hypot(1, g.dt) * (1 + 1e-6)) << g.dt;
  }
}

}  // namespace
}  // namespace plumbline::made_up_integrators_test
