// What stages are made of: maps, strains, stresses, forces and motion, each built without the rest of the engine.
#include "kernel/engine/finish.hpp"
#include "kernel/engine/locating.hpp"
#include "kernel/engine/stress.hpp"
#include "kernel/engine/to_grid.hpp"
#include "tests/kernel/engine/parts.hpp"

namespace plumbline::stage_parts_test {
namespace {

using Vec = Eigen::Vector2d;
using Record = StepRecord<2, 1>;

// Two points of 2 kg on one place, flying apart.
Located& flying_apart(Located& on) {
  on.points()(column::velocity, 0)[0] = 3;
  on.points()(column::velocity, 0)[1] = -3;
  on.points()(column::velocity, 1)[0] = on.points()(column::velocity, 1)[1] = 1;
  return on;
}
Scene two_on_one_place(const std::string& transfer = "pic") {
  return points_at({{0.9, 1.1}, {0.9, 1.1}}, Wall::free, transfer);
}

// v = L (x - x_0) + v_0 at every node.
void set_linear(const Located& on, std::vector<Vec>& velocity, const Eigen::Matrix2d& gradient) {
  for (int i = 0; i < on.space.grid.node_count(); ++i) {
    velocity[static_cast<std::size_t>(i)] = gradient * on.space.grid.position(i);
  }
}
Eigen::Matrix2d some_gradient() {
  Eigen::Matrix2d gradient;
  gradient << 1, 2, 3, 5;
  return gradient;
}

// --- locating -----------------------------------------------------------------------------------------------------------

TEST(Locating, KeepsTheOrderWhereStatesNamePointsByTheirPlace) {
  for (const bool keeps_order : {false, true}) {
    Scene scene = points_at({{1.6, 0.1}, {0.1, 0.1}});
    const Discretisation<Plane> space(scene, 1);
    Layout<2> at = layout_of(scene.bodies, space.grid);
    Ledger ledger;
    Locating<Plane> locating(space, scene, {.keeps_order = keeps_order}, ledger);
    locating.locate(at);
    EXPECT_THAT(scene.bodies[0].id, testing::ElementsAre(1, 0));  // sorted once
    std::swap(scene.bodies[0].points(column::position)[0], scene.bodies[0].points(column::position)[1]);
    locating.locate(at);
    EXPECT_EQ(scene.bodies[0].id[0], keeps_order ? 1 : 0);
    EXPECT_TRUE(at.weights[0].known());
    locating.forget(at);
    EXPECT_FALSE(at.weights[0].known());
    EXPECT_THROW(at.want_places("a stage"), std::logic_error);
  }
}

// --- maps to the grid ---------------------------------------------------------------------------------------------------

// sum_i M_i = sum_p m_p, sum_i P_i = sum_p m_p v_p; what is apart at one place is lost. [York 3.15, 3.16] [EC-APIC 1]
TEST(ToGrid, MapsAllMassAndMomentumAndTellsWhatIsLost) {
  Located on(two_on_one_place());
  flying_apart(on);
  NodalMomentum<Plane> momentum(on.space, on.scene, on.at.field_of_body);
  const ToGrid<Plane> to_grid(on.space);
  Record step;
  to_grid.map_mass_and_momentum(on.at, momentum, step);
  EXPECT_NEAR(step.grid_mass, 4, 1e-14);
  EXPECT_NEAR((on.sum([&](std::size_t i) { return Vec(on.field().momentum[i]); }) - Vec(0, 4)).norm(), 0, 1e-14);
  EXPECT_FALSE(step.map_loss);
  to_grid.settle_loss(on.at, step);
  EXPECT_NEAR(*step.map_loss, 2 * 0.5 * 2 * 9, 1e-13);
  *step.map_loss = 7;
  to_grid.settle_loss(on.at, step);
  EXPECT_EQ(*step.map_loss, 7) << "what is known is not summed again";
}

TEST(ToGrid, MapsMomentumAnewWithTheMassOfBefore) {
  Located on(two_on_one_place());
  NodalMomentum<Plane> momentum(on.space, on.scene, on.at.field_of_body);
  const ToGrid<Plane> to_grid(on.space);
  Record step;
  to_grid.map_mass_and_momentum(on.at, momentum, step);
  for (int p = 0; p < 2; ++p) on.points()(column::velocity)[p] = 5;
  step.rates_of = NodalVelocity::remapped;
  to_grid.map_momentum(on.at, momentum, step);
  EXPECT_EQ(step.newest, NodalVelocity::remapped);
  EXPECT_FALSE(step.rates_of);
  on.field().for_touched(on.space.grid, [&](std::size_t i) {
    if (!(on.field().mass[i] > 0)) return;
    EXPECT_NEAR(on.field().remapped[i][0], 5, 1e-14);
  });
}

// --- strain -------------------------------------------------------------------------------------------------------------

// A velocity gradient that is the same everywhere is every point's: of a gas its trace. [York 3.23]
TEST(Strain, RatesAreThoseOfTheNodalVelocity) {
  Located on(points_at({{0.6, 0.7}, {1.1, 1.2}}, Wall::free));
  set_linear(on, on.field().midpoint, some_gradient());
  Ledger ledger;
  const Strain<Plane> strain(on.space, 0, ledger);
  Record step;
  strain.find_rates(on.at, step, NodalVelocity::midpoint);
  for (int p = 0; p < 2; ++p) EXPECT_NEAR(on.points()(column::strain_rate)[p], 6, 1e-13);
  EXPECT_EQ(step.rates_of, NodalVelocity::midpoint);
  on.points()(column::strain_rate)[0] = 0;
  step.newest = NodalVelocity::midpoint;
  strain.find_rates(on.at, step, NodalVelocity::current);
  EXPECT_EQ(on.points()(column::strain_rate)[0], 0) << "rates that the points hold are not found again";
}

// A gas of pressure 4 Pa: dt sum_p V_p sigma : rate = -dt V p div v; before the forces it waits.
TEST(Strain, PowerIsBookedOnceTheForcesAreKnown) {
  Located on(points_at({{0.6, 0.7}}, Wall::free));
  set_linear(on, on.field().start, some_gradient());
  set_linear(on, on.field().midpoint, 2 * some_gradient());
  on.points()(column::volume)[0] = 0.5;
  on.points()(column::stress)[0] = -4;
  on.points()(column::energy)[0] = 100;
  const double dt = 0.1, power = -dt * 0.5 * 4 * 6;
  Ledger ledger;
  Strain<Plane> strain(on.space, 0, ledger);
  Record step;
  strain.advance(on.at, step, dt, NodalVelocity::start);
  EXPECT_EQ(ledger.energy.flow(Flow::integration), 0);
  EXPECT_NEAR(on.points()(column::energy)[0], 100 + power / 2, 1e-13);  // [York 4.8]
  strain.settle_early(on.at, step);
  EXPECT_NEAR(ledger.energy.flow(Flow::integration), power, 1e-14);
  step.forces.emplace();
  strain.advance(on.at, step, dt, NodalVelocity::start);
  EXPECT_NEAR(ledger.energy.flow(Flow::integration), 2 * power, 1e-14);
  EXPECT_NEAR(ledger.energy.flow(Flow::constitutive), 0, 1e-14);
  step.advance.emplace().dt = dt;
  strain.settle_power(on.at, step);
  EXPECT_NEAR(step.power->power, 2 * power, 1e-14) << "of the forces, with the midpoint velocity";
}

// --- stress and forces --------------------------------------------------------------------------------------------------

// sum_i f_i = 0 and sum_i f_i x_i^T = -V sigma, of a pressure. [York 3.17] With a load, sum_i f_i = m b. [York 3.18]
TEST(Forces, BalanceAndHaveTheMomentOfTheStress) {
  Located on(points_at({{0.8, 1.3}}, Wall::free));
  on.points()(column::volume)[0] = 0.5;
  on.points()(column::stress)[0] = -4;
  double asked = 0;
  on.body().load = [&](double time, Columns& points, std::span<const int>) {
    asked = time;
    points(column::body_force, 1)[0] = -9;
  };
  Forces<Plane> forces(on.space, Shares::none, 0);
  Record step;
  step.stress_ahead = 0.25;
  forces.map_all(on.at, step, {3});
  EXPECT_EQ(asked, 3.25);
  EXPECT_NEAR(on.sum([&](std::size_t i) { return Vec(on.field().force[i]); }).norm(), 0, 1e-14);
  EXPECT_NEAR((on.sum([&](std::size_t i) { return Vec(on.field().body_force[i]); }) - Vec(0, -18)).norm(), 0, 1e-13);
  const Eigen::Matrix2d moment = on.sum([&](std::size_t i) {
    return Eigen::Matrix2d(on.field().force[i] * on.space.grid.position(static_cast<int>(i)).transpose());
  });
  EXPECT_NEAR((moment - 2 * Eigen::Matrix2d::Identity()).norm(), 0, 1e-13);
}

// p = (gamma - 1) rho e ahead of the step's start, and its forces in the same pass as those of the stress mapped afterwards.
// [York 4.4] [Leapfrog 2]
TEST(Stress, IsOfTheDensityThatTheGridHasAndMapsItsForces) {
  for (const bool in_one : {false, true}) {
    Located on(points_at({{1.0, 1.0}}, Wall::free));
    on.points()(column::energy)[0] = 10;
    NodalMomentum<Plane> momentum(on.space, on.scene, on.at.field_of_body);
    Record step;
    ToGrid<Plane>(on.space).map_mass_and_momentum(on.at, momentum, step);
    Stress<Plane> stress(on.space, on.scene, Shares::none);
    stress.evaluate(on.at, step, {}, 0, NodalVelocity::start, in_one);
    const double alone = 0.75 * 0.75 + 2 * 0.125 * 0.125;  // sum_i N_ip^2 of one direction
    const double rho = 2 / 0.25 * alone * alone;
    EXPECT_NEAR(on.points()(column::stress)[0], -0.4 * rho * 10, 1e-12);
    EXPECT_NEAR(on.points()(column::volume)[0], 2 / rho, 1e-14);
    EXPECT_EQ(step.rates_of, NodalVelocity::start);
    EXPECT_TRUE(step.map_loss);
    EXPECT_EQ(step.forces.has_value(), in_one);
    const auto found = on.field().force;
    stress.map_forces(on.at, step, {});
    if (!in_one) continue;
    on.field().for_touched(on.space.grid, [&](std::size_t i) { EXPECT_EQ(found[i], on.field().force[i]); });
  }
}

// --- motion -------------------------------------------------------------------------------------------------------------

struct Moved {
  Located on;
  Ledger ledger;
  Motion<Plane> motion;
  Record step;
  explicit Moved(Scene scene) : on(std::move(scene)), motion(on.space, on.scene, true, ledger) {
    motion.add_columns(on.body(), on.field());
    step.map_loss = 0;
  }
};

TEST(Motion, DriftsWithThePointsOwnVelocities) {
  Moved moved(points_at({{0.6, 0.7}}, Wall::free));
  moved.on.points()(column::velocity, 0)[0] = 2;
  moved.motion.drift(moved.on.at, moved.step, 0.125);
  EXPECT_EQ(moved.on.points()(column::position)[0], 0.6 + 0.25);
  moved.on.points()(column::velocity, 0)[0] = 200;
  EXPECT_THROW(moved.motion.drift(moved.on.at, moved.step, 0.125), InadmissibleState);
}

// Two points that flew apart take the velocity of the nodes, 1 m/s; the place is that of the nodal velocity that carries them.
TEST(Motion, CarriesPointsWithTheGrid) {
  for (const NodalVelocity carrying : {NodalVelocity::end, NodalVelocity::midpoint}) {
    Moved moved(two_on_one_place());
    flying_apart(moved.on);
    for (auto& v : moved.on.field().end) v = {1, 0};
    for (auto& v : moved.on.field().midpoint) v = {0.5, 0};
    moved.motion.carry(moved.on.at, moved.step, 0.1, {}, carrying);
    for (int p = 0; p < 2; ++p) {
      EXPECT_NEAR(moved.on.points()(column::velocity, 0)[p], 1, 1e-14);
      const double speed = carrying == NodalVelocity::end ? 1 : 0.5;
      EXPECT_NEAR(moved.on.points()(column::position, 0)[p], 0.9 + 0.1 * speed, 1e-14);
    }
    EXPECT_TRUE(moved.on.at.places_kept());
  }
}

TEST(Motion, GivesBackWhatWasLostAsHeat) {
  Moved moved(two_on_one_place());
  moved.on.points()(column::transfer_loss)[0] = 6;
  moved.on.points()(column::transfer_loss)[1] = 8;
  moved.motion.return_loss(moved.on.at);
  EXPECT_EQ(moved.on.points()(column::energy)[0], 3);  // J/kg of 2 kg [EC-APIC 6]
  EXPECT_EQ(moved.on.points()(column::energy)[1], 4);
  EXPECT_EQ(moved.ledger.energy.flow(Flow::transfer), 14);
}

// The pass that ends a step drops the weights and surveys what it leaves.
TEST(Motion, FinishesAStepInOnePass) {
  Moved moved(two_on_one_place());
  for (auto& v : moved.on.field().end) v = {1, 0};
  for (const ColumnId* id : {&column::energy, &column::density, &column::volume}) {
    for (int p = 0; p < 2; ++p) moved.on.points()(*id)[p] = 10;
  }
  const Survey survey = moved.motion.finish(moved.on.at, moved.step, 0.1, {});
  EXPECT_NEAR(survey.totals.momentum[0], 4, 1e-13);
  EXPECT_TRUE(survey.admissible);
  EXPECT_THROW(moved.on.at.want_places("a stage"), std::logic_error);
}

}  // namespace
}  // namespace plumbline::stage_parts_test
