// What integrators need and offer is found by stepping them; none says so itself.
#include "kernel/integrator_traits.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <initializer_list>

#include "tests/kernel/scenes.hpp"

namespace plumbline::integrator_traits_test {
namespace {

using testing::HasSubstr;

const Traits of_losses{Trait::returnable_loss, Trait::smooth_gradients, Trait::constant_inertia};

TEST(IntegratorTraits, OfTheKernelsOwn) {
  struct Expected {
    const char* name;
    Traits needs;
    bool returns_loss, stress_first;
  };
  const Traits none, rates{Trait::unfiltered_velocities};
  const Expected all[] = {{"musl", none, false, false},
                          {"usf", none, false, false},
                          {"usl", none, false, false},
                          {"usavg", none, false, false},
                          {"midpoint", none, false, false},
                          {"central-difference", none, false, false},
                          {"energy", of_losses, true, true},
                          {"leapfrog", of_losses, true, true},
                          {"rk4", rates, false, true},
                          {"ssp-rk3", rates, false, true},
                          {"generalized-alpha", rates, false, true},
                          {"implicit-midpoint", rates, false, true}};
  for (const Expected& expected : all) {
    const IntegratorTraits& found = traits_of(*find_integrator(expected.name));
    EXPECT_EQ(found.needs, expected.needs) << expected.name;
    EXPECT_EQ(found.offers.count(Trait::returned_loss) > 0, expected.returns_loss) << expected.name;
    EXPECT_TRUE(found.offers.count(Trait::forward_steps)) << expected.name;
    EXPECT_EQ(found.evaluates_stress_first, expected.stress_first) << expected.name;
    EXPECT_EQ(found.failure, "") << expected.name;
  }
}

class Backwards final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    for (const double share : {1.5, -0.5}) {
      mpm.locate_points();
      mpm.map_mass_and_momentum();
      mpm.map_forces();
      mpm.advance_momentum(share * dt);
      mpm.move_points(share * dt);
      mpm.update_stress(share * dt);
    }
  }
};

class Failing final : public TimeIntegrator {
  void step(Stages&, double) override { throw std::runtime_error("out of order"); }
};

// Not registered: other tests take all that are.
template <class Type>
IntegratorEntry entry_of(const char* name) {
  return {name, "of this test", "this test", [] { return std::make_unique<Type>(); }};
}

TEST(IntegratorTraits, StepsBackwardsAreNotForDissipation) {
  const IntegratorEntry entry = entry_of<Backwards>("test_backwards");
  EXPECT_TRUE(lacks(entry, "linear", "flip").empty());
  const std::vector<Lack> under_apic = lacks(entry, "quadratic", "apic");
  ASSERT_EQ(under_apic.size(), 1U);
  EXPECT_EQ(under_apic[0].trait, Trait::forward_steps);
  EXPECT_THAT(under_apic[0].text(), HasSubstr("transfer apic needs forward-steps: integrator test_backwards"));
  const Scene viscous_gas = scenes::rough_gas(1, "linear", "flip");
  EXPECT_EQ(lacks(entry, viscous_gas).size(), 1U);
}

TEST(IntegratorTraits, EachDissipationOfASceneIsRefusedByItself) {
  const IntegratorEntry entry = entry_of<Backwards>("test_backwards");
  const auto lacks_with = [&](const std::function<void(Scene&)>& choose) {
    Scene scene;
    scene.shape = "linear";
    scene.transfer = "flip";
    choose(scene);
    return lacks(entry, scene);
  };
  EXPECT_TRUE(lacks_with([](Scene&) {}).empty());
  for (const std::function<void(Scene&)>& choose : std::initializer_list<std::function<void(Scene&)>>{
           [](Scene& s) { s.chain_relaxation = 0.5; }, [](Scene& s) { s.strain_smoothing = 0.5; },
           [](Scene& s) { s.heat_exchange = 0.5; }, [](Scene& s) { s.filter.sound = 0.5; },
           [](Scene& s) { s.filter.compression = 0.5; }, [](Scene& s) { s.contact = "touching"; }}) {
    const std::vector<Lack> found = lacks_with(choose);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].trait, Trait::forward_steps);
  }
}

TEST(IntegratorTraits, ForcesOfAStepAreCounted) {
  EXPECT_EQ(traits_of(*find_integrator("musl")).force_evaluations, 1);
  EXPECT_EQ(traits_of(*find_integrator("midpoint")).force_evaluations, 2);
  EXPECT_EQ(traits_of(*find_integrator("rk4")).force_evaluations, 4);
  EXPECT_GT(traits_of(*find_integrator("implicit-midpoint")).force_evaluations, 4);
}

TEST(IntegratorTraits, MapsOfAStepAreCounted) {
  EXPECT_EQ(traits_of(*find_integrator("musl")).maps, 1);
  EXPECT_EQ(traits_of(entry_of<Backwards>("test_backwards")).maps, 2);
  EXPECT_FALSE(traits_of(*find_integrator("usavg")).drifts);
  EXPECT_TRUE(traits_of(*find_integrator("leapfrog")).drifts);
}

TEST(IntegratorTraits, WhatAStepThrowsIsKept) {
  EXPECT_EQ(traits_of(entry_of<Failing>("test_failing")).failure, "out of order");
}

TEST(IntegratorTraits, ALackNamesBothParts) {
  const std::vector<Lack> found = lacks(*find_integrator("leapfrog"), "linear", "apic");
  ASSERT_EQ(found.size(), 2U);
  for (const Lack& lack : found) {
    EXPECT_EQ(lack.needed_by, "integrator leapfrog");
    EXPECT_EQ(lack.not_offered_by, "shape linear");
  }
  EXPECT_THAT(CannotWork(found).what(), HasSubstr("has gradients that jump between cells"));
}

}  // namespace
}  // namespace plumbline::integrator_traits_test
