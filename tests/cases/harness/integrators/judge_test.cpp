// Integrators made for this test, right and wrong, and what the gates say of them.
#include "cases/harness/integrators/judge.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/integrators/pairs.hpp"
#include "cases/harness/integrators/scorecard.hpp"
#include "kernel/simulation.hpp"

namespace plumbline::judge_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

// York's step with factors on each of its parts; 1 everywhere is right.
class Scaled : public TimeIntegrator {
 public:
  std::vector<IntegratorParameter> parameters() override {
    return {{"test_strain", &strain, 0, 2, "factor of strains"},
            {"test_force", &force, 0, 2, "factor of forces"},
            {"test_motion", &motion, 0, 2, "factor of motion"}};
  }
  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();
    mpm.map_forces();
    mpm.advance_momentum(force * dt);
    mpm.move_points(motion * dt);
    mpm.map_momentum();
    mpm.update_stress(strain * dt);
  }
  double strain = 1, force = 1, motion = 1;
};
PLUMBLINE_INTEGRATOR(Scaled, "test-scaled", "York's step with factors", "this test");

class Nothing final : public TimeIntegrator {
  void step(Stages&, double) override {}
};
PLUMBLINE_INTEGRATOR(Nothing, "test-nothing", "does nothing", "this test");

// Right, of order four, written against rates alone, without a word of what it needs.
class ThreeEighths final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    const State y = mpm.state(), k1 = mpm.rate();
    mpm.set_state(y + dt / 3 * k1);
    const State k2 = mpm.rate();
    mpm.set_state(y + dt * (k2 + -1.0 / 3 * k1));
    const State k3 = mpm.rate();
    mpm.set_state(y + dt * (k1 + -1.0 * k2 + k3));
    const State k4 = mpm.rate();
    mpm.set_state(y + dt / 8 * (k1 + 3 * k2 + 3 * k3 + k4));
  }
};
PLUMBLINE_INTEGRATOR(ThreeEighths, "test-three-eighths", "Runge-Kutta of order four, 3/8 rule", "Kutta 1901");

class Heun final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    const State y = mpm.state(), k1 = mpm.rate();
    mpm.set_state(y + dt * k1);
    mpm.set_state(y + dt / 2 * (k1 + mpm.rate()));
  }
};
PLUMBLINE_INTEGRATOR(Heun, "test-heun-2", "of order two, grows with dt^4", "Heun 1900");

// Velocities of the step before, which memory() does not name.
class Hidden final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();
    mpm.map_forces();
    mpm.advance_momentum(dt * (1 + (count_++ % 2 == 0 ? 1e-3 : -1e-3)));
    mpm.move_points(dt);
    mpm.map_momentum();
    mpm.update_stress(dt);
  }
  int count_ = 0;
};
PLUMBLINE_INTEGRATOR(Hidden, "test-hidden", "forces change from step to step", "this test");

JudgedIntegrator core(const std::string& name, std::map<std::string, double> parameters = {}) {
  return judge_integrator(Subject({name, std::move(parameters)}), {Effort::core, 1});
}

std::vector<std::string> red_families(const JudgedIntegrator& judged) {
  std::vector<std::string> red;
  for (const JudgedGate& gate : judged.gates) {
    if (is_red(gate)) red.push_back(gate.study);
  }
  return red;
}

TEST(Judge, RightOnesAreGreen) {
  for (const char* name : {"test-scaled", "test-three-eighths", "musl", "leapfrog", "rk4"}) {
    const JudgedIntegrator judged = core(name);
    EXPECT_TRUE(red_families(judged).empty()) << name << ": " << red_families(judged).front();
    EXPECT_EQ(judged.gates.size() + judged.not_applicable.size(), static_cast<std::size_t>(judged.declared)) << name;
  }
}

TEST(Judge, OnePerMilleIsRedByConsistency) {
  for (const char* term : {"test_strain", "test_force", "test_motion"}) {
    for (const double factor : {0.999, 1.001, 0.9}) {
      EXPECT_THAT(red_families(core("test-scaled", {{term, factor}})), Contains("consistency")) << term << factor;
    }
  }
}

TEST(Judge, AStepThatDoesNothing) {
  const JudgedIntegrator judged = core("test-nothing");
  EXPECT_THAT(red_families(judged), Contains("consistency"));
  EXPECT_THAT(red_families(judged), Contains("order"));
  for (const JudgedGate& gate : judged.gates) EXPECT_EQ(gate.explanation.empty(), !is_red(gate)) << gate.gate.id;
}

TEST(Judge, WeakGrowthIsRedByStabilityAlone) {
  const JudgedIntegrator judged = core("test-heun-2");
  EXPECT_THAT(red_families(judged), Contains("stability"));
  EXPECT_THAT(red_families(judged), testing::Not(Contains("consistency")));
  const auto growth = std::find_if(judged.gates.begin(), judged.gates.end(),
                                   [](const JudgedGate& g) { return g.gate.id == "stability/oscillator/growth"; });
  ASSERT_NE(growth, judged.gates.end());
  EXPECT_THAT(growth->measured.note, HasSubstr("power 4.0"));
}

TEST(Judge, EndsAtTheFirstRedGateIfAsked) {
  const Subject subject({"test-nothing", {}});
  const JudgedIntegrator judged = judge_integrator(subject, {Effort::whole, 1, true});
  EXPECT_EQ(judged.gates.size(), 1U);
  EXPECT_GT(judged.declared, 100);
}

TEST(Judge, HiddenStateIsFound) {
  const Subject subject({"test-hidden", {}});
  for (const IntegratorGate& row : integrator_gates(subject, Effort::whole)) {
    if (row.gate.id != "invariance/memory") continue;
    EXPECT_GT(row.measure(subject).value, 1e-8);
    EXPECT_EQ(row.measure(Subject({"musl", {}})).value, 0);
    EXPECT_EQ(row.measure(Subject({"generalized-alpha", {}})).value, 0);
    return;
  }
  FAIL() << "no gate invariance/memory";
}

TEST(Judge, UnknownNamesAreOfferedTheNearest) {
  try {
    Subject({"mussl", {}});
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.nearest, Contains("musl"));
  }
}

// Each id once, each with a reason, a bound and what usually causes a miss.
TEST(IntegratorGates, AreDeclaredInFull) {
  const Subject subject({"usavg", {}});
  std::vector<std::string> ids;
  for (const IntegratorGate& row : integrator_gates(subject, Effort::whole)) {
    EXPECT_NO_THROW(validate(row.gate)) << row.gate.id;
    EXPECT_FALSE(row.explanation.empty()) << row.gate.id;
    EXPECT_THAT(gate_families(), Contains(row.family));
    EXPECT_EQ(row.gate.id.rfind(row.family + "/", 0), 0U) << row.gate.id;
    ids.push_back(row.gate.id);
  }
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
}

// York's step, which claims what its parameters say.
class Claiming final : public Scaled {
 public:
  std::vector<IntegratorParameter> parameters() override {
    return {{"test_claim", &order, 0, 9, "order claimed of h and dt"},
            {"test_known", &known, 0, 1, "1: of a known class"}};
  }
  Claims claims() const override { return {.orders = {{order, known > 0 ? "h and dt" : "anything", "displacement"}}}; }
  double order = 1, known = 1;
};
PLUMBLINE_INTEGRATOR(Claiming, "test-claiming", "York's step with a claim", "this test");

TEST(IntegratorGates, OrdersUnderRefinementAreJudgedAsClaimed) {
  const auto judgement_of = [](double order) {
    const Subject subject({"test-claiming", {{"test_claim", order}}});
    for (const IntegratorGate& row : integrator_gates(subject, Effort::whole)) {
      if (row.gate.id == "order/claimed/mms-bar/displacement") return judge(row.gate, row.measure(subject)).verdict;
    }
    return Verdict::invalid;
  };
  EXPECT_EQ(judgement_of(1), Verdict::pass);
  EXPECT_EQ(judgement_of(5), Verdict::fail);
  const Subject unknown({"test-claiming", {{"test_known", 0}}});
  EXPECT_THROW(integrator_gates(unknown, Effort::whole), UsageError);
}

// The step that it is compared with, brought once more: nothing differs, which is no defect.
class SameAgain final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override { find_integrator("rk4")->make()->step(mpm, dt); }
};
PLUMBLINE_INTEGRATOR(SameAgain, "test-same-again", "rk4 once more", "this test");

TEST(IntegratorGates, TheYardstickItselfIsNotRed) {
  const Subject subject({"test-same-again", {}});
  bool found = false;
  for (const IntegratorGate& row : integrator_gates(subject, Effort::whole)) {
    if (row.gate.id != "order/difference/bar" && row.gate.id != "consistency/difference-bar") continue;
    found = true;
    const Verdict verdict = judge(row.gate, row.measure(subject)).verdict;
    EXPECT_TRUE(verdict == Verdict::pass || verdict == Verdict::inconclusive) << row.gate.id;
  }
  EXPECT_TRUE(found);
}

// No integrator is its own yardstick, and the two differ at a finite step.
TEST(Pairs, YardsticksDiffer) {
  for (const IntegratorEntry& entry : integrators()) {
    const Subject subject({entry.name, {}});
    for (const char* name : {"bar", "plate-filtered", "gas"}) {
      const SmallScene& small = small_scene(name);
      try {
        const Scene scene = workable(small, entry.name);
        EXPECT_NE(yardstick(subject, scene).name, entry.name);
        if (entry.name.rfind("test", 0) == 0) continue;
        const std::vector<double> difference = difference_at(subject, small, 8);
        EXPECT_TRUE(std::any_of(difference.begin(), difference.end(), [](double d) { return d != 0; }))
            << entry.name << ", " << name;
      } catch (const CannotWork&) {
        EXPECT_FALSE(traits_of(entry).needs.empty()) << entry.name << ", " << name;
      }
    }
  }
}

// At the steps taken points stay in their cells: what a step does depends on its size smoothly.
TEST(SmallScenes, PointsMoveByLessThanHalfACell) {
  for (const SmallScene& small : small_scenes()) {
    if (small.name == "gas") continue;
    const std::vector<double> state = state_at_end(small, workable(small, "musl"), {"musl", {}}, 32);
    for (std::size_t k = 0; k < state.size() / 2; ++k) ASSERT_LE(std::abs(state[k]), 0.5) << small.name;
  }
}

TEST(SmallScenes, MirrorsAndExchangesAreUndone) {
  const Scene scene = small_scene("plate").make();
  for (const Scene& twice : {mirrored(mirrored(scene)), with_axes_exchanged(with_axes_exchanged(scene))}) {
    EXPECT_EQ(twice.gravity, scene.gravity);
    EXPECT_EQ(twice.grid.walls, scene.grid.walls);
    const auto a = twice.bodies[0].points.values(column::velocity), b = scene.bodies[0].points.values(column::velocity);
    EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
  }
}

TEST(Scorecard, SaysInOneSentenceWhatWasFound) {
  const Subject subject({"usavg", {}});
  const JudgingOptions how{Effort::core, 1};
  const JudgedIntegrator judged = judge_integrator(subject, how);
  const Json card = scorecard(scorecard_half(subject, judged, how), nullptr, judged);
  EXPECT_EQ(card.at("verdict"), "PASS");
  EXPECT_THAT(
      card.at("sentence").get<std::string>(),
      HasSubstr("usavg: consistent, of order 2 (displacement 2.000, velocity 2.000), stable up to 2.0000/omega"));
  EXPECT_TRUE(card.at("next").is_null());
  EXPECT_EQ(card.at("families").size(), gate_families().size());
}

}  // namespace
}  // namespace plumbline::judge_test
