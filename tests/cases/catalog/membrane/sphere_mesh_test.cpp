// Meshes of points on a sphere: what Euler and the geometry of circles on a sphere say of them.
#include "cases/catalog/membrane/sphere_mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cases/catalog/membrane/surface_points.hpp"

namespace plumbline::sphere_mesh_test {
namespace {

using Vec = Eigen::Vector3d;
constexpr double pi = std::numbers::pi;

Columns columns_of(const std::vector<Vec>& places) {
  Columns points(static_cast<int>(places.size()));
  points.add(column::position, 3);
  for (int p = 0; p < points.points(); ++p) {
    for (int d = 0; d < 3; ++d) points(column::position, d)[p] = places[static_cast<std::size_t>(p)][d];
  }
  return points;
}

std::vector<Vec> spiral(int count, double jitter = 0) {
  std::vector<SurfacePoint> points = sphere_points(count, 1, 1);
  if (jitter > 0) move_at_random(points, jitter);
  std::vector<Vec> places;
  for (const SurfacePoint& p : points) places.emplace_back(p.place[0], p.place[1], p.place[2]);
  return places;
}

struct Mesh {
  std::vector<Vec> places;
  std::vector<Triangle> faces;
  explicit Mesh(std::vector<Vec> at) : places(std::move(at)), faces(sphere_mesh(columns_of(places))) {}

  Vec corner(const Triangle& face, std::size_t k) const { return places[static_cast<std::size_t>(face[k])]; }
  Vec twice_area(const Triangle& face) const {
    return (corner(face, 1) - corner(face, 0)).cross(corner(face, 2) - corner(face, 0));
  }
  double area() const {
    double sum = 0;
    for (const Triangle& face : faces) sum += 0.5 * twice_area(face).norm();
    return sum;
  }
  // The largest square of the radius of a face's circle, of points on the unit sphere.
  double largest_circle() const {
    double most = 0;
    for (const Triangle& face : faces) {
      most = std::max(most, 1 - std::pow(twice_area(face).normalized().dot(corner(face, 0)), 2));
    }
    return most;
  }
  long edges() const {
    std::set<std::pair<int, int>> all;
    for (const Triangle& face : faces) {
      for (std::size_t k = 0; k < 3; ++k) all.insert(std::minmax({face[k], face[(k + 1) % 3]}));
    }
    return static_cast<long>(all.size());
  }
};

TEST(SphereMesh, VerticesLessEdgesPlusFacesAreTwo) {
  for (const double jitter : {0.0, 0.3}) {
    for (const int count : {4, 5, 50, 800}) {
      const Mesh mesh(spiral(count, jitter));
      EXPECT_EQ(count - mesh.edges() + static_cast<long>(mesh.faces.size()), 2) << count;
    }
  }
}

TEST(SphereMesh, NoPointLiesBeyondAFace) {
  const Mesh mesh(spiral(300, 0.3));
  for (const Triangle& face : mesh.faces) {
    const Vec normal = mesh.twice_area(face).normalized();
    EXPECT_GT(normal.dot(mesh.corner(face, 0)), 0);  // counter-clockwise from outside
    for (const Vec& x : mesh.places) EXPECT_LT(normal.dot(x - mesh.corner(face, 0)), 1e-14);
  }
}

// Seen from the centre a face with a circle of the radius r covers its area times 1 / d^2 at the distance d, 1 - r^2 <= d^2 <= 1,
// under an angle of the same bounds: the area is that of the sphere less a share of r^2 at most.
TEST(SphereMesh, AreaTendsToThatOfTheSphereWithTheSquareOfTheSpacing) {
  double before = 0;
  for (const int count : {200, 800, 3200}) {
    const Mesh mesh(spiral(count));
    const double missing = 1 - mesh.area() / (4 * pi);
    EXPECT_GT(missing, 0);
    EXPECT_LT(missing, mesh.largest_circle());
    if (before > 0) {  // points four times as many; what is left over is of the next power, 1/50 at most, and the poles
      EXPECT_NEAR(before / missing, 4, 0.2);
    }
    before = missing;
  }
}

TEST(SphereMesh, PointsOnOneCircleHaveAMeshToo) {  // a cube
  std::vector<Vec> cube;
  for (int k = 0; k < 8; ++k) cube.emplace_back(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
  const Mesh mesh(cube);
  EXPECT_EQ(mesh.faces.size(), 12U);
  EXPECT_NEAR(mesh.area(), 24, 1e-14);
}

TEST(SphereMesh, ClearErrors) {
  std::vector<Vec> places = spiral(30);
  places.push_back(places[7]);
  EXPECT_THROW(sphere_mesh(columns_of(places)), std::invalid_argument);  // twice in one place
  places.back() = Vec(0.1, 0, 0);
  EXPECT_THROW(sphere_mesh(columns_of(places)), std::invalid_argument);  // inside
  EXPECT_THROW(sphere_mesh(columns_of(spiral(3))), std::invalid_argument);
  EXPECT_THROW(sphere_mesh(columns_of({{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}})), std::invalid_argument);
  EXPECT_THROW(sphere_mesh(columns_of({})), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::sphere_mesh_test
