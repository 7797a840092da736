// Points of rings: volumes, moments, edges.
#include "cases/catalog/solid/annulus_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kernel/materials/neo_hookean.hpp"
#include "kernel/shapes/domain_columns.hpp"

namespace plumbline::annulus_points_test {
namespace {

std::shared_ptr<NeoHookean> rubber() {
  auto material = std::make_shared<NeoHookean>();
  material->youngs_modulus = material->density = 1;
  return material;
}

GridSpec grid(double h) {
  GridSpec grid;
  grid.dim = 2;
  grid.h = h;
  grid.origin = {-3, -3, 0};
  grid.cells = {static_cast<int>(6 / h), static_cast<int>(6 / h), 1};
  return grid;
}

struct Sums {
  double area = 0, mass = 0, x = 0, y = 0, polar = 0, least = 1e9, most = 0;
  explicit Sums(const Body& body) {
    for (int p = 0; p < body.points.points(); ++p) {
      const double v = body.points(column::volume)[p], px = body.points(column::position, 0)[p];
      const double py = body.points(column::position, 1)[p], r = std::hypot(px, py);
      area += v;
      mass += body.points(column::mass)[p];
      x += v * px;
      y += v * py;
      polar += v * r * r;
      least = std::min(least, r);
      most = std::max(most, r);
    }
  }
};

constexpr double area(double inner, double outer) { return std::numbers::pi * (outer * outer - inner * inner); }

TEST(AnnulusPoints, CirclesHaveTheExactArea) {
  for (const bool quarter : {false, true}) {
    const Annulus a{0.5, 1, {0, 0}, quarter};
    const Body body = ring_annulus("ring", rubber(), a, 3, 2, grid(0.1));
    const Sums sums(body);
    EXPECT_NEAR(sums.area, area(0.5, 1) * (quarter ? 0.25 : 1), 1e-13);
    EXPECT_NEAR(sums.mass, 3 * sums.area, 1e-12);
    EXPECT_GT(sums.least, 0.5);
    EXPECT_LT(sums.most, 1);
    EXPECT_NEAR(body.spacing, 0.05, 0.1 * 0.05);
    EXPECT_NEAR(sums.x - (quarter ? sums.y : 0), 0, 1e-13);  // symmetric
  }
}

// Radial centres of mass: the polar moment, int r^3, is short by the bands' own variance, width^2/12 of the area.
TEST(AnnulusPoints, CirclesStandAtTheirCentresOfMass) {
  const Body body = ring_annulus("ring", rubber(), {0.5, 1}, 1, 2, grid(0.1));
  const double exact = std::numbers::pi / 2 * (1 - 0.0625), missing = area(0.5, 1) * 0.05 * 0.05 / 12;
  EXPECT_NEAR(Sums(body).polar, exact - missing, 0.02 * missing);
}

TEST(AnnulusPoints, WholeSquaresHaveTheirCentresInside) {
  const Body body = fill_annulus("ring", rubber(), {0.5, 1, {0, 0}, true}, 1, 2, grid(0.1));
  const Sums sums(body);
  EXPECT_GE(sums.least, 0.5);
  EXPECT_LE(sums.most, 1);
  for (int p = 0; p < body.points.points(); ++p) EXPECT_DOUBLE_EQ(body.points(column::volume)[p], 0.0025);
  EXPECT_NEAR(sums.area, area(0.5, 1) / 4, 0.05);
}

TEST(AnnulusPoints, CutSquaresKeepAreaAndMoments) {
  for (const bool quarter : {false, true}) {
    const Body body = cut_annulus("ring", rubber(), {0.5, 1, {0, 0}, quarter}, 2, 2, grid(0.1));
    const Sums sums(body);
    const double share = quarter ? 0.25 : 1;
    EXPECT_NEAR(sums.area, share * area(0.5, 1), 1e-3 * area(0.5, 1));  // sampled 40 x 40
    EXPECT_NEAR(sums.mass, 2 * sums.area, 1e-12);
    double polar = sums.polar;  // with the boxes' own moments, l^2/3
    double least = 1;
    for (int p = 0; p < body.points.points(); ++p) {
      for (int d = 0; d < 2; ++d) {
        const double half = body.points(column::half_size, d)[p];
        EXPECT_EQ(half, body.points(column::half_size_at_start, d)[p]);
        EXPECT_GT(half, 0.1 * 0.05);
        EXPECT_LT(half, 0.06);
        polar += body.points(column::volume)[p] * half * half / 3;
      }
      least = std::min(least, body.points(column::volume)[p]);
    }
    EXPECT_NEAR(polar, share * std::numbers::pi / 2 * (1 - 0.0625), 2e-3 * polar);
    EXPECT_GE(least, 0.49 * 0.0025);  // nothing smaller than half a square
  }
}

// Inside, cut squares are whole squares of the lattice.
TEST(AnnulusPoints, CutSquaresAreWholeInside) {
  const Body body = cut_annulus("disk", rubber(), {0, 1}, 1, 2, grid(0.2));
  int whole = 0;
  for (int p = 0; p < body.points.points(); ++p) {
    if (std::hypot(body.points(column::position, 0)[p], body.points(column::position, 1)[p]) > 0.8) continue;
    EXPECT_NEAR(body.points(column::volume)[p], 0.01, 1e-15);
    EXPECT_NEAR(body.points(column::half_size, 0)[p], 0.05, 1e-12);
    EXPECT_NEAR(std::abs(std::remainder(body.points(column::position, 0)[p], 0.1)), 0.05, 1e-12);
    ++whole;
  }
  EXPECT_GT(whole, 150);
}

// Sectors stand at their centres of mass, so that first moments are exact, and their parallelograms have their areas: half
// edges along the radius and across it.
TEST(AnnulusPoints, SectorsHaveTheirMomentsAndAreas) {
  for (const bool quarter : {false, true}) {
    const Body body = polar_annulus("ring", rubber(), {0.5, 1, {0, 0}, quarter}, 3, 2, grid(0.1));
    const Sums sums(body);
    EXPECT_NEAR(sums.area, area(0.5, 1) * (quarter ? 0.25 : 1), 1e-13);
    EXPECT_NEAR(sums.mass, 3 * sums.area, 1e-12);
    EXPECT_NEAR(sums.x, quarter ? (1 - 0.125) / 3 : 0, 1e-13);
    EXPECT_NEAR(sums.y, quarter ? (1 - 0.125) / 3 : 0, 1e-13);
    for (int p = 0; p < body.points.points(); ++p) {
      const auto edge = [&](int k) { return body.points(column::half_edges_at_start, k)[p]; };
      const double x = body.points(column::position, 0)[p], y = body.points(column::position, 1)[p];
      EXPECT_NEAR(4 * (edge(0) * edge(3) - edge(1) * edge(2)), body.points(column::volume)[p], 1e-15);
      EXPECT_NEAR(x * edge(1) - y * edge(0), 0, 1e-15);
      EXPECT_NEAR(x * edge(2) + y * edge(3), 0, 1e-15);
      EXPECT_NEAR(std::hypot(edge(0), edge(1)), 0.025, 1e-15);
      // The middle arc: as many sectors in each band as suit the middle of the ring.
      const int count = quarter ? 24 : 94;
      const double angle = (quarter ? 0.5 : 2) * std::numbers::pi / count;
      EXPECT_NEAR(std::remainder(std::atan2(y, x) - angle / 2, angle), 0, 1e-13);
      EXPECT_NEAR(std::hypot(edge(2), edge(3)), std::hypot(x, y) * angle / 2, 0.01 * 0.025);
    }
  }
}

TEST(AnnulusPoints, LayoutsByName) {
  EXPECT_EQ(annulus_layout("polar"), &polar_annulus);
  EXPECT_EQ(annulus_layout("cut"), &cut_annulus);
  EXPECT_EQ(annulus_layout("circles"), &ring_annulus);
  EXPECT_EQ(annulus_layout("lattice"), &fill_annulus);
}

}  // namespace
}  // namespace plumbline::annulus_points_test
