#include "kernel/normals/mass_matrix.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "tests/kernel/dense.hpp"
#include "tests/kernel/normals/curves.hpp"

namespace plumbline::mass_matrix_test {
namespace {

const GridSpec unit_cell = test::square(1, 1);

Eigen::VectorXd linear(double r, double s) {
  return Eigen::Vector4d((1 - r) * (1 - s), r * (1 - s), r * s, (1 - r) * s);
}
// York's nine functions, numbered as he does: centre, east, north-east, north, ... [York A.3.2]
Eigen::VectorXd quadratic(double unit_r, double unit_s) {
  const double r = unit_r - 0.5, s = unit_s - 0.5;
  const double r0 = 0.75 - r * r, s0 = 0.75 - s * s, east = 0.5 * (0.5 + r) * (0.5 + r),
               west = 0.5 * (0.5 - r) * (0.5 - r);
  const double north = 0.5 * (0.5 + s) * (0.5 + s), south = 0.5 * (0.5 - s) * (0.5 - s);
  Eigen::VectorXd n(9);
  n << r0 * s0, east * s0, east * north, r0 * north, west * north, west * s0, west * south, r0 * south, east * south;
  return n;
}

// York's system as printed, membrane colour 1, the other colour 2, by another solver; gradients by differences, exact
// for polynomials of the second degree but for rounding.
template <class Shapes>
void expect_colours(const char* method, const test::Curve& c, double other_r, double other_s, Shapes shapes) {
  const Eigen::Index count = shapes(0.5, 0.5).size();
  Eigen::MatrixXd t = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(count);
  const auto add = [&](double r, double s, double colour) {
    const Eigen::VectorXd n = shapes(r, s);
    t += n * n.transpose();
    rhs += colour * n;
  };
  for (std::size_t p = 0; p < c.size(); ++p) add(c.x[p], c.y[p], 1);
  add(other_r, other_s, 2);
  const Eigen::VectorXd chi = dense::solve(t, rhs);
  const test::Normals n = test::find(method, unit_cell, c);
  for (std::size_t p = 0; p < c.size(); ++p) {
    const double d = 1e-3;
    const double gx = chi.dot(shapes(c.x[p] + d, c.y[p]) - shapes(c.x[p] - d, c.y[p])) / (2 * d);
    const double gy = chi.dot(shapes(c.x[p], c.y[p] + d) - shapes(c.x[p], c.y[p] - d)) / (2 * d);
    // T has the square of the condition of the points' shapes, here up to 1e5.
    EXPECT_LT(test::angle(n.x[p], n.y[p], gx, gy), 1e-3) << method << " point " << p;
  }
}

TEST(MassMatrix, SolvesYorksFourEquations) {  // [York 7.8-7.12, 7.13, 7.14]
  expect_colours("york-mass-matrix", test::arc(0.2, 0.1, 0.7, 5, 75, 9), 0, 0, linear);
  test::Curve bent;
  for (const double x : {0.1, 0.3, 0.45, 0.6, 0.8}) bent.add(x, 0.9 - 0.3 * x - 0.2 * x * x * x, 0, 1);
  expect_colours("york-mass-matrix", bent, 0, 0, linear);
}

TEST(MassMatrix, SolvesYorksNineEquations) {  // [York 7.18, 7.19]
  test::Curve bent;
  for (int k = 0; k < 14; ++k) {
    const double x = 0.03 + 0.07 * k;
    bent.add(x, 0.6 + 0.3 * std::sin(5.5 * x), 0, 1);
  }
  expect_colours("york-mass-matrix-quadratic", bent, 0, 0, quadratic);
}

// Fewer points than colours: of all colours that hold them those of minimum norm, above the membrane's colour.
template <class Shapes>
void expect_least_colours(const char* method, const test::Curve& c, Shapes shapes) {
  const auto points = static_cast<Eigen::Index>(c.size());
  Eigen::MatrixXd a(points + 1, shapes(0.5, 0.5).size());
  for (std::size_t p = 0; p < c.size(); ++p) a.row(static_cast<Eigen::Index>(p)) = shapes(c.x[p], c.y[p]).transpose();
  a.row(points) = shapes(0, 0).transpose();
  const Eigen::VectorXd colours = Eigen::VectorXd::Unit(points + 1, points);
  const Eigen::VectorXd chi = a.transpose() * dense::solve(a * a.transpose(), colours);
  const test::Normals n = test::find(method, unit_cell, c);
  for (std::size_t p = 0; p < c.size(); ++p) {
    const double d = 1e-3, x = c.x[p], y = c.y[p];
    const double gx = chi.dot(shapes(x + d, y) - shapes(x - d, y)), gy = chi.dot(shapes(x, y + d) - shapes(x, y - d));
    EXPECT_LT(test::angle(n.x[p], n.y[p], gx, gy), 1e-8) << method << " point " << p;
  }
}

TEST(MassMatrix, TakesTheLeastColoursWherePointsDoNotDetermineThem) {
  test::Curve few;
  few.add(0.8, 0.3, 0, 1);
  few.add(0.55, 0.62, 0, 1);
  expect_least_colours("york-mass-matrix", few, linear);
  few.add(0.42, 0.9, 0, 1);
  expect_least_colours("york-mass-matrix-quadratic", few, quadratic);
}

TEST(MassMatrix, IsExactOnLinesInAnyDirection) {
  for (const char* method : {"york-mass-matrix", "york-mass-matrix-quadratic"}) {
    for (const double degrees : {0.0, 10.0, 33.0, 45.0, 80.0, 90.0, 120.0, 135.0}) {
      const test::Curve c = test::line(0.45, 0.55, degrees, {-0.41, -0.3, -0.22, -0.1, 0.05, 0.2, 0.33, 0.4});
      EXPECT_LT(test::largest_angle(test::find(method, unit_cell, c), c), 1e-10) << method << " at " << degrees;
    }
  }
}

// xy + 0.1 x + C = 0 is one of the four functions.
TEST(MassMatrix, IsExactOnHyperbolas) {
  test::Curve c;
  for (const double x : {0.3, 0.37, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95}) c.add(x, 0.3 / x - 0.1, 0.3 / x, x);
  EXPECT_LT(test::largest_angle(test::find("york-mass-matrix", unit_cell, c), c), 1e-10);
}

// York's argument after his (7.14): along a line of equal y the x component of the gradient is the same.
// [York 7.15-7.17]
TEST(MassMatrix, EqualOrdinatesHaveEqualComponents) {
  const test::Curve c = test::arc(0.5, 0.4, 0.4, 90 - 41.44, 90 + 41.44, 8);
  const test::Normals n = test::find("york-mass-matrix", unit_cell, c);
  EXPECT_GT(test::largest_angle(n, c), 5);  // the exact components are opposite
  EXPECT_LT(test::largest_angle(test::find("york-mass-matrix-quadratic", unit_cell, c), c), 0.1);
}

TEST(MassMatrix, NineColoursHoldACircle) {
  for (const double turn : {50.0, 60.0, 75.0}) {
    const test::Curve c = test::arc(0.5, 0.5, 0.4, turn - 45, turn + 45, 8);
    EXPECT_LT(test::largest_angle(test::find("york-mass-matrix-quadratic", unit_cell, c), c), 1e-8) << turn;
    EXPECT_GT(test::largest_angle(test::find("york-mass-matrix", unit_cell, c), c), 1) << turn;
  }
}

// His Fig. 80 (b): colours g = d (x - 1/2) (y - y_p) hold all points and have no gradient along x at height y_p.
TEST(MassMatrix, OnePointBesideAVerticalLineHasNoUsefulGradient) {
  test::Curve c = test::line(0.5, 0.5, 90, {-0.44, -0.31, -0.19, -0.06, 0.06, 0.19, 0.31, 0.44});
  c.x[4] += 0.02;
  const test::Normals n = test::find("york-mass-matrix", unit_cell, c);
  for (std::size_t p = 0; p < c.size(); ++p) {
    const double a = test::angle(n.x[p], n.y[p], 1, 0);
    if (p == 4) {
      EXPECT_GT(a, 89);
    } else {
      EXPECT_LT(a, 1e-8);
    }
  }
}

TEST(MassMatrix, APointAloneTakesAGhostCell) {
  // Ten cells of 0.1: a line at 30 degrees, one point in the cell of (0.45, 0.45), two in each of two neighbours.
  const test::Curve c = test::line(0.44, 0.46, 30, {0, -0.06, -0.09, 0.07, 0.1});
  for (const char* method : {"york-mass-matrix", "york-mass-matrix-quadratic"}) {
    const test::Normals n = test::find(method, test::square(10, 0.1), c);
    EXPECT_LT(test::angle(n.x[0], n.y[0], c.nx[0], c.ny[0]), 1e-9) << method;
  }
}

TEST(MassMatrix, AGhostCellReachesBehindAMirror) {
  test::Curve c;
  c.add(0.02, 0.42, 0, 1);  // alone in its cell; its image and it make a line across the wall
  const test::Normals n = test::find("york-mass-matrix", test::square(10, 0.1, true), c);
  EXPECT_LT(test::angle(n.x[0], n.y[0], 0, 1), 1e-9);
}

// York's other answer: nothing of the neighbours, until the point has had no normal yet. [York section 7.8]
TEST(MassMatrix, APointAloneMayKeepItsNormalInsteadOfAGhostCell) {
  const test::Curve c = test::line(0.44, 0.46, 30, {0, -0.06, -0.09, 0.07, 0.1});  // the second and third share a cell
  std::vector<double> nx(5), ny(5), none(5, 0);
  std::vector<double> before_x(5, 0.6), before_y(5, -0.8);
  const auto kept = make_normals("york-mass-matrix-kept");
  kept->find({test::square(10, 0.1), c.x, c.y, {}, {}, before_x, before_y, false}, nx, ny);
  for (const std::size_t alone : {0u, 3u, 4u}) {
    EXPECT_EQ(nx[alone], 0.6) << alone;
    EXPECT_EQ(ny[alone], -0.8) << alone;
  }
  const test::Normals plain = test::find("york-mass-matrix", test::square(10, 0.1), c);
  for (const std::size_t together : {1u, 2u}) {
    EXPECT_EQ(nx[together], plain.x[together]) << together;
    EXPECT_EQ(ny[together], plain.y[together]) << together;
  }
  kept->find({test::square(10, 0.1), c.x, c.y, {}, {}, none, none, false}, nx, ny);
  EXPECT_LT(test::angle(nx[0], ny[0], c.nx[0], c.ny[0]), 1e-9);
}

TEST(MassMatrix, AlonePointsKeepThePreviousNormal) {
  const test::Curve one = test::line(0.55, 0.55, 0, {0});
  const std::vector<double> before_x{0.6}, before_y{-0.8};
  std::vector<double> nx(1), ny(1);
  make_normals("york-mass-matrix")
      ->find({test::square(10, 0.1), one.x, one.y, {}, {}, before_x, before_y, false}, nx, ny);
  EXPECT_EQ(nx[0], 0.6);
  EXPECT_EQ(ny[0], -0.8);
}

}  // namespace
}  // namespace plumbline::mass_matrix_test
