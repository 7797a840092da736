// Norms against numbers worked out by hand, and that nothing swallows a NaN.
#include "cases/harness/description/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumbline::measures_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Volumes 1, 2, 1; errors 3, 1, 0.
const std::vector<FieldSample> samples{{1, 0.1, 5, 2, 0.5}, {2, 0.2, 3, 4, 0.25}, {1, 0.3, -7, -7, 0}};

TEST(Norms, AreWeightedByVolume) {
  const auto norms = field_norms("density", "kg/m^3", samples);
  ASSERT_EQ(norms.size(), 3u);
  EXPECT_EQ(norms[0].name, "density.L1");
  EXPECT_EQ(norms[1].name, "density.L2");
  EXPECT_EQ(norms[2].name, "density.Linf");
  EXPECT_DOUBLE_EQ(norms[0].error, (1 * 3 + 2 * 1) / 4.0);
  EXPECT_DOUBLE_EQ(norms[1].error, std::sqrt((1 * 9 + 2 * 1) / 4.0));
  EXPECT_DOUBLE_EQ(norms[2].error, 3);
}

TEST(Norms, ScaleAndBoundAreTheSameNormsOfTheReference) {
  const auto norms = field_norms("density", "kg/m^3", samples);
  EXPECT_DOUBLE_EQ(norms[0].scale, (1 * 2 + 2 * 4 + 1 * 7) / 4.0);
  EXPECT_DOUBLE_EQ(norms[1].scale, std::sqrt((1 * 4 + 2 * 16 + 1 * 49) / 4.0));
  EXPECT_DOUBLE_EQ(norms[2].scale, 7);
  EXPECT_DOUBLE_EQ(norms[0].reference_bound, (0.5 + 2 * 0.25) / 4.0);
  EXPECT_DOUBLE_EQ(norms[1].reference_bound, std::sqrt((0.25 + 2 * 0.0625) / 4.0));
  EXPECT_DOUBLE_EQ(norms[2].reference_bound, 0.5);
  for (const Measure& norm : norms) {
    EXPECT_EQ(norm.unit, "kg/m^3");
    EXPECT_FALSE(norm.value);
    EXPECT_FALSE(norm.reference);
  }
}

// Twice as many points of half the volume are the same field: a mean over points would not see it so.
TEST(Norms, DoNotDependOnHowAVolumeIsDividedIntoPoints) {
  std::vector<FieldSample> divided;
  for (const FieldSample& s : samples) {
    const int parts = s.computed != s.exact ? 4 : 1;
    for (int k = 0; k < parts; ++k) divided.push_back({s.volume / parts, s.position, s.computed, s.exact, s.bound});
  }
  const auto whole = field_norms("x", "1", samples), parted = field_norms("x", "1", divided);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_DOUBLE_EQ(parted[k].error, whole[k].error);
}

TEST(Norms, ANanNeverVanishes) {
  for (std::size_t bad = 0; bad < samples.size(); ++bad) {
    auto spoiled = samples;
    spoiled[bad].computed = nan;
    for (const Measure& norm : field_norms("x", "1", spoiled)) EXPECT_TRUE(std::isnan(norm.error)) << norm.name << bad;
    spoiled = samples;
    spoiled[bad].exact = nan;
    for (const Measure& norm : field_norms("x", "1", spoiled)) {
      EXPECT_TRUE(std::isnan(norm.error)) << norm.name << bad;
      EXPECT_TRUE(std::isnan(norm.scale)) << norm.name << bad;
    }
    spoiled = samples;
    spoiled[bad].bound = nan;
    for (const Measure& norm : field_norms("x", "1", spoiled))
      EXPECT_TRUE(std::isnan(norm.reference_bound)) << norm.name << bad;
  }
}

TEST(Norms, OfNothingAreNotANumber) {
  const auto norms = field_norms("x", "1", {});
  EXPECT_TRUE(std::isnan(norms[0].error));
  EXPECT_TRUE(std::isnan(norms[1].error));
}

TEST(LargerAndSmaller, KeepANanWhicheverItIs) {
  EXPECT_EQ(larger(1, 2), 2);
  EXPECT_EQ(larger(2, 1), 2);
  EXPECT_EQ(smaller(1, 2), 1);
  EXPECT_EQ(smaller(2, 1), 1);
  for (const double number : {-1.0, 0.0, 1e300}) {
    for (const double result : {larger(number, nan), larger(nan, number), smaller(number, nan), smaller(nan, number)}) {
      EXPECT_TRUE(std::isnan(result)) << number;
    }
  }
}

TEST(ScalarMeasure, KeepsValueReferenceAndBound) {
  const Measure m = scalar_measure("period", 1.9, -2.0, 1e-12, "s");
  EXPECT_DOUBLE_EQ(m.error, 3.9);
  EXPECT_DOUBLE_EQ(m.scale, 2.0);
  EXPECT_EQ(m.value, 1.9);
  EXPECT_EQ(m.reference, -2.0);
  EXPECT_EQ(m.reference_bound, 1e-12);
  EXPECT_EQ(m.unit, "s");
  EXPECT_TRUE(std::isnan(scalar_measure("period", nan, 1, 0, "s").error));
}

// A field's norms are those of its errors, and a NaN among them is not lost.
TEST(ErrorNorms, AreThoseOfTheFieldWithTheseErrors) {
  const std::vector<FieldSample> field{{1, 0, 2, 1.5, 0.1}, {3, 1, -1, -3, 0.2}};
  const std::vector<ErrorSample> errors{{1, 0.5, 1.5, 0.1}, {3, 2, 3, 0.2}};
  const auto a = field_norms("u", "m/s", field), b = error_norms("u", "m/s", errors);
  ASSERT_EQ(b.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(a[k].name, b[k].name);
    EXPECT_EQ(a[k].error, b[k].error);
    EXPECT_EQ(a[k].scale, b[k].scale);
    EXPECT_EQ(a[k].reference_bound, b[k].reference_bound);
  }
  EXPECT_DOUBLE_EQ(b[0].error, (0.5 + 3 * 2) / 4);
  EXPECT_DOUBLE_EQ(b[1].error, std::sqrt((0.25 + 3 * 4) / 4));
  EXPECT_EQ(b[2].error, 2);
  for (const Measure& m : error_norms("u", "m/s", std::vector<ErrorSample>{{1, nan, 1, 0}, {1, 1, 1, 0}}))
    EXPECT_TRUE(std::isnan(m.error)) << m.name;
}

TEST(ProfileColumns, AreFoundByName) {
  Profile profile;
  profile.columns = {{"x", "m", "position", {1, 2}}, {"density", "kg/m^3", "density", {3, 4}}};
  ASSERT_NE(profile.find("density"), nullptr);
  EXPECT_EQ(profile.find("density")->values, (std::vector<double>{3, 4}));
  EXPECT_EQ(profile.find("densit"), nullptr);
}

}  // namespace
}  // namespace plumbline::measures_test
