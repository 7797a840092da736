// Whatever an integrator behind a guard does, it is named.
#include "cases/harness/run/guarded_integrator.hpp"

#include <gmock/gmock.h>

#include <thread>

#include "cases/harness/files/errors.hpp"
#include "kernel/inadmissible.hpp"
#include "kernel/simulation.hpp"
#include "tests/kernel/integrators/recording.hpp"

namespace plumbline::guarded_integrator_test {
namespace {

using testing::HasSubstr;

std::function<void()> act = [] {};  // in a step

class GuardedIntegrator : public testing::Test {
 protected:
  // A registered integrator outlives its test.
  void TearDown() override {
    act = [] {};
  }
};
struct Odd {};

class Acting final : public TimeIntegrator {
 public:
  void step(Stages&, double) override { act(); }
  std::vector<IntegratorParameter> parameters() override { return {{"test_null", pointer, 0, 1, "of nothing"}}; }
  std::vector<State*> memory() override { return {&state, nullptr}; }
  std::vector<double*> kept() override { return {&value, nullptr}; }
  Claims claims() const override { throw Odd(); }
  double value = 0;
  double* pointer = nullptr;
  State state;
};

IntegratorEntry entry_of(const std::string& name) {
  return {name, "acts", "this test", [] { return std::make_unique<Acting>(); },
          [](const TimeIntegrator& now) { return std::make_unique<Acting>(static_cast<const Acting&>(now)); }};
}

// What a step says that throws so.
MisbehavingIntegrator thrown_by(const std::function<void()>& what) {
  act = what;
  const auto integrator = guarded(entry_of("acting")).make();
  RecordingStages stages;
  try {
    integrator->step(stages, 0.5);
  } catch (const MisbehavingIntegrator& error) {
    return error;
  }
  return {"none", "threw nothing", "step", 0, 0};
}

TEST_F(GuardedIntegrator, WhatItThrowsNamesIt) {
  const auto error = thrown_by([] { throw std::runtime_error("boom"); });
  EXPECT_EQ(error.integrator, "acting");
  EXPECT_EQ(error.reason, "integrator acting threw std::exception: boom");
  EXPECT_EQ(error.step, 1);
  EXPECT_STREQ(error.what(), "integrator acting threw std::exception: boom in step 1, t = 0 s");
  EXPECT_THAT(thrown_by([] { throw 7; }).reason, HasSubstr("no std::exception"));
  EXPECT_THAT(thrown_by([] { throw Odd(); }).reason, HasSubstr("no std::exception"));
  EXPECT_THAT(thrown_by([] { throw std::runtime_error("\xff"); }).reason, HasSubstr("\xef\xbf\xbd"));
}

TEST_F(GuardedIntegrator, AStateThatCannotBeIsNoMisbehaviour) {
  EXPECT_THROW(thrown_by([] { throw InadmissibleState("no midpoint", "all", 0, "velocity", 1); }), InadmissibleState);
  EXPECT_THROW(thrown_by([] { throw Interrupted(2); }), Interrupted);
}

TEST_F(GuardedIntegrator, CountsItsStepsAndCopiesTakeThemAlong) {
  const IntegratorEntry entry = guarded(entry_of("acting"));
  const auto first = entry.make();
  RecordingStages stages;
  act = [] {};
  first->step(stages, 0.5);
  first->step(stages, 0.25);
  const auto second = entry.copy(*first);
  act = [] { throw 7; };
  try {
    second->step(stages, 1);
    FAIL();
  } catch (const MisbehavingIntegrator& error) {
    EXPECT_EQ(error.step, 3);
    EXPECT_EQ(error.time, 0.75);
  }
}

// In a run, step and time are the run's: a run that goes on from a checkpoint has others than its integrator.
TEST_F(GuardedIntegrator, InARunTheStepIsTheRuns) {
  class Plain final : public TimeIntegrator {
    void step(Stages&, double) override { act(); }
  };
  RegisterIntegrator(guarded({"test-acting-in-a-run", "acts", "this test", [] { return std::make_unique<Plain>(); },
                              [](const TimeIntegrator&) { return std::make_unique<Plain>(); }}));
  Simulation run(scenes::rough_gas(1, "quadratic", "flip"), "test-acting-in-a-run", {.dt = 1e-3});
  act = [] {};
  run.step(1);
  Checkpoint later = run.save();
  later.step = 41;
  later.time = 3;
  run.restore(later);
  act = [] { throw 7; };
  try {
    run.step(1);
    FAIL();
  } catch (const MisbehavingIntegrator& error) {
    EXPECT_EQ(error.step, 42);
    EXPECT_EQ(error.time, 3);
  }
}

TEST_F(GuardedIntegrator, OtherCallsAreGuardedToo) {
  const auto integrator = guarded(entry_of("acting")).make();
  EXPECT_THROW(integrator->claims(), MisbehavingIntegrator);
  EXPECT_THROW(integrator->parameters(), MisbehavingIntegrator);
  EXPECT_THROW(integrator->memory(), MisbehavingIntegrator);
  EXPECT_THROW(integrator->kept(), MisbehavingIntegrator);
  IntegratorEntry nothing = entry_of("acting");
  nothing.make = [] { return nullptr; };
  nothing.copy = [](const TimeIntegrator&) { return nullptr; };
  EXPECT_THROW(guarded(nothing).make(), MisbehavingIntegrator);
  nothing.make = entry_of("acting").make;
  const IntegratorEntry behind = guarded(nothing);
  EXPECT_THROW(behind.copy(*behind.make()), MisbehavingIntegrator);
}

// All that a run is taken up again by.
TEST_F(GuardedIntegrator, WhatItSaysOfItselfArrives) {
  class Honest final : public TimeIntegrator {
    void step(Stages&, double) override {}
    std::vector<IntegratorParameter> parameters() override { return {{"test_share", &share, 0, 1, "of something"}}; }
    std::vector<State*> memory() override { return {&state}; }
    std::vector<double*> kept() override { return {&number}; }
    Claims claims() const override { return {.reversible = true}; }
    double share = 0.5, number = 7;
    State state{{1, 2, 3}};
  };
  const IntegratorEntry entry = guarded(
      {"honest", "tells", "this test", [] { return std::make_unique<Honest>(); },
       [](const TimeIntegrator& now) { return std::make_unique<Honest>(static_cast<const Honest&>(now)); }});
  const auto first = entry.make();
  *first->kept().front() = 8;
  const auto copy = entry.copy(*first);
  ASSERT_EQ(copy->kept().size(), 1u);
  EXPECT_EQ(*copy->kept().front(), 8);
  ASSERT_EQ(copy->memory().size(), 1u);
  EXPECT_EQ(copy->memory().front()->values, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(copy->parameters().front().name, "test_share");
  EXPECT_TRUE(copy->claims().reversible);
}

TEST_F(GuardedIntegrator, OneThatIsRefusedIsNotCalled) {
  act = [] { FAIL(); };
  const IntegratorEntry entry = guarded(entry_of("acting"), "called exit when it was tried");
  const auto integrator = entry.copy(*entry.make());
  RecordingStages stages;
  EXPECT_THROW(integrator->step(stages, 1), MisbehavingIntegrator);
  EXPECT_TRUE(integrator->parameters().empty() && integrator->memory().empty() && integrator->kept().empty() &&
              integrator->claims().orders.empty());
}

TEST_F(GuardedIntegrator, OthersSeeWhichStepIsUnderWay) {
  std::string seen;
  const auto look = [&] {
    for_calls_under_way(
        [&](const WatchedCall& call) { seen += std::string(call.integrator) + " " + call.call.load(); });
  };
  act = [&] { std::thread(look).join(); };
  thrown_by(act);
  EXPECT_EQ(seen, "acting step");
  look();
  EXPECT_EQ(seen, "acting step") << "none is under way";
}

}  // namespace
}  // namespace plumbline::guarded_integrator_test
