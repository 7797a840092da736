#include "cases/laboratory/claims.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/oscillator_limits.hpp"

namespace plumbline {
namespace {

using reference::OscillatorMethod;

TEST(Claims, LimitsAndOrdersAreThoseOfTheReference) {
  struct Known {
    const char* integrator;
    OscillatorMethod method;
  };
  for (const auto& [integrator, method] : {Known{"usf", OscillatorMethod::symplectic_euler},
                                           {"usl", OscillatorMethod::symplectic_euler},
                                           {"musl", OscillatorMethod::symplectic_euler},
                                           {"usavg", OscillatorMethod::leapfrog},
                                           {"leapfrog", OscillatorMethod::leapfrog},
                                           {"central-difference", OscillatorMethod::leapfrog},
                                           {"ssp-rk3", OscillatorMethod::ssp_rk3},
                                           {"rk4", OscillatorMethod::rk4},
                                           {"implicit-midpoint", OscillatorMethod::newmark_trapezoid}}) {
    const Claims claims = claims_of({integrator});
    const double limit = reference::oscillator_limit(method).value;
    ASSERT_TRUE(claims.limit) << integrator;
    EXPECT_TRUE(*claims.limit == limit || std::abs(*claims.limit / limit - 1) < 1e-15) << integrator;
    EXPECT_EQ(claimed_order(claims, "oscillator", "displacement"), reference::oscillator_order(method)) << integrator;
  }
  for (const double rho_b : {0.0, 0.5, 1.0}) {
    EXPECT_NEAR(claims_of({"generalized-alpha", {{"rho_b", rho_b}}}).limit.value(),
                reference::generalized_alpha_stability_limit(rho_b).value, 1e-15);
  }
}

TEST(Claims, InWords) {
  Claims claims;
  EXPECT_TRUE(claims_in_words(claims).empty());
  claims.orders = {{2}, {1, "oscillator", "velocity"}, {2, "h and dt", "displacement"}};
  claims.limit = std::sqrt(3.0);
  claims.energy = EnergyBehaviour::decaying;
  claims.reversible = true;
  const auto words = claims_in_words(claims);
  EXPECT_EQ(words.at("order"), "2 of displacement, 1 of velocity (oscillator), 2 of displacement (h and dt)");
  EXPECT_EQ(words.at("stability"), "1.7321/omega");
  EXPECT_EQ(words.at("energy"), "decaying");
  EXPECT_EQ(words.at("invariance"), "reversible");
  EXPECT_EQ(oscillator_limit_in_words(HUGE_VAL), "no limit");
  EXPECT_EQ(oscillator_limit_in_words(0), "no stable step");
  EXPECT_FALSE(claimed_order(claims, "fixed mesh", "strain"));
}

}  // namespace
}  // namespace plumbline
