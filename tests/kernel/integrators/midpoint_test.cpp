#include <Eigen/LU>
#include <complex>

#include "tests/kernel/dense.hpp"
#include "tests/kernel/integrators/recording.hpp"
#include "tests/kernel/solids.hpp"

namespace plumbline::midpoint_test {
namespace {

// Two force passes, the second with the stress of the midpoint; points strain and move with the midpoint velocity.
// [Midpoint 1-4]
TEST(Midpoint, Order) {
  EXPECT_EQ(
      calls_of("midpoint"),
      (std::vector<std::string>{"locate_points", "map_mass_and_momentum", "map_forces", "advance_momentum dt",
                                "predict_stress dt/2 midpoint", "map_forces", "advance_momentum dt",
                                "move_points dt midpoint", "strain_points dt midpoint", "evaluate_stress midpoint"}));
}

// By hand: a force pass gives the midpoint velocity that predicts the strain half a step on, a second one the velocities.
// [Midpoint 1-4]
TEST(Midpoint, StepsAsByHand) {
  expect_steps_as_by_hand("midpoint", [](OnePointOscillator& o, double dt) {
    const double n = o.weight(), start = o.v;
    const auto tension = [&](double strain) { return strain > 0 ? o.modulus * strain : 0; };
    const auto pull = [&](double stress) { return -o.volume * stress / o.h / (o.m * n); };
    const double first = start + dt / 2 * pull(o.stress);               // [Midpoint 1]
    const double predicted = tension(o.strain + dt / 2 * first / o.h);  // [Midpoint 2]
    const double a = pull(predicted), middle = start + dt / 2 * a;      // [Midpoint 3]
    o.x += dt * n * middle;                                             // [Midpoint 4]
    o.v += dt * n * a;
    o.stretch(dt * middle / o.h);
  });
}

// A mass on a spring behind the stages, its strain and its place one number.
class Spring final : public Stages {
 public:
  double x, v, omega;
  Spring(double place, double velocity, double frequency) : x(place), v(velocity), omega(frequency), stress_(pull(x)) {}

  void locate_points() override {}
  void map_mass_and_momentum() override { start_ = v; }
  void map_forces() override {}
  void advance_momentum(double dt) override { end_ = start_ + dt * stress_; }
  void predict_stress(double ahead, NodalVelocity velocity) override {
    EXPECT_EQ(velocity, NodalVelocity::midpoint);
    stress_ = pull(x + ahead * (start_ + end_) / 2);
  }
  void move_points(double dt, NodalVelocity carrying) override {
    EXPECT_EQ(carrying, NodalVelocity::midpoint);
    v = end_;
    place_ = x + dt * (start_ + end_) / 2;
  }
  void strain_points(double dt, NodalVelocity velocity) override {
    EXPECT_EQ(velocity, NodalVelocity::midpoint);
    x += dt * (start_ + end_) / 2;
    EXPECT_EQ(x, place_);
  }
  void evaluate_stress(NodalVelocity) override { stress_ = pull(x); }
  void drift_points(double) override {}
  void kick_points(double) override {}
  void map_momentum() override {}
  bool reverse_cooling() override { return false; }
  void return_transfer_loss() override {}
  State state() const override { return {}; }
  void set_state(const State&) override {}
  State rate() override { return {}; }
  State velocities_of(State state) const override { return state; }

 private:
  double pull(double place) const { return -omega * omega * place; }
  double stress_, start_ = 0, end_ = 0, place_ = 0;
};

// What a step of length one makes of (omega x, v).
Eigen::Matrix2d amplification(double omega) {
  Eigen::Matrix2d m;
  for (int k = 0; k < 2; ++k) {
    Spring one(k == 0 ? 1 / omega : 0, k == 1, omega);
    find_integrator("midpoint")->make()->step(one, 1);
    m(0, k) = omega * one.x;
    m(1, k) = one.v;
  }
  return m;
}

// The largest singular value.
double largest_gain(const Eigen::Matrix2d& m) {
  return std::sqrt(dense::symmetric_spectrum(m.transpose() * m).values.maxCoeff());
}

// The determinant is 1 - (w dt)^4 / 8, the trace 2 - (w dt)^2 + (w dt)^4 / 8; no state gains energy up to w dt = 2, some do
// beyond. [Midpoint 1-4]
TEST(Midpoint, RaisesNoEnergyOfAnOscillation) {
  for (const double z : {0.01, 0.3, 0.7, 1.0, 1.4, 1.7, 1.9, 1.999, 2.0}) {
    const Eigen::Matrix2d m = amplification(z);
    const double q = z * z;
    EXPECT_NEAR(m.determinant(), 1 - q * q / 8, 4e-15);
    EXPECT_NEAR(m.trace(), 2 - q + q * q / 8, 4e-15);
    EXPECT_LE(largest_gain(m), 1 + 4e-15) << z;
  }
  EXPECT_GT(largest_gain(amplification(2.01)), 1.001);
  EXPECT_GT(dense::spectral_radius(amplification(2.01)), 1.001);
}

// Its frequency is of second order: with half the step a quarter of the error, to the next term's share, below (w dt)^2.
// [Midpoint 1-4]
TEST(Midpoint, FrequencyIsOfSecondOrder) {
  const auto error = [](double dt) { return std::abs(std::arg(dense::eigenvalues(amplification(dt))[0])) / dt - 1; };
  EXPECT_NEAR(error(0.2) / error(0.1), 4, 4 * 0.04);
  EXPECT_LE(std::abs(error(0.1)), 0.01 / 4);
}

// --- through the kernel ---------------------------------------------------------------------------------------------

// A bar of length and wave speed one between two ends that hold it, v = small sin(pi x) at first: v = small sin(pi x)
// cos(pi t), displacement small/pi sin(pi x) sin(pi t). Largest error of both over all points at t = 0.7, of the amplitude.
// (Of the strain, boxes that reach no node have one value in a cell, off by h/4 of its slope.)
double error_of_a_bar(const std::string& integrator, const std::string& shape, int cells) {
  const double pi = std::acos(-1.0), small = 1e-6, end = 0.7;
  const GridSpec grid = scenes::line(cells, 1.0 / cells, scenes::walls(Wall::symmetry, Wall::symmetry));
  const auto places = scenes::lattice(grid, 2);
  Scene scene = scenes::scene_of(
      grid, {scenes::solid_body(scenes::Law::hooke, scenes::Space::line, places, scenes::lattice_volume(grid, 2))},
      shape, "apic");
  Columns& points = scene.bodies[0].points;
  points.add(column::affine);
  for (int p = 0; p < points.points(); ++p) {
    const double x = points(column::position)[p];
    points(column::velocity)[p] = small * std::sin(pi * x);
    points(column::affine)[p] = small * pi * std::cos(pi * x);
  }
  const double c = std::sqrt(1.5);  // of the material, see solids.hpp
  Simulation run(std::move(scene), integrator, {0.7, {}});
  run.run_until(end / c);
  const auto x = scenes::by_id(run.scene().bodies[0], column::position),
             v = scenes::by_id(run.scene().bodies[0], column::velocity);
  double worst = 0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    const double mode = std::sin(pi * places[p][0]), moved = (x[p] - places[p][0]) * pi * c / small;
    worst = std::max(worst, std::abs(v[p] / small - mode * std::cos(pi * end)));
    worst = std::max(worst, std::abs(moved - mode * std::sin(pi * end)));
  }
  return worst;
}

// With mesh and step refined together the error is C h^2 (1 + O(h)). (At a fixed mesh it is not: the nodes' velocity half a
// step on is not what the points' would map to, by dt/2 (1 - P) a, which is of the order of dt h^2.) [Midpoint 1-4]
TEST(Midpoint, IsOfSecondOrderOnABar) {
  for (const char* shape : {"quadratic", "contiguous-gimp"}) {
    double errors[4];
    for (int k = 0; k < 4; ++k) errors[k] = error_of_a_bar("midpoint", shape, 8 << k);
    EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2, 0.3) << shape;
    EXPECT_NEAR(std::log2(errors[2] / errors[3]), 2, 0.2) << shape;
  }
}

// No step raises the energy of a linear elastic body, however uneven its points and wild their velocities, in any geometry,
// on any shape of constant affine inertia, below the step limit; the stores are sums of a thousand roundings of the
// largest of them, 1e-13. [Midpoint 1-4]
TEST(Midpoint, RaisesNoEnergyOfALinearElasticBody) {
  for (scenes::Space space : scenes::spaces) {
    for (const scenes::Combination& c : {scenes::Combination{"midpoint", "quadratic", "pic"},
                                         {"midpoint", "quadratic", "apic"},
                                         {"midpoint", "quadratic", "flip"},
                                         {"midpoint", "cubic", "apic"},
                                         {"midpoint", "cubic", "flip"},
                                         {"midpoint", "gimp", "pic"},
                                         {"midpoint", "contiguous-gimp", "flip"}}) {
      for (const bool walled : {false, true}) {
        SCOPED_TRACE(testing::Message() << space << ", " << c << (walled ? ", walls" : ""));
        const Scene gas = walled ? scenes::rough_gas(space, c.shape, c.transfer, scenes::no_gravity)
                                 : scenes::rough_gas_in_space(space, c.shape, c.transfer, scenes::no_gravity);
        Simulation run(scenes::rough_solid(scenes::Law::hooke, gas), "midpoint", {0.2, {}});
        double before = run.ledger().energy.initial();
        for (int k = 0; k < 40; ++k) {
          run.step(1);
          const double now = run.ledger().energy.store();
          ASSERT_LE(now, before + 1e-13 * run.ledger().energy.scale()) << "step " << k;
          before = now;
        }
        EXPECT_LT(before, run.ledger().energy.initial());
        EXPECT_GT(before, 1e-3 * run.ledger().energy.initial());
      }
    }
  }
}

}  // namespace
}  // namespace plumbline::midpoint_test
