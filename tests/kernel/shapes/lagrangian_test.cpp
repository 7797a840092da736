// Weights of the places at the start: what they are once points have moved and deformed, what the ledger makes of them, and that
// nothing depends on where on the grid a body has come to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "kernel/engine/loops/list_survey.hpp"
#include "kernel/integrator_traits.hpp"
#include "kernel/shapes/reference_columns.hpp"
#include "tests/kernel/solids.hpp"

namespace plumbline::lagrangian_test {
namespace {

using scenes::Law;
using scenes::Space;
using Matrix = Eigen::Matrix2d;

const std::vector<std::string> names{"lagrangian-quadratic", "lagrangian-cubic"};

// A block of 6 x 4 points in a wide space, with a rough motion that stretches, shears and turns it.
Scene block(const std::string& shape, const std::string& transfer, Law law = Law::neo_hookean) {
  std::vector<scenes::Place> places;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 6; ++i) places.push_back({1.0 + 0.125 * (i + 0.5), 1.25 + 0.125 * (j + 0.5)});
  }
  Scene scene = scenes::scene_of(scenes::plane(12, 12, 0.25, scenes::walls(Wall::free, Wall::free)),
                                 {scenes::solid_body(law, Space::plane, places, 0.125 * 0.125)}, shape, transfer);
  Columns& points = scene.bodies[0].points;
  scenes::Random random(3);
  for (int p = 0; p < points.points(); ++p) {
    const double x = points(column::position, 0)[p] - 1.375, y = points(column::position, 1)[p] - 1.5;
    points(column::velocity, 0)[p] = 0.3 + 0.4 * x - 1.2 * y + random(-0.05, 0.05);
    points(column::velocity, 1)[p] = 0.1 + 0.7 * x + 0.2 * y + random(-0.05, 0.05);
  }
  return scene;
}

Matrix deformation_of(const Columns& points, int p) {
  Matrix f;
  for (int k = 0; k < 4; ++k) f(k / 2, k % 2) = points(column::deformation, k)[p];
  return f;
}

// Once points stand elsewhere, turned and stretched: a velocity A X + b of the places at the start, which affine points map without
// loss, strains them at the rate A F^-1, F of what they deformed since then. Sums of 16 terms of order one over h: 1e-13.
// [Lagrangian 1] [Lagrangian 2]
TEST(Lagrangian, StrainsByVelocitiesThatAreLinearInThePlacesAtTheStart) {
  Matrix a, f, at_start;
  a << 0.3, -0.7, 0.5, 0.2;
  f << 1.2, 0.4, -0.3, 0.9;
  at_start << 1.1, 0.2, 0.1, 0.8;
  for (const std::string& shape : names) {
    SCOPED_TRACE(shape);
    Scene scene = block(shape, "apic");
    Columns& points = scene.bodies[0].points;
    const auto fill = [&](const ColumnId& id, const Matrix& to) {
      for (int k = 0; k < 4; ++k) std::fill_n(points(id, k), points.points(), to(k / 2, k % 2));
    };
    fill(column::deformation, at_start);
    Ledger ledger;
    const auto engine = make_engine(scene, ledger, {});
    fill(column::deformation, f * at_start);
    fill(column::affine, a);
    for (int p = 0; p < points.points(); ++p) {
      const Eigen::Vector2d x(points(column::position_at_start, 0)[p], points(column::position_at_start, 1)[p]);
      for (int d = 0; d < 2; ++d) {
        points(column::position, d)[p] += 0.37 + 0.1 * d;
        points(column::velocity, d)[p] = (a * x)[d] + 0.1;
      }
    }
    engine->points_changed();
    engine->locate_points();
    engine->map_mass_and_momentum();
    engine->strain_points(0.0, NodalVelocity::start);
    const Matrix rate = a * f.inverse();
    for (int p = 0; p < points.points(); ++p) {
      for (int k = 0; k < 4; ++k) EXPECT_NEAR(points(column::strain_rate, k)[p], rate(k / 2, k % 2), 1e-13);
    }
  }
}

// All books close: energy, momentum, and angular momentum, of which nodes that stand where they are have another than the points,
// under forces, walls and gravity. [Lagrangian 3]
TEST(Lagrangian, LedgersClose) {
  for (const std::string& shape : names) {
    for (const std::string transfer : {"apic", "flip", "pic", "xpic"}) {
      for (const std::string integrator : {"midpoint", "usl", "musl"}) {
        for (const bool walled : {false, true}) {
          SCOPED_TRACE(shape + ", " + transfer + ", " + integrator);
          if (!lacks(*find_integrator(integrator), shape, transfer).empty()) continue;
          Scene scene = block(shape, transfer);
          scene.gravity = {0.2, -0.5, 0};
          if (walled) {
            scene.grid.walls[1][0] = Wall::symmetry;
            scene.grid.origin[1] = 1.25;
          }
          Simulation run(std::move(scene), integrator, {0.3, 0.02});
          for (int k = 0; k < 40; ++k) run.step(1);
          scenes::expect_ledger_closes(run.ledger(), 1e-13);
          double turned = 0;
          const Columns& points = run.scene().bodies[0].points;
          for (int p = 0; p < points.points(); ++p) {
            const Matrix f = deformation_of(points, p);
            turned = std::max(turned, std::abs(f(1, 0) - f(0, 1)));
          }
          EXPECT_GT(turned, 0.01);
        }
      }
    }
  }
}

// Where a body goes across the grid is nothing to its strains: with a common velocity, by which it comes to other cells, they are the
// same to rounding, 40 steps of 1e-16 times what a step amplifies; with weights of where points stand they are not.
TEST(Lagrangian, StrainsDoNotDependOnWhereABodyGoes) {
  const auto strains = [](const std::string& shape, double common) {
    Scene scene = block(shape, "flip");
    Columns& points = scene.bodies[0].points;
    for (int p = 0; p < points.points(); ++p) points(column::velocity, 0)[p] += common;
    Simulation run(std::move(scene), "midpoint", {0.3, 0.02});
    for (int k = 0; k < 40; ++k) run.step(1);
    return scenes::by_id(run.scene().bodies[0], column::deformation, 1);
  };
  const auto largest_difference = [&](const std::string& shape) {
    const auto still = strains(shape, 0), moving = strains(shape, 0.6);
    double largest = 0;
    for (std::size_t p = 0; p < still.size(); ++p) largest = std::max(largest, std::abs(still[p] - moving[p]));
    return largest;
  };
  for (const std::string& shape : names) EXPECT_LE(largest_difference(shape), 1e-12) << shape;
  EXPECT_GE(largest_difference("quadratic"), 1e-4);
}

// The first step of a body that comes with F_0 and is stretched by diag(2, 1/2) more: waves along the second axis are twice as fast
// among the places of the start, sqrt((mu |F_0^T N|^2 + (mu + lambda (1 - ln J)) / s^2) / rho_0). [Lagrangian 4]
TEST(Lagrangian, StepsAreThoseOfWavesAmongThePlacesAtTheStart) {
  Scene scene = block("lagrangian-quadratic", "flip");
  Columns& points = scene.bodies[0].points;
  for (int d = 0; d < 2; ++d) std::fill_n(points(column::velocity, d), points.points(), 0.0);
  const double start[] = {1.1, 0, 0, 1.2}, now[] = {2.2, 0, 0, 0.6};
  for (int k = 0; k < 4; ++k) std::fill_n(points(column::deformation, k), points.points(), start[k]);
  Ledger ledger;
  const auto engine = make_engine(scene, ledger, {});
  for (int k = 0; k < 4; ++k) std::fill_n(points(column::deformation, k), points.points(), now[k]);
  engine->points_changed();
  const double mu = 1.5 / 2.6, lambda = 1.5 * 0.3 / (1.3 * 0.4);
  const double exact = std::sqrt(mu * 1.44 + (mu + lambda * (1 - std::log(2.2 * 0.6))) * 4);
  EXPECT_NEAR(engine->survey().step_limit, scene.grid.h / exact, 1e-14);
  EXPECT_NEAR(largest_shortening<2>(points, all_points(points)), 4, 1e-14);
}

// The places of the start are those of the first step, not of where a run is taken up again.
TEST(Lagrangian, ARestoredRunGoesOnToTheSameBits) {
  const StepControl control{0.3, 0.02};
  Simulation whole(block("lagrangian-quadratic", "apic"), "midpoint", control);
  for (int k = 0; k < 10; ++k) whole.step(1);
  Simulation resumed(block("lagrangian-quadratic", "apic"), "midpoint", control);
  resumed.restore(whole.save());
  for (int k = 0; k < 10; ++k) {
    whole.step(1);
    resumed.step(1);
  }
  for (const ColumnId* id : {&column::position, &column::velocity, &column::deformation, &column::position_at_start}) {
    EXPECT_EQ(scenes::by_id(whole.scene().bodies[0], *id), scenes::by_id(resumed.scene().bodies[0], *id)) << id->name();
  }
}

TEST(Lagrangian, WhatItCannotDoIsRefused) {
  const auto expect_refused = [](const Scene& scene, const std::string& because) {
    Scene own = scene;
    Ledger ledger;
    EXPECT_THAT([&] { make_engine(own, ledger, {}); },
                testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr(because)));
  };
  const Scene good = block("lagrangian-cubic", "flip");
  Scene bad = good;
  bad.bodies.push_back(good.bodies[0]);
  bad.bodies[1].name = "other";
  bad.contact = "touching";
  expect_refused(bad, "cannot work with the contact law touching");
  bad = block("lagrangian-cubic", "apic");
  bad.pistons.push_back({});
  expect_refused(bad, "cannot work with pistons");
  bad = scenes::rough_gas(Space::plane, "lagrangian-cubic", "flip", scenes::no_gravity);
  expect_refused(bad, "is one of solids");
  bad = scenes::rough_solid(Law::neo_hookean,
                            scenes::rough_gas(Space::axisymmetric, "lagrangian-cubic", "flip", scenes::no_gravity));
  expect_refused(bad, "not about an axis");
}

}  // namespace
}  // namespace plumbline::lagrangian_test
