#include "tests/kernel/integrators/recording.hpp"

namespace plumbline::energy_test {
namespace {

// [EC-APIC 1-6] in their order.
TEST(EnergyConserving, Order) {
  EXPECT_EQ(calls_of("energy"),
            (std::vector<std::string>{"locate_points", "map_mass_and_momentum", "evaluate_stress start", "map_forces",
                                      "advance_momentum dt", "reverse_cooling", "move_points dt",
                                      "strain_points dt midpoint", "return_transfer_loss"}));
}

// [EC-APIC viscous heat] one more pass over forces and momentum where viscosity would have cooled.
TEST(EnergyConserving, OrderWhereViscosityWouldCool) {
  EXPECT_EQ(calls_of("energy", true),
            (std::vector<std::string>{"locate_points", "map_mass_and_momentum", "evaluate_stress start", "map_forces",
                                      "advance_momentum dt", "reverse_cooling", "map_forces", "advance_momentum dt",
                                      "move_points dt", "strain_points dt midpoint", "return_transfer_loss"}));
}

TEST(EnergyConserving, RefusesWhatCannotWork) {
  const IntegratorEntry& entry = *find_integrator("energy");
  for (const char* transfer : {"pic", "flip", "apic"}) EXPECT_FALSE(lacks(entry, "linear", transfer).empty());
  for (const char* shape : {"linear", "quadratic", "cubic"}) EXPECT_FALSE(lacks(entry, shape, "flip").empty());
  for (const char* shape : {"quadratic", "cubic"}) {
    EXPECT_TRUE(lacks(entry, shape, "apic").empty());
    EXPECT_TRUE(lacks(entry, shape, "pic").empty());
  }
}

// Total energy itself, not only the residual, stays: 200 steps of a violent gas between walls, to 1e-13 of the
// total, which is the square root of 200 x 3000 roundings of the largest terms with a factor of ten to spare.
// [EC-APIC 6]
void expect_conserved_energy(scenes::Space space, const IdealGas& gas) {
  for (const char* shape : {"quadratic", "cubic"}) {
    for (const char* transfer : {"pic", "apic"}) {
      for (Wall kind : {Wall::symmetry, Wall::no_slip}) {
        SCOPED_TRACE(testing::Message() << shape << ' ' << transfer << ' ' << static_cast<int>(kind));
        Scene scene = scenes::rough_gas(space, shape, transfer, scenes::no_gravity, gas);
        scene.grid.walls = scenes::walls_everywhere(kind);
        if (scene.grid.axisymmetric) scene.grid.walls[0][0] = Wall::symmetry;  // the axis
        Simulation run(scene, "energy", {0.3, {}});
        double worst = 0;
        for (int k = 0; k < 200; ++k) {
          run.step(1);
          worst = std::max(worst, std::abs(run.ledger().energy.store() - run.ledger().energy.initial()));
        }
        EXPECT_LE(worst, 1e-13 * run.ledger().energy.scale());
        scenes::expect_ledger_closes(run.ledger(), 1e-13);
        for (Flow flow : {Flow::transfer, Flow::integration, Flow::constitutive}) {
          EXPECT_LE(std::abs(run.ledger().energy.flow(flow)), 1e-13 * run.ledger().energy.scale());
        }
        EXPECT_NE(run.ledger().stores.kinetic, run.ledger().initial_stores.kinetic);
      }
    }
  }
}
TEST(EnergyConserving, ConservesEnergyBetweenWallsOnALine) {
  expect_conserved_energy(scenes::Space::line, scenes::rough_law());
  expect_conserved_energy(scenes::Space::line, scenes::inviscid_law());
}
TEST(EnergyConserving, ConservesEnergyBetweenWallsInThePlane) {
  expect_conserved_energy(scenes::Space::plane, scenes::rough_law());
  expect_conserved_energy(scenes::Space::plane, scenes::inviscid_law());
}
TEST(EnergyConserving, ConservesEnergyBetweenWallsOfRings) {
  expect_conserved_energy(scenes::Space::axisymmetric, scenes::rough_law());
  expect_conserved_energy(scenes::Space::axisymmetric, scenes::inviscid_law());
}
TEST(EnergyConserving, ConservesEnergyBetweenWallsInSpace) {
  expect_conserved_energy(scenes::Space::solid, scenes::rough_law());
  expect_conserved_energy(scenes::Space::solid, scenes::inviscid_law());
}

// With gravity, the total changes by its work alone.
TEST(EnergyConserving, GravityIsAllThatChangesTheTotal) {
  Simulation run(scenes::rough_gas(2, "quadratic", "apic"), "energy", {0.3, {}});
  for (int k = 0; k < 50; ++k) run.step(1);
  const Account& energy = run.ledger().energy;
  EXPECT_NEAR(energy.store() - energy.initial(), energy.flow(Flow::body_force), 1e-13 * energy.scale());
  EXPECT_GT(std::abs(energy.flow(Flow::body_force)), 1e-3 * energy.scale());
}

// A membrane has no heat to hold what the maps take: it stays booked as lost. [EC-APIC 6]
TEST(EnergyConserving, MembranesLoseWhatTheMapsTake) {
  UniaxialMembrane law;
  law.youngs_modulus = law.density = 1;
  const GridSpec grid = scenes::line(8, 0.1);
  std::vector<scenes::Place> places;
  for (int k = 0; k < 12; ++k) places.push_back({0.21 + 0.03 * k, 0});
  Simulation run(scenes::scene_of(grid,
                                  {scenes::membrane_body(law, 1, places, 0.03,
                                                         [](const scenes::Place& x) {
                                                           return scenes::Place{std::sin(40 * x[0]), 0};
                                                         })},
                                  "quadratic", "apic"),
                 "energy", {0.3, {}});
  for (int k = 0; k < 5; ++k) run.step(1);
  EXPECT_LT(run.ledger().energy.flow(Flow::transfer), -1e-3 * run.ledger().energy.scale());
  scenes::expect_ledger_closes(run.ledger(), 1e-13);
}

IdealGas viscous(double mu, double linear, double quadratic) {
  IdealGas gas;
  gas.viscosity = mu;
  gas.viscosity_linear = linear;
  gas.viscosity_quadratic = quadratic;
  return gas;
}

// A gas that closes slowly while its pressure is about to throw it apart: over the step it expands everywhere,
// so the viscosity that the start's velocity called for would take heat out.
Scene about_to_turn(const IdealGas& gas) {
  const GridSpec grid = scenes::line(10, 0.1);
  const auto places = scenes::lattice(grid, 3, {3, 0}, {7, 1});
  return scenes::scene_of(grid,
                          {scenes::gas_body(gas, 1, places, 0.1 / 3,
                                            [](const scenes::Place& x) {
                                              const double s = (x[0] - 0.5) / 0.25;
                                              return scenes::GasState{1, 2 - s * s, {-0.1 * (x[0] - 0.5), 0}};
                                            })},
                          "quadratic", "apic");
}

double heat_of_one_step(Scene scene, bool reverse, bool& reversed) {
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {.keep_loss = true});
  const double dt = 0.02;
  engine->initialise();
  engine->locate_points();
  engine->map_mass_and_momentum();
  engine->evaluate_stress(NodalVelocity::start);
  engine->map_forces();
  engine->advance_momentum(dt);
  reversed = reverse && engine->reverse_cooling();
  if (reversed) {
    engine->map_forces();
    engine->advance_momentum(dt);
  }
  engine->move_points(dt);
  return ledger.viscous;
}

TEST(EnergyConserving, ReversesCooling) {
  for (const IdealGas& gas : {viscous(0.01, 0, 0), viscous(0, 0.2, 0.5)}) {
    bool reversed = false;
    EXPECT_LT(heat_of_one_step(about_to_turn(gas), false, reversed), 0);
    const double heat = heat_of_one_step(about_to_turn(gas), true, reversed);
    EXPECT_TRUE(reversed);
    EXPECT_GE(heat, 0);
    Simulation run(about_to_turn(gas), "energy", {0.3, 0.02});
    run.step(1);
    EXPECT_EQ(run.ledger().viscous, heat);
    scenes::expect_ledger_closes(run.ledger(), 1e-13);
  }
}

// Step by step, whatever the gas does, viscosity gives heat. [EC-APIC viscous heat]
TEST(EnergyConserving, ViscosityAlwaysHeats) {
  for (scenes::Space space : scenes::spaces) {
    for (const IdealGas& gas : {viscous(0.02, 0, 0), viscous(0.3, 0, 0), viscous(0, 0.2, 0.5), viscous(0.01, 1, 1)}) {
      Scene scene = scenes::rough_gas(space, "quadratic", "apic", scenes::no_gravity, gas);
      scene.grid.walls = scenes::walls_everywhere(Wall::symmetry);
      Simulation run(scene, "energy", {0.5, {}});
      double before = 0;
      for (int k = 0; k < 100; ++k) {
        run.step(1);
        EXPECT_GE(run.ledger().viscous, before) << "step " << k;
        before = run.ledger().viscous;
      }
      EXPECT_GT(before, 0);
      EXPECT_LT(before, run.ledger().stores.internal);
    }
  }
}

}  // namespace
}  // namespace plumbline::energy_test
