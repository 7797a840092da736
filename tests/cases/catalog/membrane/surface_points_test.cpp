// Points of membranes in space, as their cases lay them out.
#include "cases/catalog/membrane/surface_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "kernel/materials/surface_membrane.hpp"

namespace plumbline::surface_points_test {
namespace {

constexpr double pi = std::numbers::pi;

double area_of(const std::vector<SurfacePoint>& points) {
  double sum = 0;
  for (const SurfacePoint& point : points) sum += point.area;
  return sum;
}

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Tangents are as long as the stretches say and across each other; `out` has nothing along them.
template <class Out>
void expect_tangents(const std::vector<SurfacePoint>& points, double first, double second, Out&& out) {
  for (const SurfacePoint& point : points) {
    EXPECT_NEAR(dot(point.first, point.first), first * first, 1e-12);
    EXPECT_NEAR(dot(point.second, point.second), second * second, 1e-12);
    EXPECT_NEAR(dot(point.first, point.second), 0, 1e-12);
    const Vec3 normal = out(point);
    EXPECT_NEAR(dot(point.first, normal), 0, 1e-12);
    EXPECT_NEAR(dot(point.second, normal), 0, 1e-12);
  }
}

SurfaceChoice any_membrane() {
  SurfaceChoice choice;
  choice.law = {.youngs_modulus = 1, .poissons_ratio = 0.3, .density = 2, .thickness = 0.01};
  return choice;
}

TEST(SurfacePoints, Sphere) {
  const auto points = sphere_points(500, 2, 1.1);
  EXPECT_NEAR(area_of(points), 16 * pi, 1e-12 * 16 * pi);
  expect_tangents(points, 1.1, 1.1, [](const SurfacePoint& point) { return point.place; });
  for (const SurfacePoint& point : points) EXPECT_NEAR(dot(point.place, point.place), 2.2 * 2.2, 1e-12);
  for (const SurfacePoint& point : points) {  // f_1 x f_2 points outwards: a pressure from inside is positive
    const Vec3 &a = point.first, &b = point.second;
    EXPECT_GT(dot({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}, point.place), 0);
  }
}

TEST(SurfacePoints, DiskAndBand) {
  const auto disk = disk_points(1, 0.1, 1.2);
  EXPECT_NEAR(area_of(disk), pi / 1.44, 1e-12);
  expect_tangents(disk, 1.2, 1.2, [](const SurfacePoint&) { return Vec3{0, 0, 1}; });
  auto band = band_points(1, 0.5, 0.1, 1.1, 0.9);
  EXPECT_NEAR(area_of(band), pi, 1e-12);
  const auto outwards = [](const SurfacePoint& point) { return Vec3{point.place[0], point.place[1], 0}; };
  expect_tangents(band, 1.1, 0.9, outwards);
  tilt(band, pi / 2);  // the axis z becomes -y
  expect_tangents(band, 1.1, 0.9, [](const SurfacePoint& point) { return Vec3{point.place[0], 0, point.place[2]}; });
}

TEST(SurfacePoints, MovedAtRandomStayOnTheSphereWithTheirArea) {
  auto points = sphere_points(400, 1, 1.3);
  const auto before = points;
  move_at_random(points, 0.3);
  double moved = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    EXPECT_NEAR(dot(points[p].place, points[p].place), 1.69, 1e-12);
    for (std::size_t d = 0; d < 3; ++d) moved += std::pow(points[p].place[d] - before[p].place[d], 2);
  }
  // Two random numbers of -1 to 1 have the mean square 2/3 together; of 400, to a tenth.
  const double spacing = 1.3 * std::sqrt(4 * pi / 400);
  EXPECT_NEAR(moved / 400, 2.0 / 3 * std::pow(0.3 * spacing, 2), 0.1 * std::pow(0.3 * spacing, 2));
  expect_tangents(points, 1.3, 1.3, [](const SurfacePoint& point) { return point.place; });
  sweep_areas(points);
  EXPECT_NEAR(area_of(points), 4 * pi, 1e-12);
}

TEST(SurfacePoints, BodyHasMassAndVolumeAndEnclosesASphere) {
  const Body body = surface_body("sphere", any_membrane(), sphere_points(800, 1, 1.1), 0.25);
  double mass = 0, volume = 0;
  for (int p = 0; p < 800; ++p) {
    mass += body.points(column::mass)[p];
    volume += body.points(column::volume)[p];
  }
  EXPECT_NEAR(volume, 0.01 * 4 * pi, 1e-12);
  EXPECT_NEAR(mass, 2 * volume, 1e-12);
  EXPECT_NEAR(enclosed_volume(body.points, 0.01), 4 * pi / 3 * 1.331, 1e-12);  // the normals are exact
}

TEST(SurfacePoints, LoadPushesOutwards) {
  Body body = surface_body("sphere", any_membrane(), sphere_points(800, 1, 1), 0.25);
  Columns& points = body.points;
  points.add(column::body_force, 3);
  surface_load(0.01, [](double time, const Columns&) { return 3 * time; })(2, points, body.id);
  for (const int p : {0, 100, 799}) {
    const double share = 6 / (2 * 0.01);  // p A / m
    EXPECT_NEAR(points(column::body_force, 0)[p], share * points(column::position, 0)[p], 1e-10);
    EXPECT_NEAR(points(column::body_force, 1)[p], share * points(column::position, 1)[p], 1e-10);
  }
}

TEST(SurfacePoints, ImagesStandWhereTheRimMirrorsTheirPartners) {
  const Body body = surface_body("disk", any_membrane(), disk_points(1, 0.1, 1), 0.2,
                                 [](const Columns& points) { return images_behind_rim(points, 1, 0.3); });
  const auto images = images_behind_rim(body.points, 1, 0.3);
  EXPECT_FALSE(images.empty());
  for (const OddImage& image : images) {
    const double x = body.points(column::position, 0)[image.partner],
                 y = body.points(column::position, 1)[image.partner];
    EXPECT_NEAR(std::hypot(image.place[0], image.place[1]) + std::hypot(x, y), 2, 1e-12);
    EXPECT_NEAR(image.place[0] * y - image.place[1] * x, 0, 1e-12);
    EXPECT_GE(std::hypot(x, y), 0.7);
  }
}

}  // namespace
}  // namespace plumbline::surface_points_test
