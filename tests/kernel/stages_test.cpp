// Beside the stages of the material point method, an integrator may ask for the state and its rate and combine
// states.
#include "kernel/stages.hpp"

#include <functional>
#include <limits>
#include <stdexcept>

#include "tests/kernel/scenes.hpp"

namespace plumbline::stages_test {
namespace {

class Heun final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    const State y = mpm.state(), k1 = mpm.rate();
    mpm.set_state(y + dt * k1);
    const State k2 = mpm.rate();
    mpm.set_state(y + dt / 2 * (k1 + k2));
  }
};
PLUMBLINE_INTEGRATOR(Heun, "test_heun", "Runge-Kutta of order two", "Heun 1900");

class RungeKutta4 final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    const State y = mpm.state(), k1 = mpm.rate();
    mpm.set_state(y + dt / 2 * k1);
    const State k2 = mpm.rate();
    mpm.set_state(y + dt / 2 * k2);
    const State k3 = mpm.rate();
    mpm.set_state(y + dt * k3);
    const State k4 = mpm.rate();
    mpm.set_state(y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4));
  }
};
PLUMBLINE_INTEGRATOR(RungeKutta4, "test_rk4", "Runge-Kutta of order four", "Kutta 1901");

TEST(State, IsALinearSpace) {
  const State a{{1, 2}}, b{{10, 20}};
  EXPECT_EQ((a + b).values, (std::vector<double>{11, 22}));
  EXPECT_EQ((3 * a + 0.5 * b).values, (std::vector<double>{8, 16}));
}

// A spring of four points and a column of gas, each on linear shapes with every point well inside its cell
// throughout: the semi-discrete equations are smooth, and only the time integrator's error is left.
Scene spring() {
  UniaxialMembrane law;
  law.youngs_modulus = law.density = 1;
  law.one_way = false;
  const GridSpec grid = scenes::line(5, 1, scenes::walls(Wall::no_slip, Wall::free));
  return scenes::scene_of(grid,
                          {scenes::membrane_body(law, 1, scenes::lattice(grid, 1, {0, 0}, {4, 1}), 1,
                                                 [](const scenes::Place& x) {
                                                   return scenes::Place{0.02 * x[0], 0};
                                                 })},
                          "linear", "flip", {0.002, 0});
}
Scene gas_column() {
  IdealGas gas;
  gas.viscosity = 0.05;
  const GridSpec grid = scenes::line(4, 1, scenes::walls(Wall::symmetry, Wall::symmetry));
  Scene scene = scenes::scene_of(grid,
                                 {scenes::gas_body(gas, 1, scenes::lattice(grid, 2), 0.5,
                                                   [](const scenes::Place& x) {
                                                     return scenes::GasState{1, 1, {0.1 * std::sin(0.7 * x[0]), 0}};
                                                   })},
                                 "linear", "flip");
  scene.density = DensityMethod::continuity;
  return scene;
}

std::vector<double> state_after(const Scene& scene, const std::string& integrator, double dt) {
  Simulation run(scene, integrator, {0.3, dt});
  run.run_until(3.2);
  const Body& body = run.scene().bodies[0];
  std::vector<double> values = scenes::by_id(body, column::position);
  for (const ColumnId* id : {&column::velocity, body.points.has(column::energy) ? &column::energy : &column::strain}) {
    const auto more = scenes::by_id(body, *id);
    values.insert(values.end(), more.begin(), more.end());
  }
  return values;
}

// E(dt) = C dt^p (1 + O(dt)): between the two finest steps the observed order is within a tenth of p.
void expect_order(const Scene& scene, const std::string& integrator, double coarsest, double order) {
  const auto exact = state_after(scene, "test_rk4", coarsest / 64);
  const auto error = [&](double dt) {
    const auto values = state_after(scene, integrator, dt);
    double worst = 0;
    for (std::size_t k = 0; k < values.size(); ++k) worst = std::max(worst, std::abs(values[k] - exact[k]));
    return worst;
  };
  EXPECT_NEAR(std::log2(error(coarsest / 4) / error(coarsest / 8)), order, 0.1);
  EXPECT_NEAR(std::log2(error(coarsest / 2) / error(coarsest / 4)), order, 0.2);
}

TEST(Stages, RungeKuttaOnASpring) {
  expect_order(spring(), "test_heun", 0.2, 2);
  expect_order(spring(), "test_rk4", 0.4, 4);
}
TEST(Stages, RungeKuttaOnAGas) {
  expect_order(gas_column(), "test_heun", 0.1, 2);
  expect_order(gas_column(), "test_rk4", 0.2, 4);
}

// The same measure on York's step: of first order in dt.
TEST(Stages, MuslIsOfFirstOrder) { expect_order(spring(), "musl", 0.05, 1); }

TEST(Stages, StatesAreReadAndSetExactly) {
  Scene scene = scenes::rough_gas(2, "quadratic", "flip");
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  const Columns before = scene.bodies[0].points;
  const State state = engine->state();
  EXPECT_EQ(state.values.size(), static_cast<std::size_t>(5 * before.points()));  // x, v and e
  engine->set_state(state + 0.5 * state);
  EXPECT_EQ(scene.bodies[0].points(column::velocity, 1)[3], 1.5 * before(column::velocity, 1)[3]);
  EXPECT_EQ(scene.bodies[0].points(column::energy)[3], 1.5 * before(column::energy)[3]);
  engine->set_state(state);
  EXPECT_EQ(engine->state().values, state.values);
}

// Trial states of a solver may hold a million times the energy of the step's end: the ledger closes to a rounding of the latter.
TEST(Stages, TrialStatesLeaveNoRoundingInTheLedger) {
  Scene scene = scenes::rough_gas(2, "quadratic", "flip");
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  ledger.open(engine->totals());
  const State state = engine->state();
  for (int trial = 0; trial < 100; ++trial) engine->set_state((1e6 + trial / 3.0) * state);
  engine->set_state(1.01 * state);
  ledger.close_step(engine->totals());
  EXPECT_LE(ledger.energy.relative_drift(false), 4 * std::numeric_limits<double>::epsilon());
}

// Velocities of all bodies are kept, all else is zero: of a gas (x, v, e), of an elastic body (x, v, strain).
TEST(Stages, VelocitiesOfAState) {
  Scene scene = scenes::rough_gas(2, "quadratic", "flip");
  UniaxialMembrane law;
  law.youngs_modulus = law.density = 1;
  scene.bodies.push_back(scenes::membrane_body(law, 2, {{0.2, 0.2}, {0.25, 0.2}}, 0.01, [](const scenes::Place& x) {
    return scenes::Place{x[0], 3};
  }));
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  const State state = engine->state(), velocities = engine->velocities_of(state);
  ASSERT_EQ(velocities.values.size(), state.values.size());
  const auto gas = static_cast<std::size_t>(scene.bodies[0].points.points()), all = state.values.size();
  for (std::size_t k = 0; k < all; ++k) {
    const bool of_gas = k >= 2 * gas && k < 4 * gas;
    const bool of_membrane = k >= 5 * gas + 4 && k < 5 * gas + 8;
    EXPECT_EQ(velocities.values[k], of_gas || of_membrane ? state.values[k] : 0) << k;
  }
  EXPECT_EQ(state.values[5 * gas + 6], 3);
}

// The rate of a free fall: dx/dt = v, dv/dt = b, de/dt = 0, wherever the points stand. [York 3.18, 3.21, 3.22]
TEST(Stages, RateOfAFreeFall) {
  Scene scene = scenes::rough_gas_in_space(scenes::Space::plane, "quadratic", "flip", scenes::rough_gravity, {});
  Columns& points = scene.bodies[0].points;
  const int n = points.points();
  for (int d = 0; d < 2; ++d) std::fill_n(points(column::velocity, d), n, 0.5 + d);
  std::fill_n(points(column::energy), n, 0.0);
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  const State rate = engine->rate();
  const double expected[5] = {0.5, 1.5, 3, -9, 0};
  for (int p = 0; p < n; ++p) {
    for (int k = 0; k < 5; ++k) EXPECT_NEAR(rate.values[static_cast<std::size_t>(k * n + p)], expected[k], 1e-13);
  }
}

// Masses mapped from where nobody has looked would be written anywhere.
TEST(Stages, MapsWantThePointsLocated) {
  Scene scene = scenes::rough_gas(1, "quadratic", "apic");
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  engine->points_changed(0);
  EXPECT_THROW(engine->map_mass_and_momentum(), std::logic_error);
  engine->locate_points();
  EXPECT_NO_THROW(engine->map_mass_and_momentum());
}

// After what ends a step, after a drift, and after a state was set, the weights are of places where the points no longer are.
TEST(Stages, WeightsAreOfThePlacesWherePointsWereLocated) {
  Scene scene = scenes::rough_gas(1, "quadratic", "flip");
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {.keep_loss = true});
  engine->initialise();
  const std::vector<std::function<void(double)>> ends{
      [&](double dt) { engine->drift_points(dt); }, [&](double dt) { engine->finish_points(dt, {}); },
      [&](double dt) { engine->finish_points(dt, dt); }, [&](double) { engine->set_state(engine->state()); }};
  const std::vector<std::function<void()>> users{[&] { engine->map_mass_and_momentum(); },
                                                 [&] { engine->map_momentum(); },
                                                 [&] { engine->map_forces(); },
                                                 [&] { engine->advance_momentum(1e-4); },
                                                 [&] { engine->move_points(1e-4, NodalVelocity::end); },
                                                 [&] { engine->kick_points(1e-4); },
                                                 [&] { engine->strain_points(1e-4, NodalVelocity::start); },
                                                 [&] { engine->evaluate_stress(NodalVelocity::start); },
                                                 [&] { engine->predict_stress(1e-4, NodalVelocity::start); },
                                                 [&] { engine->predict_stress_and_map_forces(1e-4); },
                                                 [&] { engine->reverse_cooling(); },
                                                 [&] { engine->return_transfer_loss(); },
                                                 [&] { engine->finish_points(1e-4, {}); },
                                                 [&] { engine->finish_points(1e-4, 1e-4); }};
  for (const auto& end : ends) {
    engine->locate_points();
    engine->map_mass_and_momentum();
    engine->map_forces();
    engine->advance_momentum(1e-4);
    end(1e-4);
    for (std::size_t k = 0; k < users.size(); ++k) EXPECT_THROW(users[k](), std::logic_error) << k;
  }
  engine->locate_points();
  engine->map_mass_and_momentum();
  engine->map_forces();
  engine->advance_momentum(1e-4);
  engine->move_points(1e-4, NodalVelocity::end);
  engine->drift_points(1e-4);
  engine->set_state(engine->state());
  EXPECT_NO_THROW(engine->map_momentum()) << "the stage that moved them kept their places";
}

TEST(Stages, AStateOfAnotherSizeIsNone) {
  Scene scene = scenes::rough_gas(1, "quadratic", "flip");
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  const State right = engine->state();
  for (const std::size_t size : {std::size_t{0}, right.values.size() - 1, right.values.size() + 1}) {
    State wrong = right;
    wrong.values.resize(size);
    EXPECT_THROW(engine->set_state(wrong), std::invalid_argument) << size;
    EXPECT_THROW(engine->velocities_of(wrong), std::invalid_argument) << size;
    EXPECT_THROW(right + wrong, std::invalid_argument) << size;
  }
  EXPECT_EQ(engine->state().values, right.values);
}

TEST(Stages, RatesWantFlip) {
  Scene scene = scenes::rough_gas(1, "quadratic", "apic");
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  engine->initialise();
  EXPECT_THROW(engine->rate(), std::logic_error);
}

}  // namespace
}  // namespace plumbline::stages_test
