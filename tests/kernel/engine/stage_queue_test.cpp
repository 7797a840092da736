#include "kernel/engine/stage_queue.hpp"

#include <gmock/gmock.h>

#include <functional>

#include "kernel/integrator_traits.hpp"
#include "kernel/simulation.hpp"
#include "tests/kernel/coupled_scenes.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline {
namespace {

using testing::ElementsAre;
using Said = std::vector<std::string>;

// Notes what it is asked to do, fused or not, and does nothing.
class Notes final : public Engine {
 public:
  Said said;
  void locate_points() override { said.push_back("locate"); }
  void map_mass_and_momentum() override { said.push_back("map mass"); }
  void map_forces() override { said.push_back("map forces"); }
  void advance_momentum(double) override { said.push_back("advance"); }
  void move_points(double, NodalVelocity) override { said.push_back("move"); }
  void drift_points(double) override { said.push_back("drift"); }
  void kick_points(double) override { said.push_back("kick"); }
  void map_momentum() override { said.push_back("map again"); }
  void strain_points(double, NodalVelocity) override { said.push_back("strain"); }
  void evaluate_stress(NodalVelocity) override { said.push_back("stress"); }
  void predict_stress(double, NodalVelocity) override { said.push_back("predict"); }
  bool reverse_cooling() override {
    said.push_back("reverse");
    return false;
  }
  void return_transfer_loss() override { said.push_back("return"); }
  void predict_stress_and_map_forces(double) override { said.push_back("predict+map"); }
  void move_and_heat_points(double) override { said.push_back("move+strain+return"); }
  void kick_heat_and_drift_points(double, double) override { said.push_back("kick+strain+return+drift"); }
  State state() const override { return {}; }
  void set_state(const State&) override { said.push_back("set state"); }
  State rate() override { return {}; }
  State velocities_of(State state) const override { return state; }
  void initialise() override {}
  Totals totals() const override { return {}; }
  void refresh_density() override {}
  void check() const override {}
  double step_limit() const override { return 1; }
  void set_time(double) override {}
  void points_changed(double) override {}
  void points_added() override {}
};

// What an engine is asked to do by a step.
Said asked(const std::function<void(Stages&)>& step, bool fusing = true) {
  Notes notes;
  StageQueue stages(notes, fusing);
  step(stages);
  stages.end_step();
  return notes.said;
}

constexpr auto midpoint = NodalVelocity::midpoint;

TEST(StageQueue, FusesWhatTheTableHolds) {
  EXPECT_THAT(asked([](Stages& mpm) {
                mpm.predict_stress(0.5);
                mpm.map_forces();
                mpm.advance_momentum(1);
                mpm.kick_points(1);
                mpm.strain_points(1, midpoint);
                mpm.return_transfer_loss();
                mpm.drift_points(0.5);
              }),
              ElementsAre("predict+map", "advance", "kick+strain+return+drift"));
  EXPECT_THAT(asked([](Stages& mpm) {
                mpm.move_points(1);
                mpm.strain_points(1, midpoint);
                mpm.return_transfer_loss();
                mpm.locate_points();
              }),
              ElementsAre("move+strain+return", "locate"));
}

TEST(StageQueue, FusesNothingWhereItIsToldNotTo) {
  EXPECT_THAT(asked(
                  [](Stages& mpm) {
                    mpm.predict_stress(0.5);
                    mpm.map_forces();
                  },
                  false),
              ElementsAre("predict", "map forces"));
}

// Another velocity, another time, another order, or a stage that wants the weights afterwards.
TEST(StageQueue, KeepsTheOrderOfWhatItDoesNotFuse) {
  EXPECT_THAT(asked([](Stages& mpm) {
                mpm.predict_stress(0.5, midpoint);
                mpm.map_forces();
              }),
              ElementsAre("predict", "map forces"));
  EXPECT_THAT(asked([](Stages& mpm) {
                mpm.move_points(1, midpoint);
                mpm.strain_points(1, midpoint);
                mpm.return_transfer_loss();
              }),
              ElementsAre("move", "strain", "return"));
  EXPECT_THAT(asked([](Stages& mpm) {
                mpm.kick_points(1);
                mpm.strain_points(0.5, midpoint);
                mpm.return_transfer_loss();
                mpm.drift_points(0.5);
              }),
              ElementsAre("kick", "strain", "return", "drift"));
  EXPECT_THAT(asked([](Stages& mpm) {
                mpm.kick_points(1);
                mpm.kick_points(1);
                mpm.strain_points(1, midpoint);
                mpm.return_transfer_loss();
                mpm.drift_points(0.5);
              }),
              ElementsAre("kick", "kick+strain+return+drift"));
  EXPECT_THAT(asked([](Stages& mpm) {
                mpm.move_points(1);
                mpm.strain_points(1, midpoint);
                mpm.return_transfer_loss();
                mpm.map_momentum();
              }),
              ElementsAre("move", "strain", "return", "map again"));
  EXPECT_THAT(asked([](Stages& mpm) {
                mpm.predict_stress(0.5);
                mpm.set_state(mpm.state());
                mpm.map_forces();
              }),
              ElementsAre("predict", "set state", "map forces"));
}

// --- the same numbers, fused or not -----------------------------------------------------------------------------------

// Positions, velocities and energies of all points, and the ledger's residuals, after a few steps.
std::vector<double> after_steps(const Scene& scene, const std::string& integrator, bool fusing) {
  StepControl control;
  control.fusing = fusing;
  Simulation run(scene, integrator, control);
  for (int k = 0; k < 5; ++k) run.step(1);
  std::vector<double> values;
  for (const Body& body : run.scene().bodies) {
    for (const ColumnId* id : {&column::position, &column::velocity, &column::energy}) {
      if (!body.points.has(*id)) continue;
      const auto column = body.points.values(*id);
      values.insert(values.end(), column.begin(), column.end());
    }
  }
  return values;
}

void expect_same(const Scene& scene, const std::string& integrator) {
  const auto fused = after_steps(scene, integrator, true), apart = after_steps(scene, integrator, false);
  ASSERT_EQ(fused.size(), apart.size());
  for (std::size_t k = 0; k < fused.size(); ++k) {
    EXPECT_NEAR(fused[k], apart[k], 1e-12 * (1 + std::abs(apart[k]))) << integrator << ", " << k;
  }
}

// Five steps of sums of some dozen terms: a few hundred roundings of 1e-16.
TEST(StageQueue, FusedStagesGiveTheNumbersOfTheirParts) {
  for (const char* integrator : {"leapfrog", "energy"}) {
    for (const int dim : {1, 2}) {
      Scene scene = scenes::rough_gas(dim, "quadratic", "apic");
      expect_same(scene, integrator);
      scene.heat_exchange = 0.5;
      expect_same(scene, integrator);
    }
  }
}

}  // namespace
}  // namespace plumbline
