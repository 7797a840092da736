// Strings of points: masses, volumes and rest lengths by both measures of strain, and what is measured of them.
#include "cases/catalog/membrane/string.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>

#include "kernel/materials/segment_membrane.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline::string_test {
namespace {

const StringMaterial rubber{.youngs_modulus = 2e5, .area = 0.3, .density = 7, .one_way = false};

double total(const Body& body, const ColumnId& id) {
  const auto values = body.points.values(id);
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(String, StraightStringIsEvenBetweenItsEnds) {
  const StringState state = straight_string({1, 2}, {4, 6}, 11, 0.02);
  ASSERT_EQ(state.place.size(), 11u);
  EXPECT_EQ(state.place.front()[0], 1);
  EXPECT_EQ(state.place.back()[1], 6);
  EXPECT_NEAR(state.place[5][0], 2.5, 1e-15);
  EXPECT_NEAR(state.place[5][1], 4, 1e-15);
  for (const double length : state.segment_length) EXPECT_NEAR(length, 0.5, 1e-15);
  for (const double strain : state.strain) EXPECT_EQ(strain, 0.02);
  for (const double strain : state.segment_strain) EXPECT_EQ(strain, 0.02);
}

TEST(String, OnePointIsNoString) { EXPECT_THROW(straight_string({0, 0}, {1, 0}, 1), std::invalid_argument); }

TEST(String, PartsThatDoNotFitAreRefused) {
  for (int part = 0; part < 3; ++part) {
    StringState state = straight_string({0, 0}, {1, 0}, 5);
    (part == 0 ? state.strain : part == 1 ? state.segment_strain : state.segment_length).push_back(0);
    EXPECT_THROW(string_body("string", "accumulated", rubber, state, 2), std::invalid_argument) << part;
  }
}

// Half a segment at either end makes mass and volume exact; York's whole points are one too many.
TEST(String, MassAndVolume) {
  const StringState state = straight_string({0, 0}, {3, 4}, 9);
  for (const char* strain : {"accumulated", "segments"}) {
    const Body half = string_body("string", strain, rubber, state, 2);
    EXPECT_NEAR(total(half, column::volume), 0.3 * 5, 1e-14);
    EXPECT_NEAR(total(half, column::mass), 7 * 0.3 * 5, 1e-13);
    EXPECT_NEAR(half.points(column::volume)[0], 0.3 * 5 / 16, 1e-15);
    EXPECT_NEAR(half.points(column::volume)[1], 0.3 * 5 / 8, 1e-15);
    EXPECT_NEAR(half.spacing, 5.0 / 8, 1e-15);
    const Body whole = string_body("string", strain, rubber, state, 2, StringEnds::whole);
    EXPECT_NEAR(total(whole, column::mass), 7 * 0.3 * 5 * 9 / 8, 1e-13);
  }
}

// The section is that of the lengths given, whatever the places: a string pushed together keeps its mass.
TEST(String, MassFollowsTheLengthsGivenNotThePlaces) {
  StringState state = straight_string({0, 0}, {0.9, 0}, 4);
  state.segment_length = {0.2, 0.3, 0.5};
  const Body body = string_body("string", "accumulated", rubber, state, 1);
  const double share[] = {0.1, 0.25, 0.4, 0.25};
  for (int p = 0; p < 4; ++p) EXPECT_NEAR(body.points(column::mass)[p], 7 * 0.3 * share[p], 1e-15) << p;
}

// A segment of rest length l/(1 + eps) that is l long has the strain eps and pulls with E A eps. [Segments 1, 2]
TEST(String, RestLengthsMakeTheStrainsAsked) {
  StringState state = straight_string({0, 0}, {3, 4}, 6);
  state.segment_strain = {0.01, 0.02, 0.03, -0.04, 0.05};
  const Body body = string_body("string", "segments", rubber, state, 2);
  const auto& material = dynamic_cast<const SegmentMembrane&>(*body.material);
  for (int s = 0; s < 5; ++s) {
    const double strain = state.segment_strain[static_cast<std::size_t>(s)];
    EXPECT_NEAR(1.0 / body.points(column::rest_length)[s] - 1, strain, 1e-14);
    EXPECT_EQ(body.points(column::strain)[s], strain);
  }
  EXPECT_EQ(material.section, 0.3);
  EXPECT_NEAR(material.tension(0.01), 2e5 * 0.3 * 0.01, 1e-12);
}

TEST(String, MaterialsAreAsAsked) {
  const StringState state = straight_string({0, 0}, {1, 0}, 5, 0.01);
  const Body sums = string_body("string", "accumulated", rubber, state, 2);
  const auto& membrane = dynamic_cast<const UniaxialMembrane&>(*sums.material);
  EXPECT_EQ(membrane.youngs_modulus, 2e5);
  EXPECT_EQ(membrane.density, 7);
  EXPECT_FALSE(membrane.one_way);
  EXPECT_FALSE(membrane.closed);
  EXPECT_EQ(sums.points(column::strain)[3], 0.01);
  EXPECT_TRUE(sums.chain);
  const Body lengths = string_body("string", "segments", rubber, state, 2);
  const auto& segments = dynamic_cast<const SegmentMembrane&>(*lengths.material);
  EXPECT_EQ(segments.density, 7);
  EXPECT_FALSE(segments.one_way);
}

// The same tension on a node from both measures: V sigma = A E eps ds.
TEST(String, BothMeasuresPullAlike) {
  const StringState state = straight_string({0, 0}, {1, 0}, 5, 0.01);
  Body sums = string_body("string", "accumulated", rubber, state, 1);
  sums.material->evaluate_stress(sums.points, all_points(sums.points), {.dim = 1, .h = 1});
  Body lengths = string_body("string", "segments", rubber, state, 1);
  lengths.material->evaluate_stress(lengths.points, all_points(lengths.points), {.dim = 1, .h = 1});
  const double tension = 2e5 * 0.3 * 0.01;
  EXPECT_NEAR(sums.points(column::stress)[2] * sums.points(column::volume)[2], tension * 0.25, 1e-10);
  EXPECT_NEAR(lengths.points(column::stress)[0] * lengths.points(column::volume)[0], -tension, 1e-10);
  EXPECT_NEAR(lengths.points(column::stress)[2], 0, 1e-9);
}

TEST(String, MisalignmentIsTheLargestDistanceFromTheChord) {
  Body body = string_body("string", "accumulated", rubber, straight_string({0, 0}, {3, 4}, 6), 2);
  EXPECT_NEAR(misalignment(body.points), 0, 1e-15);
  EXPECT_NEAR(chord_length(body.points), 5, 1e-15);
  body.points(column::position)[2] += 0.1 * 0.8;  // along the normal (4, -3)/5, and as much again along the chord
  body.points(column::position, 1)[2] -= 0.1 * 0.6;
  body.points(column::position)[3] += 0.05 * 0.6;
  body.points(column::position, 1)[3] += 0.05 * 0.8;
  EXPECT_NEAR(misalignment(body.points), 0.1, 1e-14);
}

TEST(String, EnergyDriftIsIntegrationAndTransferOverTheScale) {
  Account energy;
  energy.open(0, 4);
  energy.book(Flow::integration, 0.3);
  energy.book(Flow::transfer, -0.1);
  energy.book(Flow::walls, 5);
  EXPECT_NEAR(energy_drift(energy), 0.05, 1e-15);
}

TEST(String, TheKeyNamesBothMeasures) {
  const Key key = strain_key();
  EXPECT_EQ(key.name, "strain");
  EXPECT_EQ(std::get<std::string>(key.value), "segments");
  EXPECT_EQ(std::get<std::string>(york_strain().second), "accumulated");
  EXPECT_EQ(key.choices, (std::vector<std::string>{"accumulated", "segments"}));
}

}  // namespace
}  // namespace plumbline::string_test
