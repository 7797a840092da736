// Points that hold the nodes about them: what they hold stands still, by the least impulses, and these are booked. [Holding 1]
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel/held_points.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/simulation.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::holding_test {
namespace {

constexpr double h = 0.25;

std::shared_ptr<LinearElastic> soft() {
  auto law = std::make_shared<LinearElastic>();
  law->youngs_modulus = 1;
  law->density = 1;
  return law;
}

// A block that flies through the plane, with held points in it a cell apart, off the nodes.
Scene block(int held) {
  Scene scene;
  scene.grid.dim = 2;
  scene.grid.h = h;
  scene.grid.cells = {12, 12, 1};
  scenes::Random random(5);
  Body body = make_body("block", soft(), 64, 2), rim = make_body("rim", soft(), held, 2);
  for (int p = 0; p < 64; ++p) {
    body.points(column::position, 0)[p] = 1 + 0.125 * (p % 8) + random(-0.02, 0.02);
    body.points(column::position, 1)[p] = 1 + 0.125 * (p / 8) + random(-0.02, 0.02);
    body.points(column::velocity, 0)[p] = 0.1 + random(-0.02, 0.02);
    body.points(column::velocity, 1)[p] = random(-0.05, 0.05);
    body.points(column::mass)[p] = body.points(column::volume)[p] = h * h / 4;
  }
  for (int p = 0; p < held; ++p) {
    rim.points(column::position, 0)[p] = 1.05 + 0.03 * p;
    rim.points(column::position, 1)[p] = 1.02 + 1.02 * h * p;
    rim.points(column::mass)[p] = rim.points(column::volume)[p] = h * h / 16;
  }
  rim.points.add(column::held);
  scene.bodies = {std::move(body), std::move(rim)};
  return scene;
}

class HeldPoints : public ::testing::TestWithParam<const char*> {};

TEST_P(HeldPoints, StandStill) {
  Scene scene = block(4);
  const Columns start = scene.bodies[1].points;
  Simulation run(std::move(scene), GetParam(), {.dt = 0.01});
  for (int k = 0; k < 20; ++k) run.step(1);
  const Columns& now = run.scene().bodies[1].points;
  for (int p = 0; p < 4; ++p) {
    for (int d = 0; d < 2; ++d) {
      EXPECT_NEAR(now(column::position, d)[p], start(column::position, d)[p], 1e-13);
      EXPECT_NEAR(now(column::velocity, d)[p], 0, 1e-13);  // of 0.1, to what the solver leaves
    }
  }
}

TEST_P(HeldPoints, ImpulsesAreBookedAndDoNoWork) {
  Simulation run(block(4), GetParam(), {.dt = 0.01});
  for (int k = 0; k < 20; ++k) run.step(1);
  const Ledger& ledger = run.ledger();
  EXPECT_LT(ledger.momentum[0].flow(Flow::walls), -0.01);  // of 0.1 kg m/s of the block
  for (const int axis : {0, 1}) EXPECT_LT(ledger.momentum[static_cast<std::size_t>(axis)].relative_drift(false), 1e-12);
  EXPECT_LT(ledger.angular_momentum[2].relative_drift(false), 1e-12);
  EXPECT_LT(ledger.energy.relative_drift(false), 1e-12);
  EXPECT_NEAR(ledger.energy.flow(Flow::walls), 0, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(, HeldPoints, ::testing::Values("musl", "midpoint", "leapfrog", "usl"));

// One point held in one dimension, of nodes without forces: v_i - N_i (sum_j N_j v_j) / (M_i sum_j N_j^2 / M_j).
TEST(Holding, OfTheLeastImpulses) {
  Scene scene;
  scene.grid.dim = 1;
  scene.grid.h = 1;
  scene.grid.cells = {8, 1, 1};
  scene.shape = "linear";
  scene.transfer = "pic";
  Body body = make_body("point", soft(), 2, 1), rim = make_body("rim", soft(), 1, 1);
  const double x[] = {3.2, 4.6}, v[] = {1, -0.5}, m[] = {2, 1}, held = 3.7, bead = 0.5;
  for (int p = 0; p < 2; ++p) {
    body.points(column::position)[p] = x[p];
    body.points(column::velocity)[p] = v[p];
    body.points(column::mass)[p] = m[p];
    body.points(column::volume)[p] = 1e-12;  // no forces to speak of
  }
  rim.points(column::position)[0] = held;
  rim.points(column::mass)[0] = bead;
  rim.points(column::volume)[0] = 1e-12;
  rim.points.add(column::held);
  scene.bodies = {std::move(body), std::move(rim)};
  const auto weight = [](double at, int node) { return std::max(0.0, 1 - std::abs(at - node)); };
  std::vector<double> mass(9), u(9);
  for (int i = 0; i < 9; ++i) {
    mass[static_cast<std::size_t>(i)] = bead * weight(held, i);
    double momentum = 0;
    for (int p = 0; p < 2; ++p) {
      mass[static_cast<std::size_t>(i)] += m[p] * weight(x[p], i);
      momentum += m[p] * v[p] * weight(x[p], i);
    }
    if (mass[static_cast<std::size_t>(i)] > 0)
      u[static_cast<std::size_t>(i)] = momentum / mass[static_cast<std::size_t>(i)];
  }
  double there = 0, per = 0;
  for (const std::size_t i : {3U, 4U}) {
    const double n = weight(held, static_cast<int>(i));
    there += n * u[i];
    per += n * n / mass[i];
  }
  for (const std::size_t i : {3U, 4U}) u[i] -= weight(held, static_cast<int>(i)) * there / (mass[i] * per);
  constexpr double dt = 1e-3;
  Simulation run(std::move(scene), "usl", {.dt = dt});
  run.step(1);
  for (int p = 0; p < 2; ++p) {
    double expected = 0;
    for (int i = 0; i < 9; ++i) expected += weight(x[p], i) * u[static_cast<std::size_t>(i)];
    EXPECT_NEAR(run.scene().bodies[0].points(column::velocity)[p], expected, 1e-9);  // forces are of 1e-12 m
  }
}

TEST(Holding, RefusesWhatCannotWork) {
  const auto refused = [](auto&& change) {
    Scene scene = block(4);
    change(scene);
    EXPECT_THROW(Simulation(std::move(scene), "musl", {.dt = 0.01}), std::invalid_argument);
  };
  refused([](Scene& scene) { scene.transfer = "flip"; });
  refused([](Scene& scene) { scene.transfer = "xpic"; });
  refused([](Scene& scene) { scene.contact = "touching"; });
  refused([](Scene& scene) { scene.pistons.push_back({}); });
  refused([](Scene& scene) { scene.grid.walls[0][0] = Wall::symmetry; });
  refused([](Scene& scene) { scene.bodies[0].points.add(column::held); });
}

}  // namespace
}  // namespace plumbline::holding_test
