// Normals by fits to points in space: exact where the surface is one of those fitted, off by no more than what is left over.
// [Surface 15, 16]
#include "kernel/normals/surface_fit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "tests/kernel/scenes.hpp"

namespace plumbline::surface_fit_test {
namespace {

using Vec = Eigen::Vector3d;
constexpr double reach = 0.35;

// 15 x 15 points 0.1 apart, moved by up to `jitter`, lifted to z(u, v) and turned.
template <class Height>
std::vector<Vec> sheet(double jitter, const Eigen::Matrix3d& turn, Height&& z) {
  scenes::Random random(5);
  std::vector<Vec> points;
  for (int k = 0; k < 225; ++k) {
    const double u = 0.1 * (k % 15 - 7) + random(-jitter, jitter), v = 0.1 * (k / 15 - 7) + random(-jitter, jitter);
    points.push_back(turn * Vec(u, v, z(u, v)));
  }
  return points;
}

double angle(const Vec& a, const Vec& b) { return std::atan2(a.cross(b).norm(), std::abs(a.dot(b))); }

const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.7, Vec(1, 2, -1).normalized()).toRotationMatrix();

TEST(SurfaceFit, PlanesAreExact) {
  const std::vector<Vec> points = sheet(0.03, turned, [](double u, double v) { return 0.4 * u - 0.2 * v; });
  const Vec exact = turned * Vec(-0.4, 0.2, 1).normalized();
  for (const SurfaceFit fit : {SurfaceFit::plane, SurfaceFit::quadric}) {
    for (const Vec& n : fitted_normals(points, reach, fit)) {
      EXPECT_LE(angle(n, exact), 1e-12);  // rounding over the share of a point in its patch
      EXPECT_NEAR(n.norm(), 1, 1e-14);
    }
  }
}

// At the vertex of a paraboloid the points around, regular, lie evenly about the axis: heights over the plane are quadratic.
TEST(SurfaceFit, VertexOfAParaboloidIsExact) {
  const std::vector<Vec> points = sheet(0, turned,
                                        [](double u, double v) { return u * u - 0.5 * v * v + 0.3 * u * v; });
  const Vec exact = turned * Vec::UnitZ();
  EXPECT_LE(angle(fitted_normals(points, reach, SurfaceFit::quadric)[112], exact), 1e-12);
  EXPECT_LE(angle(fitted_normals(points, reach, SurfaceFit::plane)[112], exact), 1e-12);
}

// Irregular points of a sphere of radius 2: a plane is off by no more than the slope of the curvature within reach, r/R, a quadric by
// no more than that of r^4/(8 R^3); and both see it.
TEST(SurfaceFit, SpheresAreMetAsFarAsTheFitGoes) {
  const std::vector<Vec> points = sheet(0.03, turned, [](double u, double v) { return std::sqrt(4 - u * u - v * v); });
  const auto largest = [&](SurfaceFit fit) {
    const std::vector<Vec> normals = fitted_normals(points, reach, fit);
    double most = 0;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const double off = std::max(std::abs(static_cast<double>(p % 15) - 7), std::abs(static_cast<double>(p / 15) - 7));
      if (off <= 3) most = std::max(most, angle(normals[p], points[p]));
    }
    return most;
  };
  EXPECT_LE(largest(SurfaceFit::plane), reach / 2);
  EXPECT_GE(largest(SurfaceFit::plane), 1e-3);
  EXPECT_LE(largest(SurfaceFit::quadric), std::pow(reach / 2, 3) / 2);
  EXPECT_GE(largest(SurfaceFit::quadric), 1e-6);
}

TEST(SurfaceFit, RefusesPointsThatDetermineNoFit) {
  const std::vector<Vec> points = sheet(0, turned, [](double, double) { return 0.0; });
  EXPECT_THROW(fitted_normals(points, 0.05, SurfaceFit::plane), std::invalid_argument);
  EXPECT_THROW(fitted_normals(points, 0.11, SurfaceFit::quadric), std::invalid_argument);
  EXPECT_THROW(fitted_normals(points, 0, SurfaceFit::plane), std::invalid_argument);
  std::vector<Vec> line, rows;  // enough points, and none across
  for (int k = 0; k < 9; ++k) {
    line.emplace_back(0.03 * k, 0.06 * k, 0);
    for (const double y : {0.0, 0.1}) rows.emplace_back(0.03 * k, y, 0);
  }
  EXPECT_THROW(fitted_normals(line, 1, SurfaceFit::plane), std::invalid_argument);
  EXPECT_NO_THROW(fitted_normals(rows, 1, SurfaceFit::plane));
  EXPECT_THROW(fitted_normals(rows, 1, SurfaceFit::quadric), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::surface_fit_test
