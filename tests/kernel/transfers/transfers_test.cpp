#include "kernel/shapes/shape.hpp"
#include "kernel/transfers/transfer.hpp"

#include "tests/kernel/scenes.hpp"

namespace plumbline::transfers_test {
namespace {

// Two points in one linear cell and a uniform pull b: M = sum m N, v = sum m N v / M; FLIP adds dt b to each
// point's own velocity, PIC and APIC give it the interpolated one. [York 3.15, 3.16, 3.18, 3.20-3.22]
TEST(Transfers, OfTwoPoints) {
  const double m[2] = {1, 3}, x[2] = {0.25, 0.75}, v[2] = {2, -1}, b = 5, dt = 0.1;
  const double left = (0.75 * m[0] * v[0] + 0.25 * m[1] * v[1]) / (0.75 * m[0] + 0.25 * m[1]);
  const double right = (0.25 * m[0] * v[0] + 0.75 * m[1] * v[1]) / (0.25 * m[0] + 0.75 * m[1]);
  EXPECT_NEAR(left, 0.5, 1e-15);
  EXPECT_NEAR(right, -0.7, 1e-15);
  for (const std::string& transfer : {std::string("pic"), std::string("flip"), std::string("apic")}) {
    Body body = scenes::gas_body({}, 1, {{x[0], 0}, {x[1], 0}}, 1, [](auto&) {
      return scenes::GasState{1, 0, {0, 0}};
    });
    for (int p = 0; p < 2; ++p) {
      body.points(column::mass)[p] = m[p];
      body.points(column::velocity)[p] = v[p];
    }
    Simulation run(scenes::scene_of(scenes::line(1, 1), {body}, "linear", transfer, {b, 0}), "usl", {0.3, dt});
    run.step(1);
    const Columns& points = run.scene().bodies[0].points;
    for (int p = 0; p < 2; ++p) {
      const double grid = (1 - x[p]) * left + x[p] * right + dt * b;
      EXPECT_NEAR(points(column::velocity)[p], transfer == "flip" ? v[p] + dt * b : grid, 1e-15);
      EXPECT_NEAR(points(column::position)[p], x[p] + dt * grid, 1e-15);
      if (transfer == "apic") {  // [EC-APIC 5]
        EXPECT_NEAR(points(column::affine)[p], right - left, 1e-15);
      }
    }
  }
}

// With walls on three sides, both maps lose exactly what the ledger says they lose: cold gas without forces
// changes its kinetic energy (C's share included) by A and B alone. Sums of some thousand terms: 1e-14.
// [EC-APIC 1, 5] [EC-APIC walls]
TEST(Transfers, LossesAtWallsAreExact) {
  for (Wall kind : {Wall::symmetry, Wall::no_slip}) {
    for (scenes::Space space : scenes::spaces) {
      for (const Choice& shape : scenes::shapes_in_space()) {
        for (const Choice& transfer : transfers()) {
          if (scenes::of_a_test(transfer.name)) continue;
          Scene scene = scenes::rough_gas(space, shape.name, transfer.name, scenes::no_gravity, {});
          scene.grid.walls = scenes::walls(kind, Wall::symmetry, kind, Wall::free, Wall::symmetry, kind);
          Columns& points = scene.bodies[0].points;
          std::fill_n(points(column::energy), points.points(), 0.0);
          Simulation run(scene, "usl", {0.3, 0.01});
          for (int k = 0; k < 5; ++k) run.step(1);
          const Account& energy = run.ledger().energy;
          EXPECT_LE(energy.relative_drift(false), 1e-14) << shape.name << ' ' << transfer.name;
          EXPECT_EQ(run.ledger().stores.internal, 0);
          EXPECT_EQ(energy.flow(Flow::integration), 0);
          // FLIP adds velocity changes, and without forces there are none; the others filter random velocities away, but
          // for fmpm, whose filter gives energy as well.
          if (transfer.name == "flip") {
            EXPECT_EQ(energy.flow(Flow::transfer), 0);
          } else if (transfer.name != "fmpm") {
            EXPECT_LT(energy.flow(Flow::transfer), -0.01 * energy.initial());
          }
        }
      }
    }
  }
}

// A_p and B_p are sums of squares: no point gains by a map. [EC-APIC 1, 5]
TEST(Transfers, NoPointGainsByTheMaps) {
  for (const char* transfer : {"pic", "apic"}) {
    for (const char* shape : {"quadratic", "cubic"}) {
      Scene scene = scenes::rough_gas(2, shape, transfer);
      Ledger ledger;
      const auto engine = make_engine(scene, ledger, {.keep_loss = true});
      engine->initialise();
      engine->locate_points();
      engine->map_mass_and_momentum();
      const Columns& points = scene.bodies[0].points;
      std::vector<double> a(points(column::transfer_loss), points(column::transfer_loss) + points.points());
      engine->map_forces();
      engine->advance_momentum(0.01);
      engine->move_points(0.01);
      for (int p = 0; p < points.points(); ++p) {
        EXPECT_GE(a[static_cast<std::size_t>(p)], 0);
        EXPECT_GE(points(column::transfer_loss)[p], a[static_cast<std::size_t>(p)]);
      }
    }
  }
}

// A cold gas that drifts stays cold: its losses are zero, and their rounding is no reason to stop. [EC-APIC 5, 6]
TEST(Transfers, AColdGasDrifts) {
  for (int dim : {1, 2, 3}) {
    for (const char* transfer : {"pic", "apic"}) {
      Scene scene = scenes::rough_gas_in_space(scenes::space_of(dim), "quadratic", transfer, scenes::no_gravity, {});
      Columns& points = scene.bodies[0].points;
      for (int d = 0; d < dim; ++d) std::fill_n(points(column::velocity, d), points.points(), 0.1 + 0.03 * d);
      std::fill_n(points(column::energy), points.points(), 0.0);
      Simulation run(scene, "energy", {0.3, 0.01});
      for (int k = 0; k < 10; ++k) run.step(1);
      for (double e : scenes::by_id(run.scene().bodies[0], column::energy)) EXPECT_LE(e, 1e-16);
    }
  }
}

// APIC conserves angular momentum where nothing is near, spin of the points included; PIC and FLIP do not, and
// book it.
TEST(Transfers, ApicConservesAngularMomentum) {
  for (const char* shape : {"linear", "quadratic", "cubic"}) {
    Scene scene = scenes::rough_gas_in_space(2, shape, "apic", {0, 0});
    Simulation run(scene, "musl", {0.2, {}});
    for (int k = 0; k < 10; ++k) run.step(1);
    const Account& angular = run.ledger().angular_momentum[2];
    if (std::string(shape) != "linear") {
      EXPECT_NEAR(angular.store(), angular.initial(), 1e-14 * angular.scale());
    }
    EXPECT_LE(angular.relative_drift(false), 1e-14);
  }
}

}  // namespace
}  // namespace plumbline::transfers_test
