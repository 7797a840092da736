#include <Eigen/LU>

#include "tests/kernel/dense.hpp"
#include "tests/kernel/integrators/recording.hpp"

namespace plumbline::leapfrog_test {
namespace {

// Drift, kick, drift, the stress of the middle between. [EC-APIC 1, 4-6] [Leapfrog 1-3]
TEST(Leapfrog, Order) {
  EXPECT_EQ(calls_of("leapfrog"),
            (std::vector<std::string>{"drift_points dt/2", "locate_points", "map_mass_and_momentum",
                                      "predict_stress dt/2", "map_forces", "advance_momentum dt", "kick_points dt",
                                      "drift_points dt/2", "strain_points dt midpoint", "return_transfer_loss"}));
}

TEST(Leapfrog, RefusesWhatCannotWork) {
  const IntegratorEntry& entry = *find_integrator("leapfrog");
  for (const char* transfer : {"pic", "flip", "apic"}) EXPECT_FALSE(lacks(entry, "linear", transfer).empty());
  EXPECT_FALSE(lacks(entry, "quadratic", "flip").empty());
  EXPECT_TRUE(lacks(entry, "cubic", "apic").empty());
}

// Cold gas is thrown at a wall: what drifts beyond it comes back with its velocity along the wall, where that is smooth, and
// with the opposite one where it holds. [EC-APIC walls]
TEST(Leapfrog, PointsComeBackFromWalls) {
  for (const Wall kind : {Wall::symmetry, Wall::no_slip}) {
    IdealGas gas;
    gas.gamma = 1.4;
    const GridSpec grid = scenes::plane(8, 8, 0.1, scenes::walls(kind, Wall::free));
    Scene scene = scenes::scene_of(grid,
                                   {scenes::gas_body(gas, 2, {{0.01, 0.4, 0}, {0.41, 0.4, 0}}, 0.0025,
                                                     [](const scenes::Place&) {
                                                       return scenes::GasState{1, 1e-12, {-1, 0.5}};
                                                     })},
                                   "quadratic", "apic");
    Ledger ledger;
    const auto engine = make_engine(scene, ledger, {});
    engine->initialise();
    engine->drift_points(0.03);
    const auto x = scenes::by_id(scene.bodies[0], column::position, 0);
    const auto y = scenes::by_id(scene.bodies[0], column::position, 1);
    const auto across = scenes::by_id(scene.bodies[0], column::velocity, 0);
    const auto along = scenes::by_id(scene.bodies[0], column::velocity, 1);
    EXPECT_NEAR(x[0], 0.02, 1e-15);
    EXPECT_NEAR(x[1], 0.38, 1e-15);
    EXPECT_NEAR(y[0], 0.415, 1e-15);
    EXPECT_EQ(across[0], 1);
    EXPECT_EQ(across[1], -1);
    EXPECT_EQ(along[0], kind == Wall::symmetry ? 0.5 : -0.5);
    EXPECT_EQ(along[1], 0.5);
  }
}

// One degree of freedom behind the stages, without the losses of maps: a mass on a spring, of which the share `by_place` pulls by
// where the mass was located (as a gas by its density) and the rest by a strain that is advanced (as a gas by
// its energy, a membrane by its strain).
class Oscillator final : public Stages {
 public:
  double x, v, strain, omega, by_place;

  Oscillator(double place, double velocity, double frequency, double share)
      : x(place),
        v(velocity),
        strain(place),
        omega(frequency),
        by_place(share) {}

  void locate_points() override { located_ = x; }
  void map_mass_and_momentum() override { start_ = v; }
  void predict_stress(double ahead, NodalVelocity) override { stress_ = pull(strain + ahead * start_); }
  void evaluate_stress(NodalVelocity) override { stress_ = pull(strain); }
  void map_forces() override {}
  void advance_momentum(double dt) override { end_ = start_ + dt * stress_; }
  void move_points(double dt, NodalVelocity) override {
    v = end_;
    x += dt * v;
  }
  void drift_points(double dt) override { x += dt * v; }
  void kick_points(double) override { v = end_; }
  void map_momentum() override {}
  void strain_points(double dt, NodalVelocity velocity) override {
    EXPECT_EQ(velocity, NodalVelocity::midpoint);
    strain += dt * (start_ + end_) / 2;
  }
  bool reverse_cooling() override { return false; }
  void return_transfer_loss() override {}
  State state() const override { return {}; }
  void set_state(const State&) override {}
  State rate() override { return {}; }
  State velocities_of(State state) const override { return state; }

 private:
  double pull(double by_strain) const { return -omega * omega * (by_place * located_ + (1 - by_place) * by_strain); }
  double located_ = 0, start_ = 0, end_ = 0, stress_ = 0;
};

// What a step makes of (x, v), from two oscillators.
Eigen::Matrix2d amplification(const std::string& integrator, double omega_dt, double by_place) {
  Eigen::Matrix2d m;
  for (int k = 0; k < 2; ++k) {
    Oscillator one(k == 0, k == 1, omega_dt, by_place);
    find_integrator(integrator)->make()->step(one, 1);
    m(0, k) = one.x;
    m(1, k) = one.v;
    EXPECT_NEAR(one.x, integrator == "leapfrog" ? one.strain : one.x, 1e-15);  // place and strain stay together
  }
  return m;
}

// An oscillation is neither damped nor amplified, the determinant is one, as long as omega dt < 2; beyond it grows:
// the trace is 2 - (omega dt)^2. By place, by strain, and as a gas of gamma 1.4 by both. [Leapfrog 1-3]
TEST(Leapfrog, KeepsTheAmplitudeOfAnOscillation) {
  for (const double by_place : {0.0, 1 / 1.4, 1.0}) {
    for (const double omega_dt : {0.01, 0.5, 1.0, 1.5, 1.99, 2.01, 2.5}) {
      const Eigen::Matrix2d m = amplification("leapfrog", omega_dt, by_place);
      EXPECT_NEAR(m.determinant(), 1, 1e-14);
      EXPECT_NEAR(m.trace(), 2 - omega_dt * omega_dt, 1e-14);
      const double radius = dense::spectral_radius(m);
      if (omega_dt < 2) {
        EXPECT_NEAR(radius, 1, 1e-12);
      } else {
        EXPECT_GT(radius, 1.01);
      }
    }
  }
}

// Its frequency: cos(w dt) = 1 - (omega dt)^2 / 2, so w = omega (1 + (omega dt)^2 / 24 + ...), second order in dt. With half the
// step a quarter of the error, to the next term's share, 9/80 (omega dt)^2 of it. [Leapfrog 1-3]
TEST(Leapfrog, FrequencyIsOfSecondOrder) {
  const auto error = [](double dt) { return std::acos(amplification("leapfrog", dt, 1 / 1.4).trace() / 2) / dt - 1; };
  EXPECT_NEAR(error(0.1), 0.01 / 24, 0.01 * 0.01 / 24);
  EXPECT_NEAR(error(0.2) / error(0.1), 4, 4 * 9.0 / 80 * 0.04);
}

// The same through the kernel: without forces points fly straight, and the step's two halves make one. [Leapfrog 1, 3]
TEST(Leapfrog, DustFliesStraight) {
  for (scenes::Space space : scenes::spaces) {
    Scene scene = scenes::rough_gas_in_space(space, "cubic", "pic", scenes::no_gravity, {});
    Columns& points = scene.bodies[0].points;
    const int dim = scene.grid.dim;
    for (int d = 0; d < dim; ++d) std::fill_n(points(column::velocity, d), points.points(), 0.0);
    const int along = space == scenes::Space::axisymmetric ? 1 : 0;
    std::fill_n(points(column::velocity, along), points.points(), 0.25);
    std::fill_n(points(column::energy), points.points(), 0.0);
    Simulation run(scene, "leapfrog", {0.3, 0.1});
    for (int k = 0; k < 4; ++k) run.step(1);
    const auto from = scenes::by_id(scene.bodies[0], column::position, along),
               to = scenes::by_id(run.scene().bodies[0], column::position, along);
    for (std::size_t p = 0; p < to.size(); ++p) EXPECT_NEAR(to[p], from[p] + 0.1, 1e-14);
  }
}

// Walls send points back that pass them in a drift: place, normal velocity and its gradient turn round, and the momentum that this
// takes is the walls'. [Leapfrog 1] [EC-APIC walls]
TEST(Leapfrog, WallsSendPointsBack) {
  for (Wall kind : {Wall::symmetry, Wall::no_slip}) {
    const GridSpec grid = scenes::plane(4, 4, 1, scenes::walls_everywhere(kind));
    Scene scene = scenes::scene_of(
        grid,
        {scenes::gas_body(
            {}, 2, {{3.9, 2, 0}, {1.3, 0.1, 0}}, 0.1,
            [](const scenes::Place& x) {
              return x[0] > 2 ? scenes::GasState{1, 0, {0.8, 0.3, 0}} : scenes::GasState{2, 0, {0.2, -0.6, 0}};
            })},
        "quadratic", "apic");
    Ledger ledger;
    const auto engine = make_engine(scene, ledger, {});
    engine->initialise();
    const Totals before = engine->totals();
    engine->drift_points(0.5);
    const auto x = [&](int d) { return scenes::by_id(scene.bodies[0], column::position, d); };
    const auto v = [&](int d) { return scenes::by_id(scene.bodies[0], column::velocity, d); };
    const double tangential = kind == Wall::no_slip ? -1 : 1;
    EXPECT_NEAR(x(0)[0], 8 - 4.3, 1e-15);
    EXPECT_NEAR(x(1)[0], 2.15, 1e-15);
    EXPECT_NEAR(x(1)[1], 0.2, 1e-15);
    EXPECT_EQ(v(0)[0], -0.8);
    EXPECT_EQ(v(1)[0], 0.3 * tangential);
    EXPECT_EQ(v(0)[1], 0.2 * tangential);
    EXPECT_EQ(v(1)[1], 0.6);
    const Totals after = engine->totals();
    for (std::size_t d = 0; d < 2; ++d) {
      EXPECT_NEAR(ledger.momentum[d].flow(Flow::walls), after.momentum[d] - before.momentum[d], 1e-15);
      EXPECT_GT(std::abs(ledger.momentum[d].flow(Flow::walls)), 0.01);
    }
    EXPECT_NEAR(ledger.angular_momentum[2].flow(Flow::walls), after.angular_momentum[2] - before.angular_momentum[2],
                1e-15);
    EXPECT_EQ(after.energy.kinetic, before.energy.kinetic);
  }
}

}  // namespace
}  // namespace plumbline::leapfrog_test
