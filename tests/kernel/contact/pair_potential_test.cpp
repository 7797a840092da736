// Pairs of points: which there are, their potential and its mean force.
#include "kernel/contact/pair_potential.hpp"

#include <cmath>
#include <utility>

#include "kernel/materials/ideal_gas.hpp"
#include "tests/kernel/contact/two_clouds.hpp"

namespace plumbline::pair_potential_test {
namespace {

using meetings::block;
using meetings::elastic_body;
using scenes::Place;

// One point of each of two bodies, with the columns that contact asks for.
template <int dim>
struct TwoPoints {
  std::vector<Body> bodies;
  TwoPoints(Place first, Place second, double spacing, double other_spacing)
      : bodies{elastic_body("a", dim, {first}, spacing), elastic_body("b", dim, {second}, other_spacing)} {
    for (Body& body : bodies) {
      body.points.add(column::contact_force, dim);
      body.points.add(column::contact_velocity, dim);
    }
  }
  double energy() const {
    PairPotential<dim> pairs;
    pairs.find(bodies);
    return pairs.energy(bodies);
  }
  // On the second point.
  Eigen::Matrix<double, dim, 1> force(double time = 0) {
    PairPotential<dim> pairs;
    pairs.find(bodies);
    pairs.press(bodies, time);
    Eigen::Matrix<double, dim, 1> force;
    for (int d = 0; d < dim; ++d) {
      force[d] = bodies[1].points(column::contact_force, d)[0];
      EXPECT_EQ(bodies[0].points(column::contact_force, d)[0], -force[d]);
    }
    return force;
  }
};

// With E = 100, nu = .3: M = 1e2 on a line, lambda + 2 mu in the plane and in space.
double modulus(int dim) { return dim == 1 ? 100 : 100 * 0.7 / (1.3 * 0.4); }

// By hand: r_0 = 1.6 * .035, K of two springs in a row. [Pairs 1, 2]
template <int dim>
void expect_energy_by_hand() {
  const Place p{1, 0.4, 0.7}, apart{0.03, dim > 1 ? -0.02 : 0, dim > 2 ? 0.01 : 0};
  TwoPoints<dim> two(p, {p[0] + apart[0], p[1] + apart[1], p[2] + apart[2]}, 0.05, 0.02);
  const double r = std::hypot(apart[0], apart[1], apart[2]), overlap = 1.6 * 0.035 - r;
  const double first = modulus(dim) / 8 * std::pow(0.05, dim - 2), second = modulus(dim) / 8 * std::pow(0.02, dim - 2);
  const double stiffness = 2 / (1 / first + 1 / second);
  EXPECT_NEAR(two.energy(), 0.5 * stiffness * overlap * overlap, 1e-14 * two.energy());
  const auto force = two.force();
  for (int d = 0; d < dim; ++d)
    EXPECT_NEAR(force[d], stiffness * overlap * apart[static_cast<std::size_t>(d)] / r, 1e-13 * force.norm()) << d;
}
TEST(Pairs, EnergyAndForceByHand) {
  expect_energy_by_hand<1>();
  expect_energy_by_hand<2>();
  expect_energy_by_hand<3>();
}

TEST(Pairs, NothingBeyondTheReach) {
  TwoPoints<2> two({1, 1, 0}, {1.0561, 1, 0}, 0.05, 0.02);
  EXPECT_EQ(two.energy(), 0);
  EXPECT_EQ(two.force().norm(), 0);
}

// Without a spacing it is that of the volume at rest, m/rho_0 to the power 1/dim.
TEST(Pairs, SpacingsAreThoseOfRest) {
  TwoPoints<2> given({1, 1, 0}, {1.03, 1, 0}, 0.05, 0.02), read({1, 1, 0}, {1.03, 1, 0}, 0.05, 0.02);
  for (Body& body : read.bodies) {
    body.spacing = 0;
    body.points(column::volume)[0] *= 3;
  }
  EXPECT_NEAR(read.energy(), given.energy(), 1e-13 * given.energy());
}

// The force is what U falls by over the way, by the distance along the first direction: into the reach, out of it, within it and
// through it. [Pairs 3]
TEST(Pairs, MeanForceTakesWhatTheEnergyFallsBy) {
  for (const double start : {0.01, 0.04, 0.055, 0.07}) {
    for (const double end : {0.005, 0.03, 0.0559, 0.0561, 0.09}) {
      TwoPoints<2> two({1, 1, 0}, {1 + 0.6 * start, 1 + 0.8 * start, 0}, 0.05, 0.02);
      TwoPoints<2> then({1, 1, 0}, {1 + 0.6 * end, 1 + 0.8 * end, 0}, 0.05, 0.02);
      const double time = 0.25, opening = (end - start) / time;
      // Each moves; what is across the direction does no work.
      two.bodies[0].points(column::contact_velocity, 0)[0] = 0.3 + 0.8;
      two.bodies[0].points(column::contact_velocity, 1)[0] = -0.1 - 0.6;
      two.bodies[1].points(column::contact_velocity, 0)[0] = 0.3 + 0.6 * opening;
      two.bodies[1].points(column::contact_velocity, 1)[0] = -0.1 + 0.8 * opening;
      const Eigen::Vector2d force = two.force(time);
      EXPECT_NEAR(force.dot(Eigen::Vector2d(0.6, 0.8)) * (end - start), two.energy() - then.energy(),
                  1e-14 * modulus(2) / 8 * std::pow(1.6 * 0.035, 2))
          << start << ' ' << end;
      EXPECT_NEAR(force[0] * 0.8 - force[1] * 0.6, 0, 1e-13 * force.norm());
    }
  }
}

// Against a search of all pairs, bodies of one field left out.
TEST(Pairs, AllThatAreNearAreFound) {
  const double s = 0.05;
  std::vector<Body> bodies{elastic_body("a", 2, block({0.5, 0.5, 0}, {8, 8, 1}, s), s),
                           elastic_body("b", 2, block({0.87, 0.63, 0}, {8, 4, 1}, s), s),
                           elastic_body("c", 2, block({0.7, 0.86, 0}, {8, 4, 1}, 0.03), 0.03)};
  bodies[2].field = "a";
  double sum = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a + 1; b < 3; ++b) {
      if (bodies[a].field == bodies[b].field) continue;
      for (int p = 0; p < bodies[a].points.points(); ++p) {
        for (int q = 0; q < bodies[b].points.points(); ++q) {
          double square = 0;
          for (int d = 0; d < 2; ++d)
            square += std::pow(bodies[a].points(column::position, d)[p] - bodies[b].points(column::position, d)[q], 2);
          const double overlap = 1.6 * 0.5 * (bodies[a].spacing + bodies[b].spacing) - std::sqrt(square);
          if (overlap > 0) sum += 0.5 * modulus(2) / 8 * overlap * overlap;
        }
      }
    }
  }
  PairPotential<2> pairs;
  pairs.find(bodies);
  EXPECT_GT(sum, 0);
  EXPECT_NEAR(pairs.energy(bodies), sum, 1e-13 * sum);
}

TEST(Pairs, WhereTheyCannotActIsRefused) {
  Scene scene;
  scene.grid = scenes::plane(20, 20, 0.1);
  scene.contact = "pairs";
  scene.bodies = {elastic_body("a", 2, {{1, 1, 0}}, 0.05)};
  EXPECT_NO_THROW(check_pairs(scene));
  EXPECT_EQ(contact_energy(scene), 0);
  scene.bodies.push_back(make_body("air", std::make_shared<IdealGas>(), 1, 2));
  EXPECT_THROW(check_pairs(scene), std::invalid_argument);
  scene.bodies.pop_back();
  scene.grid.axisymmetric = true;
  EXPECT_THROW(check_pairs(scene), std::invalid_argument);
  scene.contact = "touching";
  EXPECT_NO_THROW(check_pairs(scene));
}

}  // namespace
}  // namespace plumbline::pair_potential_test
