// The plate, its piston, and what is measured of it.
#include "cases/catalog/solid/elastic_plastic_bar.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "cases/harness/run/experiment.hpp"
#include "kernel/materials/j2_plasticity.hpp"
#include "tests/cases/catalog/solid/ordered_profile.hpp"

namespace plumbline::elastic_plastic_bar_test {
namespace {

RunResult run_with(const std::vector<std::string>& typed) {
  const Case& entry = find_case("elastic-plastic-impact");
  return run_experiment(entry, "default", entry.settings("default", {}, typed));
}
double off(const RunResult& run, const std::string& measure) {
  return run.find(measure)->error / run.find(measure)->scale;
}

TEST(ElasticPlasticBar, PlateAndPistonAreThoseOfTheSettings) {
  const Case& entry = find_case("elastic-plastic-impact");
  const auto problem = entry.problem(
      entry.settings("default", {}, {"cells=20", "rise=0.25", "yield_stress=2", "t_end=0.5"}));
  const Scene scene = problem->scene();
  const auto& material = dynamic_cast<const J2Plasticity&>(*scene.bodies[0].material);
  const double crossing = 1 / std::sqrt(1.2e5);  // M = E (1 - nu)/((1 + nu)(1 - 2 nu)) of E = 1e5, nu = 1/4
  EXPECT_EQ(material.yield_stress, 2);
  EXPECT_EQ(material.viscosity_linear, 0.1);
  EXPECT_EQ(scene.bodies[0].points.points(), 40);
  ASSERT_EQ(scene.pistons.size(), 1U);
  EXPECT_NEAR(scene.pistons[0].rise, 0.25 * crossing, 1e-15);
  EXPECT_EQ(scene.pistons[0].position, 0);
  EXPECT_NEAR(problem->end_time(), 0.5 * crossing, 1e-15);
}

// The measures of plateaus, heat and balances are those of the columns; a piston below the limit makes no plastic strain.
TEST(ElasticPlasticBar, MeasuresAgainstTheReference) {
  const RunResult run = run_with({"cells=60"});
  ASSERT_TRUE(run.finished);
  const reference::ElasticPlasticImpact exact({});
  for (const std::string what : {"stress", "lateral_stress", "plastic_strain"}) {
    EXPECT_LE(off(run, "plateau_" + what), 0.05) << what;
    EXPECT_GT(off(run, "plateau_" + what), 1e-7) << what;
  }
  EXPECT_NEAR(*run.find("plateau_stress")->reference, exact.plateau().stress.value, 1e-12);
  EXPECT_NEAR(*run.find("precursor_stress")->reference, -1.5, 1e-12);
  EXPECT_LE(off(run, "plastic_heat"), 0.05);
  for (const std::string what : {"yield_violation", "heat_off", "energy_off"}) EXPECT_LE(*run.find(what)->value, 1e-12);
  EXPECT_NEAR(run.ledger.stores.internal, *run.find("plastic_heat")->value + run.ledger.viscous,
              1e-12 * run.ledger.stores.internal);
  const RunResult slow = run_with({"cells=60", "velocity=0.003"});
  EXPECT_EQ(*slow.find("plastic_heat")->value, 0);
  EXPECT_EQ(slow.find("plastic_strain.L1")->error, 0);
}

TEST(ElasticPlasticBar, ProfilesAreInTheOrderOfTheParticles) {
  const RunResult run = run_with({"cells=20"});
  expect_ordered_profile(run, 40);
}

}  // namespace
}  // namespace plumbline::elastic_plastic_bar_test
