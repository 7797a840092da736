// Limits of periodic layouts: the closed form, the whole step's matrix, the known tables.
#include "reference/mpm_amplification.hpp"

#include <random>

#include "reference/circle.hpp"
#include "tests/reference/checks.hpp"

namespace plumbline::reference::mpm_amplification_test {
namespace {

using Shape = GridShape;
using Transfer = GridTransfer;
using Update = StressUpdate;

constexpr Update updates[] = {Update::first, Update::last, Update::modified_last, Update::averaged};
constexpr Shape shapes[] = {Shape::linear, Shape::boxes, Shape::quadratic, Shape::cubic};
constexpr Transfer transfers[] = {Transfer::pic, Transfer::flip, Transfer::apic, Transfer::xpic, Transfer::fmpm};

const std::vector<double> uneven{0.13, 0.41, 0.77};

double growth_of(const ComplexMatrix& step) { return spectral_radius(step).value; }

TEST(MpmAmplification, OnePointACellIsTheClosedForm) {  // [Stability 1, 2, 5]
  for (Update update : updates) {
    for (int i = 1; i < 50; ++i) {
      const MapScheme scheme{update, Shape::linear, Transfer::flip};
      const Bounded limit = periodic_courant_limit(scheme, {0.02 * i}), closed = frozen_courant_limit(update, 0.02 * i);
      expect_same(limit, closed);
      EXPECT_LE(limit.bound, 1e-11);
    }
  }
}

// Nothing of the theorem is used here: the matrix of all points and the wave numbers, each in its turn. It is not
// normal: eigenvalues carry 1e-8, the root of a rounding, where two meet.
TEST(MpmAmplification, WholeStepsGrowBeyondTheLimitAndNotBelow) {  // [Stability 4, 5]
  for (Update update : updates) {
    for (Shape shape : shapes) {
      for (Transfer transfer : transfers) {
        const MapScheme scheme{update, shape, transfer, 3, shape == Shape::quadratic ? 0.7 : 0.0};
        const double limit = periodic_courant_limit(scheme, uneven).value;
        double below = 0, above = 0;
        for (int i = 1; i <= 60; ++i) {
          const double theta = pi.value * i / 60;
          below = std::max(below, growth_of(amplification_matrix(scheme, uneven, theta, (1 - 1e-4) * limit)));
          below = std::max(below, growth_of(amplification_matrix(scheme, uneven, theta, 0.4 * limit)));
          above = std::max(above, growth_of(amplification_matrix(scheme, uneven, theta, 1.002 * limit)));
        }
        const auto name = [&] {
          return static_cast<int>(update) * 100 + static_cast<int>(shape) * 10 + static_cast<int>(transfer);
        };
        EXPECT_LE(below, 1 + 1e-7) << name();
        EXPECT_GT(above, 1 + 1e-5) << name();  // 60 wave numbers miss the worst by 1e-3 of the stiffness at most
      }
    }
  }
}

TEST(MpmAmplification, TheEigenvaluesThatNodesSeeAreTheStepsOwn) {  // [Stability 4]
  std::mt19937 random(1997);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (Update update : updates) {
    for (Shape shape : shapes) {
      for (Transfer transfer : transfers) {
        const MapScheme scheme{update, shape, transfer, 4, uniform(random)};
        const std::vector<double> points{uniform(random), uniform(random)};
        const double theta = 3 * uniform(random) + 0.1, courant = 0.2 + 3 * uniform(random);
        const Bounded seen = wave_growth(scheme, points, theta, courant);
        EXPECT_NEAR(std::max(1.0, seen.value), growth_of(amplification_matrix(scheme, points, theta, courant)), 1e-7);
        EXPECT_LE(seen.bound, 1e-7 * seen.value);
      }
    }
  }
}

struct Row {
  int per_cell;
  Shape shape;
  double limits[8];  // of the columns below
};
const MapScheme columns[] = {
    {Update::modified_last, Shape::linear, Transfer::flip}, {Update::last, Shape::linear, Transfer::flip},
    {Update::modified_last, Shape::linear, Transfer::pic},  {Update::last, Shape::linear, Transfer::apic},
    {Update::modified_last, Shape::linear, Transfer::apic}, {Update::first, Shape::linear, Transfer::xpic, 2},
    {Update::first, Shape::linear, Transfer::fmpm, 2},      {Update::first, Shape::linear, Transfer::fmpm, 4}};

// Tables made with 24 wave numbers: those miss the worst wave by up to 0.8 %, always upwards; rounded to three digits.
void expect_table(const std::vector<Row>& rows, const std::function<double(MapScheme, int)>& limit_of) {
  for (const Row& row : rows) {
    for (int c = 0; c < 8; ++c) {
      if (row.limits[c] == 0) continue;
      MapScheme scheme = columns[c];
      scheme.shape = row.shape;
      const double limit = limit_of(scheme, row.per_cell);
      EXPECT_NEAR(limit, row.limits[c], 0.01 * row.limits[c])
          << row.per_cell << " " << static_cast<int>(row.shape) << " " << c;
      EXPECT_LE(limit, row.limits[c] + 0.0051) << row.per_cell << " " << static_cast<int>(row.shape) << " " << c;
    }
  }
}

TEST(MpmAmplification, TheKnownTableOfRegularLayouts) {
  const std::vector<Row> rows{{1, Shape::linear, {2.00, .707, 1.71, 1.00, 1.00, 1.85, 1.45, 1.28}},
                              {1, Shape::cubic, {2.71, 1.37, 2.39, 1.71, 1.96, 2.57, 2.11, 1.95}},
                              {2, Shape::linear, {1.735, .756, 1.48, 1.00, 1.00, 1.60, 1.26, 1.11}},
                              {2, Shape::boxes, {1.735, .756, 1.48, 1.00, 1.00, 1.60, 1.26, 1.11}},
                              {2, Shape::quadratic, {2.40, 1.35, 2.14, 1.65, 1.81, 2.31, 1.91, 1.79}},
                              {2, Shape::cubic, {2.73, 1.49, 2.41, 1.79, 2.04, 2.59, 2.15, 1.99}},
                              {3, Shape::linear, {1.68, .766, 1.43, 1.00, 1.00, 1.55, 1.22, 1.08}},
                              {3, Shape::quadratic, {2.31, 1.15, 2.02, 1.41, 1.65, 2.18, 1.78, 1.64}},
                              {4, Shape::linear, {1.66, .770, 1.42, 1.00, 1.00, 1.53, 1.20, 1.07}},
                              {4, Shape::quadratic, {2.36, 1.27, 2.09, 1.56, 1.75, 2.26, 1.86, 1.73}}};
  expect_table(rows, [](const MapScheme& scheme, int per_cell) {
    return periodic_courant_limit(scheme, regular_points(per_cell)).value;
  });
}

TEST(MpmAmplification, TheKnownTableOfWorstOffsets) {
  const std::vector<Row> rows{{1, Shape::linear, {1.00, 0, 1.00, 0, 0, 1.00, 1.00, 1.00}},
                              {2, Shape::linear, {1.414, 0, 1.22, 0, 0, 1.32, 1.08, 1.02}},
                              {2, Shape::boxes, {1.735, 0, 1.48, 0, 0, 1.60, 1.26, 1.11}},
                              {2, Shape::quadratic, {2.24, 1.03, 1.96, 1.27, 1.55, 2.11, 1.70, 1.56}},
                              {3, Shape::linear, {1.54, 0, 1.31, 0, 0, 1.42, 1.13, 1.04}},
                              {4, Shape::linear, {1.58, 0, 1.35, 0, 0, 1.46, 1.15, 1.04}},
                              {4, Shape::quadratic, {2.33, 1.19, 2.05, 1.47, 1.69, 2.21, 1.81, 1.67}}};
  expect_table(rows,
               [](const MapScheme& scheme, int per_cell) { return worst_rigid_offset(scheme, per_cell).limit.value; });
}

TEST(MpmAmplification, LinearShapesAreWorstWithAPointOnANode) {
  for (int per_cell : {1, 2, 3}) {
    const WorstOffset worst = worst_rigid_offset({Update::first, Shape::linear, Transfer::flip}, per_cell);
    EXPECT_NEAR(worst.offset, 0.5 / per_cell, 1e-6);
    expect_same(worst.limit, periodic_courant_limit({}, regular_points(per_cell, 0.5 / per_cell)));
  }
  // Two points, one on a node: B = 1 - s/2, so s (1 - s/2) <= 1/2 and the limit is sqrt 2.
  EXPECT_NEAR(worst_rigid_offset({}, 2).limit.value, std::sqrt(2.0), 1e-9);
}

TEST(MpmAmplification, FiltersOfOneTermArePic) {
  for (Update update : updates) {
    const Bounded pic = periodic_courant_limit({update, Shape::quadratic, Transfer::pic}, uneven);
    expect_same(periodic_courant_limit({update, Shape::quadratic, Transfer::xpic, 1}, uneven), pic);
    expect_same(periodic_courant_limit({update, Shape::quadratic, Transfer::fmpm, 1}, uneven), pic);
  }
}

TEST(MpmAmplification, WrongArgumentsAreRefusedByKey) {
  EXPECT_EQ(refused_key([] { periodic_courant_limit({}, {}); }), "points");
  EXPECT_EQ(refused_key([] { periodic_courant_limit({}, {std::nan("")}); }), "points");
  EXPECT_EQ(refused_key([] { periodic_courant_limit({.order = 0}, {0.5}); }), "order");
  EXPECT_EQ(refused_key([] { periodic_courant_limit({.sharpening = 2}, {0.5}); }), "sharpening");
  EXPECT_EQ(refused_key([] { amplification_matrix({}, {0.5}, 1, 0); }), "courant");
  EXPECT_EQ(refused_key([] { wave_growth({}, {0.5}, 1, -1); }), "courant");
  EXPECT_EQ(refused_key([] { worst_rigid_offset({}, 0); }), "per_cell");
}

}  // namespace
}  // namespace plumbline::reference::mpm_amplification_test
