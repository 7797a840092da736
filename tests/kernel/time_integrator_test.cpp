#include "kernel/time_integrator.hpp"
#include "kernel/choice.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/kernel/integrators/recording.hpp"

namespace plumbline::time_integrator_test {
namespace {

// A user's own integrator: this registration is all it takes to be found by its name.
class SecondMap final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    mpm.locate_points();
    mpm.map_mass_and_momentum();
    mpm.update_stress(dt / 2, NodalVelocity::start);
    mpm.map_forces();
    mpm.advance_momentum(dt);
    mpm.move_points(dt);
    mpm.map_mass_and_momentum();  // the whole map again, in place of map_momentum()
    mpm.update_stress(dt / 2, NodalVelocity::start);
  }
};
PLUMBLINE_INTEGRATOR(SecondMap, "test_second_map", "usavg with the whole map repeated", "this test");

TEST(TimeIntegrator, TheKernelsOwnAreRegistered) {
  for (const char* name : {"usf", "usl", "musl", "usavg", "energy", "midpoint", "leapfrog", "central-difference",
                           "ssp-rk3", "rk4", "generalized-alpha", "implicit-midpoint"}) {
    const IntegratorEntry* entry = find_integrator(name);
    ASSERT_NE(entry, nullptr) << name;
    EXPECT_FALSE(entry->title.empty());
    EXPECT_FALSE(entry->source.empty());
    EXPECT_NE(entry->make(), nullptr);
  }
  EXPECT_EQ(find_integrator("no such"), nullptr);
}

TEST(TimeIntegrator, OneRegisteredHereIsFoundByName) {
  const IntegratorEntry* entry = find_integrator("test_second_map");
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->title, "usavg with the whole map repeated");
}

// Stages may be called more than once a step: each takes what the latest calls left, nothing remembered from
// before.
TEST(TimeIntegrator, TheWholeMapRepeatedIsTheMapOfMomentum) {
  Simulation usual(scenes::rough_gas(2, "quadratic", "flip"), "usavg", {0.2, {}});
  Simulation repeated(scenes::rough_gas(2, "quadratic", "flip"), "test_second_map", {0.2, {}});
  for (int k = 0; k < 5; ++k) {
    usual.step(1);
    repeated.step(1);
  }
  EXPECT_TRUE(scenes::same_bits(usual.scene().bodies[0], repeated.scene().bodies[0]));
}

TEST(TimeIntegrator, AreListedInTheOrderOfTheirNames) {
  const auto& all = integrators();
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; }));
}

// A user's own with a number to choose and something to remember.
class Remembering final : public TimeIntegrator {
 public:
  std::vector<IntegratorParameter> parameters() override { return {{"test_share", &share, 0, 1, "of nothing"}}; }
  std::vector<State*> memory() override { return {&kept}; }
  void step(Stages&, double dt) override { kept.values.push_back(share * dt); }
  double share = 0.25;
  State kept;
};
PLUMBLINE_INTEGRATOR(Remembering, "test_remembering", "does nothing but remember", "this test");

TEST(TimeIntegrator, ParametersAreSetByName) {
  Remembering integrator;
  set_parameters(integrator, {{"share", 0.75}, {"rho_b", 7}});  // of others
  EXPECT_EQ(integrator.share, 0.25);
  set_parameters(integrator, {{"test_share", 1}});
  EXPECT_EQ(integrator.share, 1);
  for (const double bad : {-0.1, 1.1, std::nan("")}) {
    EXPECT_THROW(set_parameters(integrator, {{"test_share", bad}}), std::invalid_argument) << bad;
    EXPECT_EQ(integrator.share, 1);
  }
}

TEST(TimeIntegrator, AParameterOfARunReachesIt) {
  const auto velocities = [](double rho_b) {
    StepControl control;
    control.cfl = 0.2;
    control.parameters["rho_b"] = rho_b;
    Simulation run(scenes::rough_gas(1, "quadratic", "flip"), "generalized-alpha", control);
    for (int k = 0; k < 3; ++k) run.step(1);
    return scenes::by_id(run.scene().bodies[0], column::velocity);
  };
  EXPECT_NE(velocities(0), velocities(0.8));
  EXPECT_THROW(velocities(1.5), std::invalid_argument);
  Simulation untold(scenes::rough_gas(1, "quadratic", "flip"), "generalized-alpha", {0.2, {}});
  for (int k = 0; k < 3; ++k) untold.step(1);
  EXPECT_EQ(scenes::by_id(untold.scene().bodies[0], column::velocity), velocities(0.8));
}

// As it is now, and from then on for itself.
TEST(TimeIntegrator, ACopyRemembersWhatItsOriginalDid) {
  const IntegratorEntry* entry = find_integrator("test_remembering");
  ASSERT_TRUE(entry->copy);
  const auto original = entry->make();
  set_parameters(*original, {{"test_share", 0.5}});
  RecordingStages stages;
  original->step(stages, 4);
  const auto copy = entry->copy(*original);
  original->step(stages, 6);
  EXPECT_EQ(copy->memory().at(0)->values, (std::vector<double>{2}));
  copy->step(stages, 2);
  EXPECT_EQ(copy->memory().at(0)->values, (std::vector<double>{2, 1}));
  EXPECT_EQ(original->memory().at(0)->values, (std::vector<double>{2, 3}));
  EXPECT_TRUE(find_integrator("musl")->make()->memory().empty());
  EXPECT_TRUE(find_integrator("musl")->make()->parameters().empty());
}

TEST(TimeIntegrator, ANameIsTakenOnce) {
  const IntegratorEntry again{"musl", "another", "none", [] { return std::make_unique<SecondMap>(); }};
  EXPECT_THROW(RegisterIntegrator{again}, std::logic_error);
}

TEST(TimeIntegrator, ANameIsPlain) {
  for (const std::string& good : std::vector<std::string>{"musl", "0", "a.b_c-d", std::string(63, 'x')})
    EXPECT_EQ(name_refusal(good), "") << good;
  for (const std::string& bad :
       std::vector<std::string>{"", "-", ".x", "../x", "a b", "a\n", "Capital", "\xc3\xa4", std::string(64, 'x')}) {
    EXPECT_NE(name_refusal(bad), "") << bad;
    IntegratorEntry entry = *find_integrator("musl");
    entry.name = bad;
    EXPECT_THROW(RegisterIntegrator{entry}, std::logic_error) << bad;
  }
}

TEST(TimeIntegrator, OneBuiltAgainstAnotherKernelIsNone) {
  IntegratorEntry entry = *find_integrator("musl");
  entry.name = "test_other_kernel";
  PluginStamp other = kernel_stamp();
  other.text[8] = 'x';
  EXPECT_THROW(RegisterIntegrator(entry, other), std::logic_error);
  EXPECT_EQ(find_integrator(entry.name), nullptr);
}

// The stamp is text of lines; the sizes of types stand in its last.
TEST(TimeIntegrator, TheStampTellsSizes) {
  const std::string stamp = plugin_stamp("integrators", "x", {8, 32}).text,
                    same = plugin_stamp("integrators", "x", {8, 32}).text,
                    other = plugin_stamp("integrators", "x", {32, 8}).text;
  EXPECT_EQ(stamp, same);
  EXPECT_NE(stamp, other);
  EXPECT_EQ(stamp.substr(0, stamp.rfind('\n')), other.substr(0, other.rfind('\n')));
  EXPECT_EQ(std::string(kernel_stamp().text), stamp_of_this_file.text);
  EXPECT_THAT(stamp, testing::StartsWith("registers integrators\nversion " PLUMBLINE_VERSION "\nheaders x\n"));
}

TEST(TimeIntegrator, RegistrationsAreCollectedUnchecked) {
  const std::size_t before = integrators().size();
  const auto found = collect_registrations([] {
    RegisterIntegrator({"musl", "", "", {}, {}});
    RegisterIntegrator({"", "", "", {}, {}});
  });
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].name, "musl");
  EXPECT_EQ(integrators().size(), before);
  EXPECT_THROW(collect_registrations([] { throw std::runtime_error("no library"); }), std::runtime_error);
  EXPECT_THROW(RegisterIntegrator({"musl", "", "", {}, {}}), std::logic_error) << "checked again";
}

TEST(TimeIntegrator, ClaimsNothingUnlessItSaysSo) {
  const Claims claims = SecondMap().claims();
  EXPECT_TRUE(claims.orders.empty() && claims.known_failures.empty());
  EXPECT_FALSE(claims.energy || claims.limit || claims.reversible);
}

}  // namespace
}  // namespace plumbline::time_integrator_test
