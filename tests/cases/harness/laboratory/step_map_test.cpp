#include "cases/harness/laboratory/step_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "cases/harness/laboratory/bar_patch.hpp"

namespace plumbline::step_map_test {
namespace {

// Points in every cell, in uneven places, with velocities and strains of their own.
Scene uneven_bar(const std::string& transfer = "flip") {
  Scene scene = bar_patch({"quadratic", transfer, 2}, 3, 0.4, {8, 0}).scene;
  Columns& points = scene.bodies[0].points;
  for (int p = 0; p < points.points(); ++p) {
    points(column::position)[p] += 0.03 * std::sin(3.0 * p);
    points(column::velocity)[p] = 0.02 * std::cos(2.0 * p);
    points(column::strain)[p] = 0.01 * std::sin(1.0 + p);
  }
  return scene;
}

// The same with its points in another order: every other one from the front, the others from the back.
std::vector<int> other_order(int points) {
  std::vector<int> order;
  for (int p = 0; p < points; p += 2) order.push_back(p);
  for (int p = points - 1 - points % 2; p > 0; p -= 2) order.push_back(p);
  return order;
}

TEST(StepMap, StatesAreSetAndReadBit) {
  for (const Positions positions : {Positions::frozen, Positions::moving}) {
    for (const char* integrator : {"musl", "usf", "generalized-alpha"}) {
      StepMap map(uneven_bar(), {2, 3, 5}, {integrator, {}}, positions, 0.01);
      std::vector<double> state = map.state();
      for (std::size_t k = 0; k < state.size(); ++k) {
        if (map.position_direction(k) < 0) state[k] = std::sin(0.1 + static_cast<double>(k));
      }
      for (int again = 0; again < 2; ++again) {
        map.set_state(state);
        const std::vector<double> read = map.state();
        for (std::size_t k = 0; k < state.size(); ++k) EXPECT_NEAR(read[k], state[k], 4e-16) << map.name(k);
        map.step();  // sorts points, perhaps
      }
    }
  }
}

// Each number over the unit of its column: a strain none, a velocity 3 m/s, a place 2 m, a stress 5 * 3^2 Pa.
TEST(StepMap, NumbersAreInTheUnitsGiven) {
  const Scene scene = uneven_bar();
  const Columns& points = scene.bodies[0].points;
  const StepMap map(scene, {2, 3, 5}, {"usl", {}}, Positions::moving, 0.01);
  const std::vector<double> state = map.state();
  int seen = 0;
  for (std::size_t k = 0; k < state.size(); ++k) {
    const int p = map.entry(k).point;
    const bool place = map.position_direction(k) == 0;
    if (!place && !map.is_velocity(k)) continue;
    EXPECT_EQ(state[k], place ? points(column::position)[p] / 2 : points(column::velocity)[p] / 3);
    ++seen;
  }
  EXPECT_EQ(seen, 2 * points.points());
}

TEST(StepMap, FrozenPointsGoBackToTheirPlaces) {
  const Scene scene = uneven_bar();
  StepMap frozen(scene, {}, {"musl", {}}, Positions::frozen, 0.1),
      moving(scene, {}, {"musl", {}}, Positions::moving, 0.1);
  const auto n = static_cast<std::size_t>(scene.bodies[0].points.points());
  EXPECT_EQ(moving.size(), frozen.size() + n);
  for (std::size_t k = 0; k < frozen.size(); ++k) EXPECT_EQ(frozen.position_direction(k), -1);
  frozen.step();
  frozen.set_state(frozen.state());
  const Body& body = frozen.scene().bodies[0];
  for (std::size_t p = 0; p < n; ++p) {
    EXPECT_EQ(body.points(column::position)[p], scene.bodies[0].points(column::position)[body.id[p]]);
  }
}

// A map: the same state gives the same next one, whatever came between.
TEST(StepMap, TheSameStateGivesTheSameNext) {
  for (const char* integrator : {"musl", "central-difference", "generalized-alpha", "usavg"}) {
    StepMap map(uneven_bar(), {}, {integrator, {}}, Positions::moving, 0.1);
    const std::vector<double> start = map.state();
    map.step();
    const std::vector<double> next = map.state();
    for (int k = 0; k < 5; ++k) map.step();
    map.set_state(start);
    map.step();
    const std::vector<double> again = map.state();
    for (std::size_t k = 0; k < next.size(); ++k) EXPECT_NEAR(again[k], next[k], 1e-14) << integrator << map.name(k);
  }
}

// Points are known by their numbers: scenes that list the same points in different orders have the same steps, to the roundings
// of sums in another order.
TEST(StepMap, TheOrderOfPointsDoesNotMatter) {
  for (const char* integrator : {"usf", "musl", "generalized-alpha", "ssp-rk3"}) {
    const Scene scene = uneven_bar();
    Scene shuffled = scene;
    const std::vector<int> order = other_order(scene.bodies[0].points.points());
    shuffled.bodies[0].points.reorder(order);  // number k there is order[k] here
    StepMap one(scene, {}, {integrator, {}}, Positions::moving, 0.1),
        two(shuffled, {}, {integrator, {}}, Positions::moving, 0.1);
    for (int k = 0; k < 3; ++k) {
      one.step();
      two.step();
    }
    const std::vector<double> a = one.state(), b = two.state();
    ASSERT_EQ(a.size(), b.size());
    const std::size_t n = order.size();
    for (std::size_t k = 0; k < a.size(); ++k) {
      ASSERT_EQ(two.entry(k).point, static_cast<int>(k % n));
      EXPECT_NEAR(b[k], a[k - k % n + static_cast<std::size_t>(order[k % n])], 1e-13) << integrator << two.name(k);
    }
  }
}

TEST(StepMap, WhatTheIntegratorRemembersIsPartOfTheState) {
  const auto remembered = [](const StepMap& map) {
    int count = 0;
    for (std::size_t k = 0; k < map.size(); ++k) count += map.name(k).find("(memory)") != std::string::npos;
    return count;
  };
  const Scene scene = uneven_bar();
  const int n = scene.bodies[0].points.points();
  EXPECT_EQ(remembered({scene, {}, {"generalized-alpha", {}}, Positions::frozen, 0.1}), 3 * n);  // x, v, strain
  EXPECT_EQ(remembered({scene, {}, {"central-difference", {}}, Positions::frozen, 0.1}), 0);
  EXPECT_THROW(StepMap(scene, {}, {"no such", {}}, Positions::frozen, 0.1), std::invalid_argument);
  EXPECT_THROW(StepMap(scene, {}, {"leapfrog", {}}, Positions::frozen, 0.1), std::invalid_argument);
  EXPECT_THROW(StepMap(scene, {}, {"generalized-alpha", {{"rho_b", 2}}}, Positions::frozen, 0.1),
               std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::step_map_test
