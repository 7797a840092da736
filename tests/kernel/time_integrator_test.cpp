#include "kernel/time_integrator.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

#include "tests/kernel/scenes.hpp"

namespace plumbline {
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
  for (const char* name : {"usf", "usl", "musl", "usavg", "energy"}) {
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

TEST(TimeIntegrator, ANameIsTakenOnce) {
  const IntegratorEntry again{"musl", "another", "none", [] { return std::make_unique<SecondMap>(); }};
  EXPECT_THROW(RegisterIntegrator{again}, std::logic_error);
}

TEST(TimeIntegrator, RefusesNothingUnlessItSaysSo) {
  EXPECT_EQ(find_integrator("musl")->make()->refusal("linear", "flip"), "");
  EXPECT_FALSE(find_integrator("musl")->make()->returns_transfer_loss());
}

}  // namespace
}  // namespace plumbline
