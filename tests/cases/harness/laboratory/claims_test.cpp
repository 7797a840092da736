#include "cases/harness/laboratory/claims.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::claims_test {
namespace {

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
}  // namespace plumbline::claims_test
