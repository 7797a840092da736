// The ring that is twisted: its points, their images, and what it refuses.
#include "cases/catalog/membrane/twisted_ring.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "cases/harness/description/case.hpp"
#include "cases/harness/files/errors.hpp"

namespace plumbline::twisted_ring_test {
namespace {

Settings settings(const std::vector<Override>& keys = {}) {
  return find_case("twisted-annulus").settings("default", keys);
}

std::string refused_key(const std::vector<Override>& keys) {
  try {
    TwistedAnnulus(settings(keys)).exact();
  } catch (const UsageError& error) {
    return error.key;
  }
  return "accepted";
}

// A point stands for a part of the ring at rest; its second tangent is how places change around a ring, by central differences over
// one point: their error is a sixth of the square of the angle between points.
TEST(TwistedRing, TangentsAreThoseOfItsPlaces) {
  const Settings chosen = settings();
  const TwistedRing ring(TwistedAnnulus(chosen), 16);
  const std::vector<SurfacePoint> points = ring.points();
  double area = 0;
  for (const SurfacePoint& point : points) area += point.area;
  EXPECT_NEAR(area, std::numbers::pi * 0.75, 1e-12);
  const int count = static_cast<int>(std::lround(std::numbers::pi * 1.5 * 16));
  const double between = 2 * std::numbers::pi / count;
  for (std::size_t j = 1; j + 1 < static_cast<std::size_t>(count); ++j) {
    for (std::size_t d = 0; d < 2; ++d) {
      const double slope = (points[j + 1].place[d] - points[j - 1].place[d]) / (2 * between * ring.radius(0));
      EXPECT_NEAR(points[j].second[d], slope, between * between / 5);
    }
  }
}

TEST(TwistedRing, ImagesAreReflectedAtPlacesOnTheRims) {
  const Settings chosen = settings();
  const TwistedRing ring(TwistedAnnulus(chosen), 16);
  const Body body = surface_body("ring", TwistedAnnulus(chosen).choice, ring.points(), 0.125);
  const std::vector<OddImage> images = ring.images(body.points, 3);
  EXPECT_EQ(images.size(), 2U * 3U * 75U);
  for (const OddImage& image : images) {
    const double x = 0.5 * (image.place[0] + body.points(column::position, 0)[image.partner]);
    const double y = 0.5 * (image.place[1] + body.points(column::position, 1)[image.partner]);
    const Seat seat = ring.seat(body.points, image.partner);
    const bool inner = seat.ring < 3;
    EXPECT_NEAR(std::hypot(x, y), inner ? 0.5 : 1, 1e-12);
    EXPECT_NEAR(std::remainder(std::atan2(y, x) - seat.angle, 2 * std::numbers::pi), inner ? -0.05 : 0, 1e-12);
  }
}

TEST(TwistedRing, WhatIsNotWrinkledEverywhereIsRefusedByKey) {
  EXPECT_EQ(refused_key({}), "accepted");
  EXPECT_EQ(refused_key({{"poissons_ratio", 0.3}}), "poissons_ratio");
  EXPECT_EQ(refused_key({{"twist", 0.9}}), "twist");
  EXPECT_EQ(refused_key({{"surface_density", 5e-324}}), "surface_density");
  EXPECT_EQ(refused_key({{"youngs_modulus", 5e-324}, {"surface_density", 1e10}}), "surface_density");
}

}  // namespace
}  // namespace plumbline::twisted_ring_test
