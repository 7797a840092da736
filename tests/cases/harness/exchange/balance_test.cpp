// What a final state must have kept of the start: by points that are the start's, and by what they are changed to.
#include "cases/harness/exchange/balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::balance_test {
namespace {

// Two disks that approach each other in free space: their momenta add up to none.
struct Start {
  const Case& entry = find_case("two-disks");
  Settings settings = entry.settings("default", {{"cells", entry.levels.front()}});
  std::unique_ptr<Problem> problem = entry.problem(settings);
  std::vector<HandedIn> bodies;

  Start() {
    for (const Body& body : problem->scene().bodies) bodies.push_back({body.points.points(), body.points});
  }
  Balance balance() const { return balance_of(*problem, settings, bodies).balance; }
  // sum m |v| of points as they are.
  double speeds() const {
    double sum = 0;
    for (const HandedIn& body : bodies) {
      for (int p = 0; p < body.points; ++p) {
        sum += body.columns(column::mass)[p] *
               std::hypot(body.columns(column::velocity, 0)[p], body.columns(column::velocity, 1)[p]);
      }
    }
    return sum;
  }
};

constexpr double rounding = 1e-13;  // sums over some thousand points

TEST(Balance, OfTheStartItselfNothingIsOff) {
  const Balance own = Start().balance();
  EXPECT_NEAR(own.mass, 0, rounding);
  ASSERT_TRUE(own.momentum);
  EXPECT_NEAR(*own.momentum, 0, rounding);
  EXPECT_LE(own.energy, 1 + rounding);
}

// A speed u across, of all points: the sum of momenta is m u, in the direction that had none.
TEST(Balance, SeesMomentumThatTheEndHasAndTheStartHasNot) {
  Start changed;
  constexpr double u = 0.01;
  double mass = 0;
  for (HandedIn& body : changed.bodies) {
    for (int p = 0; p < body.points; ++p) {
      body.columns(column::velocity, 1)[p] += u;
      mass += body.columns(column::mass)[p];
    }
  }
  const double scale = std::max(Start().speeds(), changed.speeds());
  EXPECT_NEAR(changed.balance().momentum.value_or(0), mass * u / scale, 1e-12);
}

TEST(Balance, SeesMassAndEnergyThatTheEndHasMore) {
  Start heavy, fast;
  const double before = fast.balance().energy;
  for (HandedIn& body : heavy.bodies) {
    for (int p = 0; p < body.points; ++p) body.columns(column::mass)[p] *= 1.25;
  }
  for (HandedIn& body : fast.bodies) {
    for (int d = 0; d < 2; ++d) {
      for (int p = 0; p < body.points; ++p) body.columns(column::velocity, d)[p] *= 2;
    }
  }
  EXPECT_NEAR(heavy.balance().mass, 0.25, rounding);
  EXPECT_NEAR(fast.balance().energy, 4 * before, 1e-12);
}

}  // namespace
}  // namespace plumbline::balance_test
