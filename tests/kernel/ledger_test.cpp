#include "kernel/ledger.hpp"
#include "kernel/transfers/transfer.hpp"

#include <algorithm>
#include <limits>

#include "tests/kernel/scenes.hpp"

namespace plumbline::ledger_test {
namespace {

TEST(Ledger, ResidualIsWhatNoFlowExplains) {
  Account account;
  account.open(10, 10);
  account.book(Flow::walls, 3);
  account.book(Flow::transfer, -1);
  account.close(12, 12);
  EXPECT_EQ(account.residual(), 0);
  account.book(Flow::body_force, 0.5);
  account.close(12, 8);
  EXPECT_EQ(account.residual(), -0.5);
  EXPECT_EQ(account.flow(Flow::walls), 3);
  EXPECT_EQ(account.booked(), 4.5);
  EXPECT_EQ(account.scale(), 12);  // the largest so far
  EXPECT_EQ(account.relative_drift(false), 0.5 / 12);
  EXPECT_EQ(account.relative_drift(true), 0.5 / 16.5);
}

TEST(Ledger, TheLargestResidualStays) {
  Account account;
  account.open(1, 1);
  account.close(1.5, 1);
  account.close(1, 1);
  EXPECT_EQ(account.residual(), 0);
  EXPECT_EQ(account.largest_residual(), 0.5);
}

TEST(Ledger, ANonFiniteStoreShows) {
  Account account;
  account.open(1, 1);
  account.close(std::numeric_limits<double>::quiet_NaN(), 1);
  EXPECT_TRUE(std::isnan(account.relative_drift(false)));
  account.close(1, 1);
  EXPECT_TRUE(std::isnan(account.relative_drift(false)));  // and goes on showing
}

TEST(Ledger, NothingHappenedIsNoDrift) {
  Account account;
  account.open(0, 0);
  account.close(0, 0);
  EXPECT_EQ(account.relative_drift(true), 0);
}

// Mass is compared with what the grid got: points cannot lose mass, a map can. [York 3.15]
TEST(Ledger, MassIsComparedWithTheGrid) {
  Totals totals;
  totals.mass = 2;
  totals.grid_mass = 2;
  Ledger ledger;
  ledger.open(totals);
  totals.grid_mass = 1.5;
  ledger.close_step(totals);
  EXPECT_EQ(ledger.mass.residual(), -0.5);
}

TEST(Ledger, StoresAddUp) {
  Totals totals;
  totals.energy = {1, 2, 4};
  Ledger ledger;
  ledger.open(totals);
  EXPECT_EQ(ledger.energy.initial(), 7);
  totals.energy.kinetic = 2;
  ledger.energy.book(Flow::body_force, 1);
  ledger.close_step(totals);
  EXPECT_EQ(ledger.energy.residual(), 0);
  EXPECT_EQ(ledger.stores.kinetic, 2);
  EXPECT_EQ(ledger.initial_stores.kinetic, 1);
}

TEST(Ledger, NamesItsFlowsInTheirOrder) {
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::walls)], "walls");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::body_force)], "body_force");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::contact)], "contact");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::transfer)], "transfer");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::constitutive)], "constitutive");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::integration)], "integration");
  EXPECT_EQ(flow_names[static_cast<std::size_t>(Flow::released)], "released");
}

// --- whole runs -----------------------------------------------------------------------------------------------------

// Chains under gravity: on a line from a wall, in the plane from a corner of two, some of it slack at first.
Scene hanging_chain(int dim, const std::string& shape, const std::string& transfer) {
  UniaxialMembrane law;
  law.youngs_modulus = 2;
  law.density = 1;
  std::vector<scenes::Place> places;
  for (int k = 0; k < 10; ++k)
    places.push_back({0.02 + 0.04 * k, dim == 1 ? 0 : 0.62 - 0.02 * k + 0.03 * std::sin(1.0 * k)});
  const auto sides = scenes::walls(Wall::no_slip, Wall::free, Wall::free, Wall::symmetry);
  const GridSpec grid = dim == 1 ? scenes::line(8, 0.1, sides) : scenes::plane(8, 7, 0.1, sides);
  Body body = scenes::membrane_body(law, dim, places, 0.01, [](const scenes::Place& x) {
    return scenes::Place{0.2 * std::sin(20 * x[0]), 0.2 * std::cos(9 * x[0])};
  });
  for (int k = 0; k < 10; ++k) body.points(column::strain)[k] = 0.05 * std::cos(2.0 * k);
  return scenes::scene_of(grid, {std::move(body)}, shape, transfer, {1, -2});
}

// A gas and a chain through it, moving with one velocity field.
Scene gas_and_chain(int dim, const std::string& shape, const std::string& transfer) {
  Scene scene = scenes::rough_gas(dim, shape, transfer);
  scene.bodies.push_back(hanging_chain(dim, shape, transfer).bodies[0]);
  return scene;
}

// Every identity closes step by step. Ten steps of sums of some hundred terms: 1e-13 allows for a hundred
// roundings of the scale.
TEST(LedgerOfARun, ClosesForEveryCombination) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    for (int dim : {1, 2}) {
      for (Scene (*make)(int, const std::string&, const std::string&) : {&hanging_chain, &gas_and_chain}) {
        SCOPED_TRACE(testing::Message() << dim << "-D, " << c);
        Simulation run(make(dim, c.shape, c.transfer), c.integrator, {0.2, {}});
        const int steps = c.shape == "quadratic" || c.shape == "cubic" ? 10 : 4;  // before light nodes cool a gas out
        for (int k = 0; k < steps; ++k) {
          run.step(1);
          scenes::expect_ledger_closes(run.ledger(), 1e-13);
        }
      }
    }
  }
}

// The same for a gas in every geometry, with the angular momenta about all axes. Linear shapes throw the light nodes of a
// free edge about until an energy is negative: two steps of them.
TEST(LedgerOfARun, ClosesInEveryGeometry) {
  for (const scenes::Combination& c : scenes::working_combinations()) {
    for (scenes::Space space : scenes::spaces) {
      if (!scenes::runs_in(c, space)) continue;
      for (const IdealGas& gas : {scenes::rough_law(), scenes::inviscid_law()}) {
        SCOPED_TRACE(testing::Message() << space << ", " << c);
        const scenes::Place gravity{3, -9, space == scenes::Space::solid ? 5.0 : 0.0};
        Simulation run(scenes::rough_gas(space, c.shape, c.transfer, gravity, gas), c.integrator, {0.2, {}});
        const int steps = c.shape == "linear" ? 2 : 10;
        for (int k = 0; k < steps; ++k) {
          run.step(1);
          scenes::expect_ledger_closes(run.ledger(), 1e-13);
        }
      }
    }
  }
}

// In empty space without forces a gas keeps its momenta, and with APIC its angular momenta about all axes; rings keep
// theirs along the axis alone. [EC-APIC 1, 5]
TEST(LedgerOfARun, MomentaStayInSpace) {
  for (const char* shape : {"quadratic", "cubic"}) {
    for (scenes::Space space : scenes::spaces) {
      Simulation run(scenes::rough_gas_in_space(space, shape, "apic", scenes::no_gravity), "energy", {0.2, {}});
      for (int k = 0; k < 10; ++k) run.step(1);
      const Ledger& ledger = run.ledger();
      const bool rings = space == scenes::Space::axisymmetric;
      for (std::size_t d = rings ? 1 : 0; d < 3; ++d) {
        EXPECT_NEAR(ledger.momentum[d].store(), ledger.momentum[d].initial(), 1e-14 * ledger.momentum[d].scale());
      }
      for (const Account& turning : ledger.angular_momentum) {
        EXPECT_NEAR(turning.store(), turning.initial(), 1e-14 * turning.scale());
      }
      const std::size_t axes = space == scenes::Space::solid ? 3 : space == scenes::Space::plane ? 1 : 0;
      std::size_t turning = 0;
      for (const Account& account : ledger.angular_momentum) turning += account.store() != 0;
      EXPECT_EQ(turning, axes);
    }
  }
}

TEST(LedgerOfARun, NamesTheAccountsOfItsGeometry) {
  const auto names = [](int dim, bool axisymmetric) {
    std::vector<std::string> all;
    for (const auto& [name, account] : Ledger().accounts(dim, axisymmetric)) all.push_back(name);
    return all;
  };
  using Names = std::vector<std::string>;
  EXPECT_EQ(names(1, false), (Names{"mass", "momentum_x", "energy"}));
  EXPECT_EQ(names(2, false), (Names{"mass", "momentum_x", "momentum_y", "angular_momentum", "energy"}));
  EXPECT_EQ(names(2, true), (Names{"mass", "momentum_x", "momentum_y", "energy"}));
  EXPECT_EQ(names(3, false), (Names{"mass", "momentum_x", "momentum_y", "momentum_z", "angular_momentum_x",
                                    "angular_momentum_y", "angular_momentum_z", "energy"}));
}

TEST(LedgerOfARun, ClosesForEveryDensityAndWall) {
  for (DensityMethod method :
       {DensityMethod::cell, DensityMethod::quadratic, DensityMethod::continuity, DensityMethod::grid}) {
    for (Wall kind : {Wall::symmetry, Wall::no_slip}) {
      for (const char* integrator : {"usf", "musl", "usavg"}) {
        Scene scene = gas_and_chain(2, "cubic", "apic");
        scene.density = method;
        scene.grid.walls[1] = {kind, Wall::free};
        scene.gravity = {1, 3};
        Simulation run(scene, integrator, {0.2, {}});
        for (int k = 0; k < 10; ++k) run.step(1);
        scenes::expect_ledger_closes(run.ledger(), 1e-13);
      }
    }
  }
}

double residual_without(const Account& account, Flow dropped) {
  double flows = 0;
  for (int f = 0; f < flow_count; ++f)
    flows += static_cast<Flow>(f) == dropped ? 0 : account.flow(static_cast<Flow>(f));
  return account.store() - account.initial() - flows;
}

// The identity closes because every entry is there: without any one of those named, it is open by far more than
// rounding. The entries not named are zero to rounding.
void expect_every_flow_matters(const Account& account, const std::vector<Flow>& active, double scale) {
  for (int f = 0; f < flow_count; ++f) {
    const Flow flow = static_cast<Flow>(f);
    SCOPED_TRACE(flow_names[static_cast<std::size_t>(f)]);
    if (std::find(active.begin(), active.end(), flow) == active.end()) {
      EXPECT_LE(std::abs(account.flow(flow)), 1e-13 * scale);
    } else {
      EXPECT_LE(std::abs(account.residual()), 1e-13 * scale);
      EXPECT_GE(std::abs(residual_without(account, flow)), 1e-8 * scale);
    }
  }
}

TEST(LedgerOfARun, DroppingAnyEntryShows) {
  for (const char* transfer : {"pic", "flip", "apic"}) {
    SCOPED_TRACE(transfer);
    Simulation run(gas_and_chain(2, "quadratic", transfer), "usavg", {0.2, {}});
    for (int k = 0; k < 5; ++k) run.step(1);
    const Ledger& ledger = run.ledger();
    const bool flip = transfer == std::string("flip"), apic = transfer == std::string("apic");
    expect_every_flow_matters(ledger.energy, {Flow::body_force, Flow::transfer, Flow::constitutive, Flow::integration},
                              ledger.energy.scale());
    for (std::size_t d = 0; d < 2; ++d) {
      const Account& momentum = ledger.momentum[d];
      expect_every_flow_matters(momentum, {Flow::walls, Flow::body_force}, momentum.scale() + momentum.booked());
    }
    std::vector<Flow> angular{Flow::walls, Flow::body_force};
    if (!apic) angular.push_back(Flow::transfer);    // APIC's C keeps it
    if (flip) angular.push_back(Flow::integration);  // only FLIP moves points with another velocity than their own
    const Account& turning = ledger.angular_momentum[2];
    expect_every_flow_matters(turning, angular, turning.scale() + turning.booked());
    expect_every_flow_matters(ledger.mass, {}, ledger.mass.scale());
  }
}

// The inertia of linear shapes changes with the point's place in its cell: the affine motion's energy and spin
// with it.
TEST(LedgerOfARun, DroppingTheMovingInertiaShows) {
  Simulation run(scenes::rough_gas(2, "linear", "apic"), "musl", {0.2, {}});
  for (int k = 0; k < 5; ++k) run.step(1);
  const Ledger& ledger = run.ledger();
  expect_every_flow_matters(ledger.energy, {Flow::body_force, Flow::transfer, Flow::integration},
                            ledger.energy.scale());
  expect_every_flow_matters(ledger.angular_momentum[2], {Flow::walls, Flow::body_force, Flow::transfer},
                            ledger.angular_momentum[2].scale());
}

// A body that falls freely: m g t of momentum, and the kinetic energy of its height, both of body force.  [York
// 3.18]
TEST(LedgerOfARun, BodyForceIsWeightTimesTime) {
  for (const Choice& transfer : transfers()) {
    Scene scene = scenes::rough_gas_in_space(2, "quadratic", transfer.name, {3, -9});
    Simulation run(scene, "musl", {0.2, 0.002});
    for (int k = 0; k < 10; ++k) run.step(1);
    const double mass = run.ledger().mass.initial();
    EXPECT_NEAR(run.ledger().momentum[0].flow(Flow::body_force), mass * 3 * 0.02, 1e-15);
    EXPECT_NEAR(run.ledger().momentum[1].flow(Flow::body_force), mass * -9 * 0.02, 1e-15);
    EXPECT_NEAR(run.ledger().momentum[0].flow(Flow::walls), 0,
                1e-15 * run.ledger().momentum[0].scale());  // filters' sums
  }
}

// What gravity does is dt b . P at mid-step: for APIC and PIC, whose points move with the grid, that is m b .
// (x' - x) of the centre of mass less its last half step, exactly, when nothing but gravity acts.
TEST(LedgerOfARun, BodyForceWorksOverTheWay) {
  Scene scene = scenes::rough_gas_in_space(2, "quadratic", "apic", {3, -9});
  const double dt = 0.002;
  const int steps = 10;
  const Scene start = scene;
  Simulation run(scene, "musl", {0.2, dt});
  for (int k = 0; k < steps; ++k) run.step(1);
  double fall = 0;
  for (int d = 0; d < 2; ++d) {
    const auto m = scenes::by_id(start.bodies[0], column::mass),
               x0 = scenes::by_id(start.bodies[0], column::position, d),
               x1 = scenes::by_id(run.scene().bodies[0], column::position, d);
    for (std::size_t p = 0; p < m.size(); ++p) fall += m[p] * start.gravity[d] * (x1[p] - x0[p]);
  }
  // Points move with the velocity at the end of the step, the work is that of its middle: dt^2 g^2 / 2 less,
  // each step.
  const double expected = fall - steps * run.ledger().mass.initial() * dt * dt * (9 + 81) / 2;
  EXPECT_NEAR(run.ledger().energy.flow(Flow::body_force), expected, 1e-14);
}

}  // namespace
}  // namespace plumbline::ledger_test
