// Weights, placing, reflection, the step record and the velocity filter, each built without the rest of the engine.
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <random>

#include "kernel/engine/reflection.hpp"
#include "kernel/engine/step_record.hpp"
#include "kernel/engine/velocity_filter.hpp"
#include "tests/kernel/engine/parts.hpp"

namespace plumbline::parts_test {
namespace {

using testing::ElementsAre;

// --- weights ------------------------------------------------------------------------------------------------------------

TEST(Weights, KeepThePlacesOfBeforeTheFirstMotion) {
  Scene scene = points_at({{0.6, 0.7}});
  Columns& points = scene.bodies[0].points;
  Weights<2> at;
  EXPECT_FALSE(at.known());
  at.release();
  at.keep(points);
  points(column::position)[0] = 0.8;
  at.keep(points);  // as a second stage that moves points does
  at.positions_changed();
  EXPECT_TRUE(at.known() && at.kept());
  EXPECT_EQ(at.places(points, false).x[0][0], 0.6);
  at.release();
  EXPECT_EQ(at.places(points, false).x[0][0], 0.8);
}

TEST(Weights, AreLostWhenPositionsChangeThatNobodyKept) {
  Weights<2> at;
  at.release();
  at.positions_changed();
  EXPECT_FALSE(at.known());
}

// --- placing ------------------------------------------------------------------------------------------------------------

// Of each point the lowest node it reaches.
std::vector<int> nodes_of(const Bins& bins) {
  std::vector<int> nodes;
  for (int bin = 0; bin < bins.bins(); ++bin)
    nodes.insert(nodes.end(), static_cast<std::size_t>(bins.end(bin) - bins.start(bin)), bins.node(bin));
  return nodes;
}

// The lowest nodes reached are the nearest less one, ghosts counted: (0, 0), (3, 0) and twice (1, 2) of 7 x 7 nodes.
TEST(Placing, SortsPointsByNodeAndThenByNumber) {
  Scene scene = points_at({{0.6, 1.1}, {1.6, 0.1}, {0.4, 0.9}, {0.1, 0.1}});
  Body& body = scene.bodies[0];
  const Discretisation<Plane> space(scene, 1);
  Placing<Plane> placing(space);
  Weights<2> at;
  const std::vector<double> before(body.points(column::position), body.points(column::position) + 4);
  placing.locate(body, at, false, {});
  EXPECT_THAT(body.id, ElementsAre(0, 1, 2, 3));
  placing.locate(body, at, true, {});
  EXPECT_THAT(body.id, ElementsAre(3, 1, 0, 2));
  EXPECT_THAT(nodes_of(at.bins), ElementsAre(0, 3, 15, 15));
  for (std::size_t p = 0; p < 4; ++p) {
    EXPECT_EQ(body.points(column::position)[p], before[static_cast<std::size_t>(body.id[p])]);
  }
  EXPECT_THAT(nodes_of(placing.here(body).bins), ElementsAre(0, 3, 15, 15));
}

TEST(Placing, LeavesChainsInTheirOrder) {
  Scene scene = points_at({{1.6, 0.1}, {0.1, 0.1}});
  scene.bodies[0].chain = true;
  const Discretisation<Plane> space(scene, 1);
  Weights<2> at;
  Placing<Plane>(space).locate(scene.bodies[0], at, true, {});
  EXPECT_THAT(scene.bodies[0].id, ElementsAre(0, 1));
  EXPECT_THAT(nodes_of(at.bins), ElementsAre(3, 0));
}

TEST(Placing, NamesThePointThatLeftTheGrid) {
  Scene scene = points_at({{0.1, 0.1}, {0.1, 2.1}});
  const Discretisation<Plane> space(scene, 1);
  try {
    Placing<Plane>(space).here(scene.bodies[0]);
    FAIL() << "a point outside was placed";
  } catch (const InadmissibleState& state) {
    EXPECT_EQ(state.point, 1);
    EXPECT_EQ(state.value, 2.1);
  }
}

// A point that leaves while the others' order is kept: beyond each side, and to no place at all.
TEST(Placing, NamesThePointThatLeavesTheGridLater) {
  for (const double x : {2.1, -0.1, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
    Scene scene = points_at({{0.1, 0.1}, {0.6, 1.1}, {1.6, 0.1}});
    Body& body = scene.bodies[0];
    const Discretisation<Plane> space(scene, 1);
    Placing<Plane> placing(space);
    Weights<2> at;
    placing.locate(body, at, true, {});
    ASSERT_THAT(body.id, ElementsAre(0, 2, 1));
    body.points(column::position)[1] = x;
    try {
      placing.locate(body, at, true, {});
      FAIL() << "a point at " << x << " was placed";
    } catch (const InadmissibleState& state) {
      EXPECT_EQ(state.point, 2) << x;
    }
  }
}

// Points that wander, a few of them to other bins at a time, have the order and the bins that sorting them anew gives.
TEST(Placing, FollowsPointsAsIfItSortedThemAnew) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0, 2), step(-0.1, 0.1);
  std::vector<std::array<double, 2>> places(60);
  for (auto& place : places) place = {anywhere(random), anywhere(random)};
  Scene scene = points_at(places);
  Body& body = scene.bodies[0];
  const Discretisation<Plane> space(scene, 1);
  Placing<Plane> placing(space);
  Weights<2> at;
  placing.locate(body, at, true, {});
  for (int round = 0; round < 20; ++round) {
    for (std::size_t d = 0; d < 2; ++d) {
      double* x = body.points(column::position, static_cast<int>(d));
      for (std::size_t p = 0; p < places.size(); ++p) {
        auto& place = places[static_cast<std::size_t>(body.id[p])];
        place[d] = x[p] = std::clamp(place[d] + step(random), 0.0, 2.0);
      }
    }
    placing.locate(body, at, true, {});
    Scene fresh = points_at(places);
    Weights<2> anew;
    Placing<Plane>(space).locate(fresh.bodies[0], anew, true, {});
    ASSERT_EQ(body.id, fresh.bodies[0].id) << round;
    ASSERT_EQ(nodes_of(at.bins), nodes_of(anew.bins)) << round;
    for (std::size_t p = 0; p < places.size(); ++p) {
      ASSERT_EQ(body.points(column::position)[p], places[static_cast<std::size_t>(body.id[p])][0]) << round;
    }
  }
}

// --- reflection ---------------------------------------------------------------------------------------------------------

// A point 0.1 m beyond a wall comes back as its mirror image; the wall gives what its momentum changed by, and its turn about
// the origin: 2 kg (x x v) after less before.
TEST(Reflection, MirrorsPointAndVelocity) {
  for (const Wall wall : {Wall::symmetry, Wall::no_slip}) {
    Scene scene = points_at({{-0.1, 0.7}, {0.3, 0.7}}, wall, "apic");
    Columns& points = scene.bodies[0].points;
    points(column::velocity, 0)[0] = -3;
    points(column::velocity, 1)[0] = 5;
    for (int k = 0; k < 4; ++k) points(column::affine, k)[0] = k + 1;
    const Discretisation<Plane> space(scene, 1);
    MotionSums sums;
    Reflection<Plane>(space).apply(points, all_points(points), sums);
    const double along = wall == Wall::no_slip ? -1 : 1;
    EXPECT_DOUBLE_EQ(points(column::position)[0], 0.1);
    EXPECT_DOUBLE_EQ(points(column::velocity, 0)[0], 3);
    EXPECT_DOUBLE_EQ(points(column::velocity, 1)[0], 5 * along);
    EXPECT_DOUBLE_EQ(points(column::affine, 0)[0], 1);  // dv_x/dx: both signs change
    EXPECT_DOUBLE_EQ(points(column::affine, 1)[0], -2);
    EXPECT_DOUBLE_EQ(points(column::affine, 2)[0], -3 * along);
    EXPECT_DOUBLE_EQ(points(column::affine, 3)[0], 4 * along);
    EXPECT_DOUBLE_EQ(sums.reflected[0], 2 * 6);
    EXPECT_DOUBLE_EQ(sums.reflected[1], 2 * 5 * (along - 1));
    const double inertia = 0.25 * 0.25;  // D = h^2/4 [EC-APIC 5]
    const double turn_before = -0.1 * 5 - 0.7 * -3 + inertia * (3 - 2);
    const double turn_after = 0.1 * 5 * along - 0.7 * 3 + inertia * (-3 * along + 2);
    EXPECT_NEAR(sums.reflected_turn[2], 2 * (turn_after - turn_before), 1e-14);
    EXPECT_EQ(points(column::position)[1], 0.3);
  }
}

// --- step record --------------------------------------------------------------------------------------------------------

TEST(StepRecord, BooksEveryExchangeOnce) {
  StepRecord<2, 1> record;
  record.map_wall.linear = {1, 2};
  record.map_wall_work = 3;
  record.map_loss = 4;
  AdvanceRecord<2>& advance = record.advance.emplace();
  advance.wall.linear = {10, 20};
  advance.body.linear = {30, 40};
  advance.body.work = 50;
  advance.contact.linear = {60, 70};
  advance.contact.work = 80;
  advance.wall_work = 90;
  record.power = PowerSums{.power = 100, .viscous = 7};
  MotionSums motion;
  motion.lost = 1000;
  motion.reflected[0] = 200;
  for (const bool with_contact : {true, false}) {
    Ledger ledger;
    record.book(ledger, motion, with_contact);
    EXPECT_EQ(ledger.momentum[0].flow(Flow::walls), 1 + 10 + 200);
    EXPECT_EQ(ledger.momentum[1].flow(Flow::walls), 2 + 20);
    EXPECT_EQ(ledger.momentum[0].flow(Flow::body_force), 30);
    EXPECT_EQ(ledger.momentum[0].flow(Flow::contact), with_contact ? 60 : 0);
    EXPECT_EQ(ledger.energy.flow(Flow::walls), 3 + 90);
    EXPECT_EQ(ledger.energy.flow(Flow::body_force), 50);
    EXPECT_EQ(ledger.energy.flow(Flow::contact), with_contact ? 80 : 0);
    EXPECT_EQ(ledger.energy.flow(Flow::transfer), -4 - 1000);
    EXPECT_EQ(ledger.energy.flow(Flow::integration), -100);
    EXPECT_EQ(ledger.viscous, 7);
  }
}

// Where its power is wanted: from an advance until it is summed.
TEST(StepRecord, WantsThePowerOfTheLastAdvance) {
  StepRecord<2, 1> record;
  EXPECT_FALSE(record.wants_power());
  record.advance.emplace();
  EXPECT_TRUE(record.wants_power());
  record.power.emplace();
  EXPECT_FALSE(record.wants_power());
}

// --- velocity filter ----------------------------------------------------------------------------------------------------

// A velocity that is the same everywhere passes to the points and back unchanged: nothing of it is filtered, and walls give
// nothing. [XPIC 1] [FMPM 1]
TEST(VelocityFilter, LeavesTheMotionOfAWhole) {
  for (const char* transfer : {"xpic", "fmpm"}) {
    Scene scene = points_at({{0.6, 0.7}, {0.9, 1.2}, {1.3, 1.3}}, Wall::free, "flip");
    scene.transfer = transfer;
    scene.transfer_order = 3;
    const Discretisation<Plane> space(scene, 1);
    Body& body = scene.bodies[0];
    Placing<Plane> placing(space);
    Weights<2> at;
    placing.locate(body, at, true, {});
    VelocityField<2> field(space.grid);
    space.touch_alone(at, field);
    space.for_chunks_writing_nodes(
        at, [&](const Chunk& chunk) { space.loops->map_mass_and_momentum(body, at, chunk, field); });
    field.unfolded.mass = field.mass;
    field.for_touched(space.grid, [&](std::size_t i) {
      if (field.mass[i] > 0) field.start[i] = field.end[i] = {3, -4};
    });
    Eigen::Vector2d given = Eigen::Vector2d::Zero();
    Spin<2> turn = Spin<2>::Zero();
    VelocityFilter<Plane>(space).apply({{&body.points, &at}}, field, given, turn);
    field.for_touched(space.grid, [&](std::size_t i) {
      if (!(field.mass[i] > 0)) return;
      EXPECT_NEAR((field.corrected.filtered[i] - field.end[i]).norm(), 0, 1e-13) << transfer;
    });
    EXPECT_NEAR(given.norm(), 0, 1e-13);
  }
}

}  // namespace
}  // namespace plumbline::parts_test
