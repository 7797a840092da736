#include "kernel/engine/stage_queue.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <map>

#include "kernel/integrator_traits.hpp"
#include "kernel/simulation.hpp"
#include "tests/kernel/coupled_scenes.hpp"
#include "tests/kernel/solids.hpp"

namespace plumbline::stage_queue_test {
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
  void finish_points(double, std::optional<double> drift) override {
    said.push_back(drift ? "kick+drift+strain+return" : "move+strain+return");
  }
  State state() const override { return {}; }
  void set_state(const State&) override { said.push_back("set state"); }
  State rate() override { return {}; }
  State velocities_of(State state) const override { return state; }
  void initialise() override {}
  const Survey& survey() const override { return survey_; }
  void set_time(double) override {}
  void points_changed(std::optional<double>) override {}

 private:
  Survey survey_;
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
                mpm.drift_points(0.5);
                mpm.strain_points(1, midpoint);
                mpm.return_transfer_loss();
              }),
              ElementsAre("predict+map", "advance", "kick+drift+strain+return"));
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
                mpm.drift_points(0.5);
                mpm.strain_points(0.5, midpoint);
                mpm.return_transfer_loss();
              }),
              ElementsAre("kick", "drift", "strain", "return"));
  EXPECT_THAT(asked([](Stages& mpm) {
                mpm.kick_points(1);
                mpm.strain_points(1, midpoint);
                mpm.return_transfer_loss();
                mpm.drift_points(0.5);
              }),
              ElementsAre("kick", "strain", "return", "drift"));
  EXPECT_THAT(asked([](Stages& mpm) {
                mpm.kick_points(1);
                mpm.kick_points(1);
                mpm.drift_points(0.5);
                mpm.strain_points(1, midpoint);
                mpm.return_transfer_loss();
              }),
              ElementsAre("kick", "kick+drift+strain+return"));
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

// Positions, velocities, energies and strains of all points, and the ledger's flows of energy, after a few steps.
std::vector<double> after_steps(const Scene& scene, const std::string& integrator, bool fusing) {
  StepControl control;
  control.fusing = fusing;
  Simulation run(scene, integrator, control);
  for (int k = 0; k < 5; ++k) run.step(1);
  std::vector<double> values;
  for (const Body& body : run.scene().bodies) {
    for (const ColumnId* id : {&column::position, &column::velocity, &column::energy, &column::strain}) {
      if (!body.points.has(*id)) continue;
      const auto column = body.points.values(*id);
      values.insert(values.end(), column.begin(), column.end());
    }
  }
  const Account& energy = run.ledger().energy;
  for (int flow = 0; flow < flow_count; ++flow) values.push_back(energy.flow(static_cast<Flow>(flow)) / energy.scale());
  return values;
}

// Five steps of sums of some dozen terms: a few hundred roundings of 1e-16.
void expect_same(const Scene& scene, const std::string& integrator) {
  const auto fused = after_steps(scene, integrator, true), apart = after_steps(scene, integrator, false);
  ASSERT_EQ(fused.size(), apart.size());
  for (std::size_t k = 0; k < fused.size(); ++k) {
    ASSERT_NEAR(fused[k], apart[k], 1e-12 * (1 + std::abs(apart[k]))) << integrator << ", " << k;
  }
}

// What each pass of the table is called by an engine that notes it, and the integrator whose step says its stages.
const std::map<std::string, std::pair<std::string, std::string>> said_by{
    {"predict stress, map forces", {"predict+map", "leapfrog"}},
    {"move, strain, heat", {"move+strain+return", "energy"}},
    {"kick, drift, strain, heat", {"kick+drift+strain+return", "leapfrog"}}};

TEST(StageQueue, EveryFusionOfTheTableIsSaidByAnIntegratorBelow) {
  ASSERT_EQ(fusions().size(), said_by.size());
  for (const Fusion& fusion : fusions()) {
    ASSERT_TRUE(said_by.count(fusion.name)) << fusion.name;
    const auto& [noted, integrator] = said_by.at(fusion.name);
    const auto made = find_integrator(integrator)->make();
    EXPECT_THAT(asked([&](Stages& mpm) { made->step(mpm, 1); }), testing::Contains(noted)) << fusion.name;
  }
}

class Fused : public testing::TestWithParam<scenes::Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Fused, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

TEST_P(Fused, StagesOfAGasGiveTheNumbersOfTheirParts) {
  for (const char* integrator : {"leapfrog", "energy"}) {
    Scene scene = scenes::rough_gas(GetParam(), "quadratic", "apic");
    expect_same(scene, integrator);
    scene.heat_exchange = 0.5;
    scene.sharpening = 1;
    expect_same(scene, integrator);
  }
}

TEST_P(Fused, StagesOfSolidsGiveTheNumbersOfTheirParts) {
  for (const char* integrator : {"leapfrog", "energy"}) {
    for (const scenes::Law law : scenes::laws) {
      if (!scenes::lives_in(law, GetParam())) continue;
      Scene scene = scenes::rough_solid(law, scenes::rough_gas_in_space(GetParam(), "quadratic", "apic"));
      expect_same(scene, integrator);
      scenes::let_hardly_compress(scene);
      expect_same(scene, integrator);
    }
  }
}

// Chains, whose points all move before any looks at its neighbours, and losses that others give to the gas.
TEST_P(Fused, StagesOfGasWithAMembraneGiveTheNumbersOfTheirParts) {
  for (const char* integrator : {"leapfrog", "energy"}) {
    for (const scenes::Skin skin : scenes::skins) {
      if (!scenes::lives_in(skin, GetParam())) continue;
      SCOPED_TRACE(skin);
      Scene scene = scenes::gas_and_skin(skin, GetParam(), "quadratic", "apic", true);
      scene.loss_to_gas = true;
      scene.chain_relaxation = 0.5;
      scene.strain_smoothing = 0.2;
      expect_same(scene, integrator);
    }
  }
}

// Nothing waits where a process wants the single stages.
TEST(StageQueue, TheProcessMayWantSingleStages) {
  EXPECT_TRUE(StepControl().fusing);
  fuses_stages() = false;
  EXPECT_FALSE(StepControl().fusing);
  fuses_stages() = true;
}

}  // namespace
}  // namespace plumbline::stage_queue_test
