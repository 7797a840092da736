#include "kernel/materials/uniaxial_membrane.hpp"
#include "kernel/shapes/shape.hpp"

#include <numbers>

#include "tests/kernel/scenes.hpp"

namespace plumbline::uniaxial_membrane_test {
namespace {

constexpr double rounding = 4e-15;
constexpr double pi = std::numbers::pi;
constexpr MaterialContext on_line{1, 0.1, false}, in_plane{2, 0.1, false};

UniaxialMembrane law(bool one_way = true, bool closed = false) {
  UniaxialMembrane membrane;
  membrane.youngs_modulus = 100;
  membrane.density = 4;
  membrane.one_way = one_way;
  membrane.closed = closed;
  return membrane;
}

Columns chain(const UniaxialMembrane& membrane, const std::vector<scenes::Place>& places, int dim = 2) {
  return scenes::membrane_body(membrane, dim, places, 0.5).points;
}

double angle(const Columns& points, int p) {
  return std::atan2(points(column::tangent, 1)[p], points(column::tangent, 0)[p]);
}

// [York 5.5] sigma = E eps in tension; [York 5.3] the total strain is what is carried.
TEST(UniaxialMembrane, CarriesTotalStrainOnALine) {
  const UniaxialMembrane membrane = law();
  Columns points = chain(membrane, {{0, 0}}, 1);
  points(column::strain)[0] = 0.01;
  points(column::strain_rate)[0] = 2;
  const double stored = membrane.advance(points, all_points(points), on_line, 0.01);
  EXPECT_NEAR(points(column::strain)[0], 0.03, rounding);
  EXPECT_NEAR(stored, 0.5 * (50 * 0.0009 - 50 * 0.0001), rounding);
  membrane.evaluate_stress(points, all_points(points), on_line);
  EXPECT_NEAR(points(column::stress)[0], 3, rounding);
  EXPECT_EQ(membrane.rates(points, on_line)[0], 2);
}

// The one-way law: no stress while the strain is negative, but it goes on accumulating, and all of it must be
// undone before the membrane pulls again. [York 5.2, 5.3, 5.5]
TEST(UniaxialMembrane, NegativeStrainAccumulatesWithoutStress) {
  const UniaxialMembrane membrane = law();
  Columns points = chain(membrane, {{0, 0}}, 1);
  points(column::strain_rate)[0] = -1;
  for (int k = 0; k < 3; ++k) EXPECT_EQ(membrane.advance(points, all_points(points), on_line, 0.1), 0);
  membrane.evaluate_stress(points, all_points(points), on_line);
  EXPECT_NEAR(points(column::strain)[0], -0.3, rounding);
  EXPECT_EQ(points(column::stress)[0], 0);
  EXPECT_EQ(membrane.stored_energy(points, all_points(points)), 0);
  points(column::strain_rate)[0] = 1;
  membrane.advance(points, all_points(points), on_line, 0.2);
  membrane.evaluate_stress(points, all_points(points), on_line);
  EXPECT_EQ(points(column::stress)[0], 0);  // still slack
  membrane.advance(points, all_points(points), on_line, 0.2);
  membrane.evaluate_stress(points, all_points(points), on_line);
  EXPECT_NEAR(points(column::stress)[0], 10, 1e-13);
}

TEST(UniaxialMembrane, TwoWayLawPushes) {
  const UniaxialMembrane membrane = law(false);
  Columns points = chain(membrane, {{0, 0}}, 1);
  points(column::strain)[0] = -0.1;
  membrane.evaluate_stress(points, all_points(points), on_line);
  EXPECT_NEAR(points(column::stress)[0], -10, rounding);
  EXPECT_NEAR(membrane.stored_energy(points, all_points(points)), 0.5 * 0.5 * 100 * 0.01, rounding);
}

// W = E eps^2 / 2, whose derivative is the stress of [York 5.5].
TEST(UniaxialMembrane, EnergyDensity) {
  EXPECT_NEAR(law().energy_density(0.2), 2, rounding);
  EXPECT_EQ(law().energy_density(-0.2), 0);
  EXPECT_NEAR(law(false).energy_density(-0.2), 2, rounding);
  const double d = 1e-6;  // central difference of a parabola: exact up to rounding 1e-16 / d
  EXPECT_NEAR((law().energy_density(0.2 + d) - law().energy_density(0.2 - d)) / (2 * d), 20, 1e-8);
}

// [York 5.2] t . e . t for e = (2, 5, 2 e_xy = 4) and t at 30 degrees: 2 cos^2 + 5 sin^2 + 4 sin cos.
TEST(UniaxialMembrane, StrainRateAlongTheTangent) {
  const UniaxialMembrane membrane = law();
  const double c = std::cos(pi / 6), s = std::sin(pi / 6);
  Columns points = chain(membrane, {{0, 0}, {c, s}, {2 * c, 2 * s}});
  membrane.evaluate_stress(points, all_points(points), in_plane);
  for (int p = 0; p < 3; ++p) {
    points(column::strain_rate, 0)[p] = 2;
    points(column::strain_rate, 1)[p] = 5;
    points(column::strain_rate, 2)[p] = 4;
  }
  const double along = 2 * c * c + 5 * s * s + 4 * s * c;
  EXPECT_NEAR(membrane.rates(points, in_plane)[1], along, rounding);
  membrane.advance(points, all_points(points), in_plane, 0.1);
  EXPECT_NEAR(points(column::strain)[1], 0.1 * along, rounding);
}

// [York 5.5] sigma = s t t^T, in the grid's frame.
TEST(UniaxialMembrane, StressPointsAlongTheTangent) {
  const UniaxialMembrane membrane = law();
  const double c = std::cos(0.7), s = std::sin(0.7);
  Columns points = chain(membrane, {{0, 0}, {c, s}});
  for (int p = 0; p < 2; ++p) points(column::strain)[p] = 0.03;
  membrane.evaluate_stress(points, all_points(points), in_plane);
  EXPECT_NEAR(points(column::stress, 0)[1], 3 * c * c, rounding);
  EXPECT_NEAR(points(column::stress, 1)[1], 3 * s * s, rounding);
  EXPECT_NEAR(points(column::stress, 2)[1], 3 * s * c, rounding);
}

// [York 7.1] the mean of the two adjoining angles; at the ends of an open chain the one segment's.
TEST(UniaxialMembrane, TangentsOfAnOpenChain) {
  const UniaxialMembrane membrane = law();
  Columns points = chain(membrane, {{0, 0}, {2, 0}, {2, 1}, {1, 2}});  // lengths must not weigh: angles 0, 90, 135
  membrane.evaluate_stress(points, all_points(points), in_plane);
  EXPECT_NEAR(angle(points, 0), 0, rounding);
  EXPECT_NEAR(angle(points, 1), pi / 4, rounding);
  EXPECT_NEAR(angle(points, 2), pi * 112.5 / 180, rounding);
  EXPECT_NEAR(angle(points, 3), pi * 0.75, rounding);
}

// [York 7.1] on a closed chain every point has two neighbours; a regular polygon's tangents are those of its
// circle, also across the branch cut of the angle.
TEST(UniaxialMembrane, TangentsOfAClosedChain) {
  const UniaxialMembrane membrane = law(true, true);
  std::vector<scenes::Place> ring;
  const int n = 12;
  for (int k = 0; k < n; ++k) ring.push_back({std::cos(2 * pi * k / n), std::sin(2 * pi * k / n)});
  Columns points = chain(membrane, ring);
  membrane.evaluate_stress(points, all_points(points), in_plane);
  for (int k = 0; k < n; ++k) {
    EXPECT_NEAR(points(column::tangent, 0)[k], -ring[static_cast<std::size_t>(k)][1], rounding);
    EXPECT_NEAR(points(column::tangent, 1)[k], ring[static_cast<std::size_t>(k)][0], rounding);
  }
}

// The total strain is carried along the turning tangent: a rotated chain has the rotated stress. [York 5.3, 5.5]
TEST(UniaxialMembrane, StressRotatesWithTheChain) {
  const UniaxialMembrane membrane = law();
  Columns points = chain(membrane, {{0, 0}, {1, 0}, {2, 0}});
  for (int p = 0; p < 3; ++p) points(column::strain)[p] = 0.05;
  membrane.evaluate_stress(points, all_points(points), in_plane);
  EXPECT_NEAR(points(column::stress, 0)[1], 5, rounding);
  for (int p = 0; p < 3; ++p) {
    points(column::position, 0)[p] = -p * std::sin(0.4);
    points(column::position, 1)[p] = p * std::cos(0.4);
  }
  membrane.evaluate_stress(points, all_points(points), in_plane);
  EXPECT_NEAR(points(column::stress, 0)[1], 5 * std::pow(std::sin(0.4), 2), rounding);
  EXPECT_NEAR(points(column::stress, 1)[1], 5 * std::pow(std::cos(0.4), 2), rounding);
  EXPECT_NEAR(points(column::stress, 2)[1], -5 * std::sin(0.4) * std::cos(0.4), rounding);
}

// A spinning ring's velocity is v0 + omega x r at every node, so no point strains, to rounding: 1e-13 of omega.
// [York 5.2]
TEST(UniaxialMembrane, RigidRotationStrainsNothing) {
  const double omega = 3;
  std::vector<scenes::Place> ring;
  for (int k = 0; k < 24; ++k) ring.push_back({0.5 + 0.2 * std::cos(pi * k / 12), 0.5 + 0.2 * std::sin(pi * k / 12)});
  for (const Choice& shape : scenes::shapes_in_space()) {
    Scene scene = scenes::scene_of(scenes::plane(10, 10, 0.1),
                                   {scenes::membrane_body(law(true, true), 2, ring, 1e-3,
                                                          [&](const scenes::Place& x) {
                                                            return scenes::Place{1 - omega * x[1], 2 + omega * x[0]};
                                                          })},
                                   shape.name, "apic");
    Ledger ledger;
    const auto engine = make_engine(scene, ledger, {});
    Columns& points = scene.bodies[0].points;
    for (int p = 0; p < points.points(); ++p) {
      points(column::affine, 1)[p] = -omega;
      points(column::affine, 2)[p] = omega;
    }
    engine->initialise();
    engine->locate_points();
    engine->map_mass_and_momentum();
    engine->strain_points(0.1, NodalVelocity::start);
    for (int p = 0; p < points.points(); ++p) EXPECT_NEAR(points(column::strain)[p], 0, 1e-13 * omega) << shape.name;
  }
}

TEST(UniaxialMembrane, StepBounds) {
  const UniaxialMembrane membrane = law();
  Columns points = chain(membrane, {{0, 0}, {1, 0}});
  points(column::velocity, 0)[1] = 3;
  points(column::velocity, 1)[1] = 4;
  EXPECT_NEAR(membrane.step_bounds(points, all_points(points), 2).fastest, 5 + 5, rounding);  // sqrt(100 / 4) and |v|
  EXPECT_EQ(membrane.step_bounds(points, all_points(points), 2).diffusivity, 0);
}

TEST(UniaxialMembrane, NamesTheFirstFault) {
  const UniaxialMembrane membrane = law();
  Columns points = chain(membrane, {{0, 0}, {1, 0}});
  EXPECT_EQ(membrane.first_fault(points, all_points(points)).point, -1);
  points(column::strain)[1] = std::nan("");
  EXPECT_EQ(membrane.first_fault(points, all_points(points)).point, 1);
  EXPECT_EQ(membrane.first_fault(points, all_points(points)).field, "strain");
}

// Held out of the plane and free across: of sigma_1 = E/(1 - nu^2) (eps_1 + nu eps_2), sigma_2 = E/(1 - nu^2) (eps_2 + nu
// eps_1), sigma_3 = 0 with eps_2 = 0, and back through the law with strains from stresses. [York 5.12-5.15]
TEST(PlaneStressMembrane, HasTheModulusOfAStripThatIsHeld) {
  PlaneStressMembrane membrane;
  membrane.youngs_modulus = 100;
  membrane.poissons_ratio = 0.3;
  membrane.density = 4;
  const double eps = 0.02, nu = 0.3, e = 100;
  const double along = membrane.modulus() * eps, across = nu * along;
  EXPECT_NEAR((along - nu * across) / e, eps, rounding);
  EXPECT_NEAR((across - nu * along) / e, 0, rounding);
  EXPECT_NEAR(-nu * (along + across) / e, -nu / (1 - nu) * eps, rounding);
  Columns points = make_body("strip", std::make_shared<PlaneStressMembrane>(membrane), 2, 2).points;
  for (int p = 0; p < 2; ++p) {
    points(column::position)[p] = 0.6 * p;
    points(column::position, 1)[p] = 0.8 * p;
    points(column::volume)[p] = 0.5;
    points(column::strain)[p] = eps;
  }
  membrane.evaluate_stress(points, all_points(points), in_plane);
  EXPECT_NEAR(points(column::stress, 0)[0], along * 0.36, rounding);
  EXPECT_NEAR(points(column::stress, 1)[0], along * 0.64, rounding);
  EXPECT_NEAR(points(column::stress, 2)[0], along * 0.48, rounding);
  EXPECT_NEAR(membrane.stored_energy(points, all_points(points)), 2 * 0.5 * along * eps / 2, rounding);
  EXPECT_NEAR(membrane.step_bounds(points, all_points(points), 2).fastest, std::sqrt(100 / 0.91 / 4), rounding);
  EXPECT_EQ(membrane.name(), "plane_stress_membrane");
  membrane.poissons_ratio = 0;
  EXPECT_EQ(membrane.modulus(), 100);
}

// A loop over some of the points does nothing to the others; its sums are theirs alone.
TEST(UniaxialMembrane, RangesLeaveOthersAlone) {
  const UniaxialMembrane membrane = law();
  std::vector<scenes::Place> places;
  for (int k = 0; k < 11; ++k) places.push_back({0.1 * k, 0.03 * k * k});
  const Columns start = [&] {
    Columns points = chain(membrane, places);
    for (int p = 0; p < 11; ++p) {
      points(column::strain)[p] = 0.01 * (p + 1);
      for (int k = 0; k < 3; ++k) points(column::strain_rate, k)[p] = p + k;
    }
    membrane.evaluate_stress(points, all_points(points), in_plane);
    return points;
  }();
  Columns part = start, whole = start;
  const PointRange range{3, 8};
  membrane.advance(part, range, in_plane, 0.1);
  membrane.evaluate_stress(part, range, in_plane);
  membrane.advance(whole, all_points(whole), in_plane, 0.1);
  membrane.evaluate_stress(whole, all_points(whole), in_plane);
  for (const ColumnId* id : {&column::strain, &column::stress, &column::tangent}) {
    for (int k = 0; k < part.components(*id); ++k) {
      for (int p = 0; p < 11; ++p) {
        const bool in = p >= range.first && p < range.last;
        EXPECT_EQ(part(*id, k)[p], (in ? whole : start)(*id, k)[p]) << id->name() << ' ' << p;
      }
    }
  }
  double stored = 0;
  for (int p = range.first; p < range.last; ++p) stored += 0.5 * membrane.energy_density(part(column::strain)[p]);
  EXPECT_NEAR(membrane.stored_energy(part, range), stored, rounding);
  part(column::strain)[2] = std::nan("");
  part(column::velocity)[9] = 1e9;
  EXPECT_EQ(membrane.first_fault(part, range).point, -1);
  EXPECT_NEAR(membrane.step_bounds(part, range, 2).fastest, 5, rounding);
}

}  // namespace
}  // namespace plumbline::uniaxial_membrane_test
