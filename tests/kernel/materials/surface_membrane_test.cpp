// A membrane in space by its points alone, and one whose tangents the grid carries. [Surface 3] [Carried 1]
#include "kernel/materials/surface_membrane.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "kernel/materials/carried_membrane.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::surface_membrane_test {
namespace {

constexpr MaterialContext context{3, 0.1, false, 0, false, false};
constexpr int along = 7, across = 6, count = along * across;

// An irregular patch, bent and stretched since it was at rest.
Body patch(bool one_way) {
  scenes::Random random(9);
  auto law = std::make_shared<SurfaceMembrane>();
  law->youngs_modulus = 50;
  law->poissons_ratio = 0.3;
  law->density = 2;
  law->thickness = 0.05;
  law->one_way = one_way;
  Body body = make_body("patch", law, count, 3);
  Columns& points = body.points;
  for (int p = 0; p < count; ++p) {
    const double u = 0.1 * (p % along) + random(-0.02, 0.02), v = 0.1 * (p / along) + random(-0.02, 0.02);
    points(column::position, 0)[p] = 1 + u;
    points(column::position, 1)[p] = 1 + v;
    points(column::position, 2)[p] = 1;
    points(column::tangents, 0)[p] = points(column::tangents, 4)[p] = 1;
    points(column::volume)[p] = 0.05 * 0.01 * random(0.8, 1.2);
    points(column::mass)[p] = 2 * points(column::volume)[p];
  }
  body.material = law->of_rest(points);
  for (int p = 0; p < count; ++p) {
    const double u = points(column::position, 0)[p] - 1, v = points(column::position, 1)[p] - 1;
    points(column::position, 0)[p] += 0.1 * u + random(-0.01, 0.01);
    points(column::position, 1)[p] += 0.2 * u * v + random(-0.01, 0.01);
    points(column::position, 2)[p] += 0.3 * u * u + random(-0.01, 0.01);
    for (int d = 0; d < 3; ++d) points(column::strain_rate, d)[p] = random(-1, 1);
  }
  return body;
}

Eigen::MatrixXd column_of(const Columns& points, const ColumnId& id) {
  Eigen::MatrixXd all(count, 3);
  for (int d = 0; d < 3; ++d) {
    for (int p = 0; p < count; ++p) all(p, d) = points(id, d)[p];
  }
  return all;
}

Eigen::MatrixXd forces(Body& body, double ahead = 0) {
  MaterialContext at = context;
  at.ahead = ahead;
  body.material->prepare_stress(body.points, all_points(body.points), at);
  body.material->evaluate_stress(body.points, all_points(body.points), at);
  Eigen::MatrixXd all = column_of(body.points, column::stress);
  for (int p = 0; p < count; ++p) all.row(p) *= -body.points(column::volume)[p];
  return all;
}

double energy(Body& body) {
  body.material->advance(body.points, all_points(body.points), context, 0);
  return body.material->stored_energy(body.points, all_points(body.points));
}

TEST(SurfaceMembrane, ForcesAreTheDerivativeOfTheEnergy) {  // [Surface 3]
  for (const bool one_way : {false, true}) {
    Body body = patch(one_way);
    const Eigen::MatrixXd f = forces(body);
    for (const int p : {0, 3, 17, count - 1}) {
      for (int d = 0; d < 3; ++d) {
        constexpr double step = 1e-6;
        double* x = body.points(column::position, d) + p;
        *x += step;
        const double high = energy(body);
        *x -= 2 * step;
        const double low = energy(body);
        *x += step;
        EXPECT_NEAR(f(p, d), -(high - low) / (2 * step), 1e-6 * f.norm()) << p << ' ' << d;
      }
    }
  }
}

TEST(SurfaceMembrane, ForcesBalance) {
  Body body = patch(false);
  const Eigen::MatrixXd f = forces(body), moments = column_of(body.points, column::position).transpose() * f;
  EXPECT_LT(f.colwise().sum().norm(), 1e-12 * f.norm());
  EXPECT_LT((moments - moments.transpose()).norm(), 1e-12 * f.norm());
}

TEST(SurfaceMembrane, ForcesAheadAreThoseOfPlacesAhead) {
  Body body = patch(false), then = patch(false);
  constexpr double ahead = 0.01;
  for (int d = 0; d < 3; ++d) {
    for (int p = 0; p < count; ++p)
      then.points(column::position, d)[p] += ahead * then.points(column::strain_rate, d)[p];
  }
  EXPECT_LT((forces(body, ahead) - forces(then)).norm(), 1e-11 * forces(then).norm());
}

// What it says is stored is what is stored, and its rate that of the points' velocities.
TEST(SurfaceMembrane, StoresWhatItSays) {
  Body body = patch(false);
  const double before = energy(body);
  forces(body);
  const std::vector<double> rates = body.material->rates(body.points, context);
  double power = 0;
  for (const double rate : rates) power += rate;
  constexpr double dt = 1e-8;  // the strain rates are some 10/s: their squares add dt times that
  for (int d = 0; d < 3; ++d) {
    for (int p = 0; p < count; ++p) body.points(column::position, d)[p] += dt * body.points(column::strain_rate, d)[p];
  }
  const double told = body.material->advance(body.points, all_points(body.points), context, dt);
  const double now = body.material->stored_energy(body.points, all_points(body.points));
  EXPECT_NEAR(told, now - before, 1e-13 * now);
  EXPECT_NEAR(told / dt, power, 1e-5 * std::abs(power));
}

TEST(SurfaceMembrane, WantsItsNeighbours) {
  SurfaceMembrane law;
  Columns points(3);
  points.add(column::position, 3);
  points.add(column::strain_rate, 3);
  points.add(column::stress, 3);
  points.add(column::volume);
  law.add_columns(points, 3);
  EXPECT_THROW(law.prepare_stress(points, {0, 3}, context), std::logic_error);
}

Scene drifting_patch() {
  Body body = patch(false);
  for (int p = 0; p < count; ++p) body.points(column::velocity, 1)[p] = 0.2;
  Scene scene;
  scene.grid.dim = 3;
  scene.grid.h = 0.2;
  scene.grid.cells = {14, 14, 10};
  for (auto& sides : scene.grid.walls) sides = {Wall::free, Wall::free};
  scene.bodies.push_back(std::move(body));
  return scene;
}

TEST(SurfaceMembrane, MomentaAndLedgerCloseAndThreadsDoNotMatter) {
  for (const char* integrator : {"musl", "leapfrog", "midpoint"}) {
    Simulation one(drifting_patch(), integrator, {.dt = 2e-3, .threads = 1}),
        two(drifting_patch(), integrator, {.dt = 2e-3, .threads = 2});
    for (int k = 0; k < 20; ++k) {
      one.step(1);
      two.step(1);
    }
    const Ledger& ledger = one.ledger();
    for (const Account& account : ledger.momentum) EXPECT_LT(account.relative_drift(true), 1e-13) << integrator;
    for (const Account& account : ledger.angular_momentum) EXPECT_LT(account.relative_drift(true), 1e-12) << integrator;
    EXPECT_LT(ledger.energy.relative_drift(true), 1e-12) << integrator;
    EXPECT_EQ(column_of(one.scene().bodies[0].points, column::position),
              column_of(two.scene().bodies[0].points, column::position));
  }
}

// A stretched patch that images behind its edge x = 1 hold: what they pull with is booked at the walls. [Surface 4]
TEST(SurfaceMembrane, ImpulseOfAClampIsBooked) {
  Scene scene = drifting_patch();
  Body& body = scene.bodies[0];
  for (int p = 0; p < count; ++p) body.points(column::velocity, 1)[p] = 0;
  std::vector<OddImage> images;
  for (int p = 0; p < count; ++p) {
    const double x = body.points(column::position, 0)[p];
    if (x < 1.25)
      images.push_back({p, {1.9 - x, body.points(column::position, 1)[p], body.points(column::position, 2)[p]}});
  }
  const auto& law = static_cast<const SurfaceMembrane&>(*body.material);
  for (int p = 0; p < count; ++p) body.points(column::tangents, 0)[p] = body.points(column::tangents, 4)[p] = 1.1;
  body.material = law.of_rest(body.points, images, {});
  body.points.add(column::clamped);
  Simulation clamped(std::move(scene), "musl", {.dt = 2e-3});
  for (int k = 0; k < 10; ++k) clamped.step(1);
  const Account& account = clamped.ledger().momentum[0];
  EXPECT_GT(std::abs(account.flow(Flow::walls)), 1e-6);
  EXPECT_LT(account.relative_drift(false), 1e-12);
}

// A gradient that turns and stretches: f -> f + dt L f, and V sigma : L is the rate of the energy. [Carried 1]
TEST(CarriedMembrane, TangentsFollowTheGradient) {
  CarriedMembrane law;
  law.youngs_modulus = 10;
  law.poissons_ratio = 0.3;
  law.density = law.thickness = 1;
  Body body = make_body("points", std::make_shared<CarriedMembrane>(law), 1, 3);
  Columns& points = body.points;
  const double start[] = {1.1, 0.1, 0, -0.2, 1.2, 0.3};
  for (int k = 0; k < 6; ++k) points(column::tangents, k)[0] = start[k];
  points(column::volume)[0] = 2;
  double gradient[9];
  for (int k = 0; k < 9; ++k) points(column::strain_rate, k)[0] = gradient[k] = 0.1 * k - 0.3;
  law.evaluate_stress(points, {0, 1}, context);
  double power = 0;
  for (int k = 0; k < 9; ++k) power += 2 * gradient[k] * points(column::stress, k)[0];
  constexpr double dt = 1e-6;
  const double stored = law.advance(points, {0, 1}, context, dt);
  EXPECT_NEAR(stored / dt, power, 1e-4 * std::abs(power));
  EXPECT_NEAR(points(column::tangents, 0)[0], 1.1 + dt * (-0.3 * 1.1 - 0.2 * 0.1), 1e-15);
  EXPECT_NEAR(points(column::tangents, 5)[0], 0.3 + dt * (0.3 * -0.2 + 0.4 * 1.2 + 0.5 * 0.3), 1e-15);
}

}  // namespace
}  // namespace plumbline::surface_membrane_test
