// Stages in any legal order do what each of them is said to do, fused or not: random orders against the step written straight
// from the equations.
#include <functional>

#include "kernel/engine/stage_queue.hpp"
#include "tests/kernel/naive/expect.hpp"
#include "tests/kernel/naive/stages.hpp"
#include "tests/kernel/solids.hpp"

namespace plumbline::orders_test {
namespace {

using scenes::Random;
using Say = std::function<void(Stages&, double dt)>;

// A step of stages drawn at random. Points are located first, but for a drift, and then mapped; forces are mapped right before
// each advance; points are moved or kicked once.
class DrawnStep final : public TimeIntegrator {
 public:
  DrawnStep(unsigned long seed, bool returns_loss) : random_(seed) {
    if (one_of(3) == 0) say_drift();
    say("locate", [](Stages& mpm, double) { mpm.locate_points(); });
    say("map", [](Stages& mpm, double) { mpm.map_mass_and_momentum(); });
    say_some({NodalVelocity::start, NodalVelocity::current}, 2);
    say_advance();
    while (one_of(3) == 0) {
      say_some({NodalVelocity::start, NodalVelocity::end, NodalVelocity::midpoint}, 2);
      say_advance();
    }
    say_some({NodalVelocity::start, NodalVelocity::end, NodalVelocity::midpoint, NodalVelocity::current}, 1);
    const NodalVelocity carrying = one_of(2) ? NodalVelocity::end : NodalVelocity::midpoint;
    if (one_of(2)) {
      say("move " + std::to_string(static_cast<int>(carrying)),
          [carrying](Stages& mpm, double dt) { mpm.move_points(dt, carrying); });
    } else {
      say("kick", [](Stages& mpm, double dt) { mpm.kick_points(dt); });
    }
    // The order that the engine fuses is among those drawn.
    std::vector<NodalVelocity> known{NodalVelocity::start, NodalVelocity::end, NodalVelocity::midpoint};
    if (one_of(2)) {
      strain(1, NodalVelocity::midpoint);
    } else if (one_of(2)) {
      say("map again", [](Stages& mpm, double) { mpm.map_momentum(); });
      known.insert(known.end(), {NodalVelocity::remapped, NodalVelocity::current});
    }
    if (returns_loss) say("return", [](Stages& mpm, double) { mpm.return_transfer_loss(); });
    if (one_of(2)) say_drift();
    say_some(known, 2);
  }

  void step(Stages& mpm, double dt) override {
    for (const Say& stage : said_) stage(mpm, dt);
  }
  const std::string& text() const { return text_; }

 private:
  int one_of(int n) { return static_cast<int>(random_(0, n)); }
  void say(const std::string& name, Say stage) {
    said_.push_back(std::move(stage));
    text_ += name + "; ";
  }
  void say_drift() {
    say("drift", [](Stages& mpm, double dt) { mpm.drift_points(dt / 2); });
  }
  void say_advance() {
    say("forces", [](Stages& mpm, double) { mpm.map_forces(); });
    say("advance", [](Stages& mpm, double dt) { mpm.advance_momentum(dt); });
  }
  void strain(double share, NodalVelocity which) {
    say("strain " + std::to_string(share) + " " + std::to_string(static_cast<int>(which)),
        [share, which](Stages& mpm, double dt) { mpm.strain_points(share * dt, which); });
  }
  // Strains and stresses with some of these velocities.
  void say_some(const std::vector<NodalVelocity>& velocities, int most) {
    for (int k = one_of(most + 1); k > 0; --k) {
      const NodalVelocity which = velocities[static_cast<std::size_t>(one_of(static_cast<int>(velocities.size())))];
      const std::string with = " " + std::to_string(static_cast<int>(which));
      const int stage = one_of(3);
      if (stage == 0) strain(0.5, which);
      if (stage == 1) say("stress" + with, [which](Stages& mpm, double) { mpm.evaluate_stress(which); });
      if (stage == 2) say("predict" + with, [which](Stages& mpm, double dt) { mpm.predict_stress(dt / 2, which); });
    }
  }

  Random random_;
  std::vector<Say> said_;
  std::string text_;
};

void expect_like_naive(const Scene& made, unsigned long seed, bool returns_loss, bool fusing) {
  DrawnStep drawn(seed, returns_loss);
  SCOPED_TRACE(testing::Message() << "seed " << seed << ": " << drawn.text() << (fusing ? "fused" : "one by one"));
  Scene scene = made;
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {.keep_loss = returns_loss});
  engine->initialise();
  ledger.open(engine->totals());
  NaiveStep naive(made);
  NaiveStages naive_stages(naive);
  for (int k = 0; k < 2; ++k) {
    engine->set_time(0.005 * k);
    take_step(drawn, *engine, 0.005, fusing);
    drawn.step(naive_stages, 0.005);
  }
  ledger.close_step(engine->totals());
  expect_points_like_naive(scene, scene.bodies[0], naive);
  expect_flows_like_naive(ledger, naive);
  EXPECT_LE(ledger.energy.relative_drift(false), 1e-13);  // a few hundred roundings
}

class Orders : public testing::TestWithParam<scenes::Space> {};
INSTANTIATE_TEST_SUITE_P(Spaces, Orders, testing::ValuesIn(scenes::spaces), testing::PrintToStringParamName());

TEST_P(Orders, OfAGasAgreeWithTheEquations) {
  for (const char* transfer : {"flip", "pic", "apic"}) {
    for (unsigned long seed = 1; seed <= 12; ++seed) {
      const Scene scene = scenes::rough_gas_in_space(GetParam(), "quadratic", transfer, {}, scenes::rough_law());
      for (const bool fusing : {true, false}) {
        expect_like_naive(scene, seed, transfer != std::string("flip"), fusing);
      }
    }
  }
}

TEST_P(Orders, OfASolidAgreeWithTheEquations) {
  for (const scenes::Law law : scenes::laws) {
    if (scenes::is_chain(law) || !scenes::lives_in(law, GetParam())) continue;
    const Scene scene = scenes::rough_solid(law, scenes::rough_gas_in_space(GetParam(), "quadratic", "apic", {}));
    for (unsigned long seed = 101; seed <= 108; ++seed) {
      for (const bool fusing : {true, false}) expect_like_naive(scene, seed, false, fusing);
    }
  }
}

}  // namespace
}  // namespace plumbline::orders_test
