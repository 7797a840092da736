// Pairs of points: which there are, their potential and its mean force.
#include "kernel/contact/pair_potential.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>
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

// By hand: r_0 = 2.5 * .035, K of two springs in a row. [Pairs 1, 2]
template <int dim>
void expect_energy_by_hand() {
  const Place p{1, 0.4, 0.7}, apart{0.03, dim > 1 ? -0.02 : 0, dim > 2 ? 0.01 : 0};
  TwoPoints<dim> two(p, {p[0] + apart[0], p[1] + apart[1], p[2] + apart[2]}, 0.05, 0.02);
  const double r = std::hypot(apart[0], apart[1], apart[2]), overlap = 2.5 * 0.035 - r;
  const double first = modulus(dim) / 4 * std::pow(0.05, dim - 2), second = modulus(dim) / 4 * std::pow(0.02, dim - 2);
  const double stiffness = 2 / (1 / first + 1 / second) / (0.035 * 0.035);
  EXPECT_NEAR(two.energy(), stiffness / 4 * std::pow(overlap, 4), 1e-14 * two.energy());
  const auto force = two.force();
  for (int d = 0; d < dim; ++d)
    EXPECT_NEAR(force[d], stiffness * std::pow(overlap, 3) * apart[static_cast<std::size_t>(d)] / r,
                1e-13 * force.norm())
        << d;
}
TEST(Pairs, EnergyAndForceByHand) {
  expect_energy_by_hand<1>();
  expect_energy_by_hand<2>();
  expect_energy_by_hand<3>();
}

TEST(Pairs, NothingBeyondTheReach) {
  TwoPoints<2> two({1, 1, 0}, {1.0876, 1, 0}, 0.05, 0.02);
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

// What the force takes on the way is what U falls by: into the reach, out of it, within it and through it, past each other and round
// each other. [Pairs 3]
TEST(Pairs, MeanForceTakesWhatTheEnergyFallsBy) {
  using Vec = Eigen::Vector2d;
  for (const double start : {0.01, 0.04, 0.086, 0.1}) {
    for (const double end : {0.005, 0.03, 0.0874, 0.0876, 0.13}) {
      for (const double turn : {0.0, 0.5, -2.0, 3.0}) {
        const Vec between = start * Vec(0.6, 0.8), then = end * (Eigen::Rotation2Dd(turn) * Vec(0.6, 0.8));
        TwoPoints<2> two({1, 1, 0}, {1 + between[0], 1 + between[1], 0}, 0.05, 0.02);
        TwoPoints<2> moved({1, 1, 0}, {1 + then[0], 1 + then[1], 0}, 0.05, 0.02);
        const double time = 0.25;
        for (int d = 0; d < 2; ++d) {
          two.bodies[0].points(column::contact_velocity, d)[0] = 0.3 - 0.4 * d;
          two.bodies[1].points(column::contact_velocity, d)[0] = 0.3 - 0.4 * d + (then - between)[d] / time;
        }
        const Vec force = two.force(time), middle = between + then;
        EXPECT_NEAR(force.dot(then - between), two.energy() - moved.energy(), 1e-14 * modulus(2) * std::pow(0.0875, 2))
            << start << ' ' << end << ' ' << turn;
        EXPECT_NEAR(force[0] * middle[1] - force[1] * middle[0], 0, 1e-13 * force.norm() * middle.norm());
        EXPECT_GE(force.dot(middle), 0);
      }
    }
  }
}

// Between long rows of one lattice that are pressed by a hundredth of the modulus or more nothing holds as much as a fiftieth of that,
// wherever one stands along the other.
TEST(Pairs, RowsHardlyHoldEachOther) {
  const double s = 0.05;
  for (const double gap : {1.6, 1.8, 2.0, 2.1}) {
    double most = 0, least_press = 1e300;
    for (int k = 0; k < 8; ++k) {
      std::vector<Body> bodies{
          elastic_body("lower", 2, block({0, 0, 0}, {40, 4, 1}, s), s),
          elastic_body("upper", 2, block({0.5 + k * s / 8, 0.2 + (gap - 1) * s, 0}, {20, 4, 1}, s), s)};
      for (Body& body : bodies) {
        body.points.add(column::contact_force, 2);
        body.points.add(column::contact_velocity, 2);
      }
      PairPotential<2> pairs;
      pairs.find(bodies);
      pairs.press(bodies, 0);
      const auto sum = [&](int d) {
        const double* force = bodies[1].points(column::contact_force, d);
        return std::accumulate(force, force + bodies[1].points.points(), 0.0);
      };
      most = std::max(most, std::abs(sum(0) / sum(1)));
      least_press = std::min(least_press, sum(1) / (20 * s));
    }
    EXPECT_LE(most, 0.02) << gap;
    EXPECT_GE(least_press, 1e-2 * modulus(2)) << gap;
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
          const double l = 0.5 * (bodies[a].spacing + bodies[b].spacing), overlap = 2.5 * l - std::sqrt(square);
          if (overlap > 0) sum += modulus(2) / 16 * std::pow(overlap, 4) / (l * l);
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

// Friction wants nodes that both bodies reach, wherever they stand.
TEST(Pairs, FrictionWithoutSharedNodesIsRefused) {
  const auto refusal = [](const std::string& shape, double spacing, double friction = 0.3) -> std::string {
    Scene scene;
    scene.grid = scenes::plane(20, 20, 0.1);
    scene.contact = "pairs";
    scene.shape = shape;
    scene.friction = friction;
    scene.bodies = {elastic_body("a", 2, {{1, 1, 0}}, spacing)};
    try {
      check_pairs(scene);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal("quadratic", 0.05), "");
  EXPECT_EQ(refusal("cpdi", 0.066), "");
  EXPECT_EQ(refusal("linear", 0.05, 0), "");
  EXPECT_THAT(refusal("linear", 0.05), testing::HasSubstr("the shape linear"));
  EXPECT_THAT(refusal("lagrangian-cubic", 0.05), testing::HasSubstr("the shape lagrangian-cubic"));
  EXPECT_THAT(refusal("quadratic", 0.067), testing::HasSubstr("body a are more than two thirds of a cell apart"));
}

}  // namespace
}  // namespace plumbline::pair_potential_test
