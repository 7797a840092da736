// The inextensible bag: the Mylar balloon, its forces, the slope of its volume, both kinds of contact with the probe.
#include "reference/inextensible_bag.hpp"

#include "reference/circle.hpp"
#include "reference/elementary.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::inextensible_bag_test {
namespace {

// I. M. Mladenov, J. Oprea, Amer. Math. Monthly 110 (2003) 761: of a balloon of radius 1 the meridian is 2 * 1.3110288,
// the thickness 2 * 0.5990701, the volume 2/3 pi times half the meridian.
TEST(InextensibleBag, UntouchedItIsTheMylarBalloon) {
  const InextensibleBag bag(2.6220575542921, 0.3);
  expect_near(bag.free_radius(), 1, 1e-9);
  expect_near(bag.free_height(), 2 * 0.5990701173678, 1e-9);
  expect_near(bag.free_volume(), 2.0 / 3 * pi.value * 1.3110287771461, 1e-9);
  const BagShape shape = bag.at(bag.free_height());
  EXPECT_LE(shape.plate_radius.value, 1e-6);
  EXPECT_NEAR(shape.volume.value, bag.free_volume().value, 1e-14);
}

// The last shape that is kept stands at the edge of what the skin can close around: no rounding may lead beyond it.
TEST(InextensibleBag, EveryMeridianHasItsShapes) {
  for (int k = 0; k < 100; ++k) {
    for (double radius : {0.05, 0.1, 0.25}) {
      const double meridian = 0.7 + 6e-4 * k;
      ASSERT_NO_THROW(InextensibleBag(meridian, radius)) << meridian << " " << radius;
    }
  }
}

class Bags : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Probes, Bags, testing::Values(0.02, 0.1, 0.17, 0.25, 0.6));

std::vector<double> heights(const InextensibleBag& bag) {
  std::vector<double> all;
  for (double share : {0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99})
    all.push_back(bag.free_height().value - share * (bag.free_height().value - bag.least_height()));
  return all;
}

// The skin alone: plate and probe push with q pi b^2 each; on the probe that is the gas on the face and the pull at its
// edge.
TEST_P(Bags, ForcesBalance) {
  const InextensibleBag bag(0.7, GetParam());
  for (double height : heights(bag)) {
    const BagShape shape = bag.at(height);
    const Bounded pull = Bounded(2) * pi * shape.tension * sin(shape.edge_angle);
    const Bounded face = pi * shape.probe_radius * shape.probe_radius;
    expect_zero(face + pull - shape.pressed_area, 0.7 * 0.7, "probe", 1e-11);
    // half a bag, cut at the equator: the tension all around carries the gas on the ring outside the contact
    const Bounded ring = pi * (shape.equator * shape.equator - shape.plate_radius * shape.plate_radius);
    expect_zero(Bounded(2) * pi * shape.tension - ring, 0.7 * 0.7, "equator", 1e-11);
    EXPECT_EQ(shape.edge_angle.value > 0, shape.plate_radius.value > GetParam());
  }
}

// dV/dH = pi b^2, by central differences: their error is h^2 V'''/6.
TEST_P(Bags, VolumeFallsWithThePressedArea) {
  const InextensibleBag bag(0.7, GetParam());
  const double h = 1e-4;
  for (double height : heights(bag)) {
    if (height + h > bag.free_height().value || height - h < bag.least_height()) continue;
    const double slope = (bag.at(height + h).volume - bag.at(height - h).volume).value / (2 * h);
    const double kink = std::abs(height - bag.edge_height()) < h ? h : 0;  // the second derivative jumps
    EXPECT_NEAR(bag.at(height).pressed_area.value, slope, 1e-6 + 10 * kink) << height;
  }
}

// dV/dS = pi l^2: a longer skin at the same gap.
TEST_P(Bags, VolumeGrowsWithTheMeridian) {
  const double h = 1e-5;
  const InextensibleBag bag(0.7, GetParam()), longer(0.7 + h, GetParam()), shorter(0.7 - h, GetParam());
  for (double height : heights(bag)) {
    if (height > shorter.free_height().value || height < longer.least_height()) continue;
    const double slope = (longer.at(height).volume - shorter.at(height).volume).value / (2 * h);
    EXPECT_NEAR(2 * pi.value * bag.at(height).tension.value, slope, 1e-6) << height;
  }
}

TEST_P(Bags, Scale) {
  const InextensibleBag bag(0.7, GetParam()), large(2.8, 4 * GetParam());
  for (double height : heights(bag)) {
    const BagShape a = bag.at(height), b = large.at(4 * height);
    expect_same(b.volume, a.volume, 64);
    expect_same(b.plate_radius, a.plate_radius, 4);
    expect_same(b.equator, a.equator, 4);
    expect_same(b.edge_angle, a.edge_angle);
  }
}

TEST_P(Bags, BoundsAreSmall) {
  const InextensibleBag bag(0.7, GetParam());
  for (double height : heights(bag)) {
    const BagShape shape = bag.at(height);
    EXPECT_LE(shape.volume.bound, 1e-12 * shape.volume.value) << height;
    EXPECT_LE(shape.plate_radius.bound, 1e-10 * shape.plate_radius.value) << height;
  }
}

// Nearly flat between wide plates it is a disk with a rim that is half a circle: S = 2 b + pi H/2, R = b + H/2, to the
// next order in H/b.
TEST(InextensibleBag, FlatItIsADisk) {
  const InextensibleBag bag(1, 2);
  const double height = 0.008;
  const BagShape shape = bag.at(height);
  const double b = 0.5 * (1 - 0.5 * pi.value * height), order = height * height / b;
  EXPECT_NEAR(shape.plate_radius.value, b, order);
  EXPECT_NEAR(shape.equator.value, b + 0.5 * height, order);
  EXPECT_NEAR(shape.volume.value, pi.value * height * b * (b + 0.25 * pi.value * height), order * height);
}

TEST(InextensibleBag, ReachesTheEdgeWhereItsContactIsAsWide) {
  const InextensibleBag bag(0.7, 0.1);
  EXPECT_NEAR(bag.at(bag.edge_height()).plate_radius.value, 0.1, 1e-12);
  EXPECT_EQ(InextensibleBag(0.7, 0.6).edge_height(), InextensibleBag(0.7, 0.6).least_height());
}

TEST(InextensibleBag, WrongArgumentsAreRefusedByKey) {
  EXPECT_EQ(refused_key([] { InextensibleBag(0, 1); }), "meridian");
  EXPECT_EQ(refused_key([] { InextensibleBag(1, 0); }), "probe_radius");
  const InextensibleBag bag(1, 0.1);
  EXPECT_EQ(refused_key([&] { bag.at(0.46); }), "height");
  EXPECT_EQ(refused_key([&] { bag.at(0.9 * bag.least_height()); }), "height");
}

}  // namespace
}  // namespace plumbline::reference::inextensible_bag_test
