// The frozen bar with one point a cell: limits in the literature, the step itself, York's bounds.
#include "reference/bar_stability.hpp"

#include "tests/reference/checks.hpp"

namespace plumbline::reference::bar_stability_test {
namespace {

constexpr StressUpdate usf = StressUpdate::first, usl = StressUpdate::last, musl = StressUpdate::modified_last;

// Largest eigenvalue of the step of a wave, from its matrix on (nodal velocity, nodal force), s = sin^2(theta/2).
double growth_of_wave(StressUpdate update, double weight, double courant, double s) {
  const double x = 4 * courant * courant * s, kept = 1 - 4 * weight * (1 - weight) * s;
  const double trace = 2 - (update == usl ? x : x * kept), determinant = update == usl ? 1 - x * (1 - kept) : 1;
  const double square = trace * trace / 4 - determinant;
  return square < 0 ? std::sqrt(determinant) : std::abs(trace) / 2 + std::sqrt(square);
}

TEST(BarStability, SidesAndCentresOfCells) {
  for (double side : {0.0, 1.0}) {
    expect_near(frozen_courant_limit(usf, side), 1, 1e-10);
    expect_near(frozen_courant_limit(usl, side), 1, 1e-10);
    expect_near(york_courant_limit(side), 1, 1e-10);  // [York 8.36]
  }
  expect_near(frozen_courant_limit(usf, 0.5), 2, 1e-10);
  expect_near(frozen_courant_limit(usl, 0.5), 0.7071067812, 5e-11);
  expect_near(york_courant_limit(0.5), 2, 1e-10);  // [York 8.41]
}

TEST(BarStability, ValuesBetween) {  // 4 sqrt(N (1 - N)), 1/(1 - 2 N), 1/sqrt(1 + 4 N (1 - N)) by hand
  expect_near(frozen_courant_limit(usf, 0.02), 1 / 0.96, 1e-10);  // [Stability 1]
  expect_near(frozen_courant_limit(usf, 0.2), 1.6, 1e-10);        // [Stability 1]
  expect_near(frozen_courant_limit(musl, 0.7), 1.8330302780, 5e-11);
  expect_near(frozen_courant_limit(usl, 0.2), 0.7808688094, 5e-11);  // [Stability 2]
  expect_near(frozen_courant_limit(StressUpdate::averaged, 0.9), 1.25, 1e-10);
  expect_near(corner_courant_limit(2), 0.7071067812, 5e-11);  // [Stability 3]
  expect_near(corner_courant_limit(3), 0.5773502692, 5e-11);
  EXPECT_EQ(corner_courant_limit(1).value, 1);
  // Sides and centres exact, 2 - 6 N (1 - N) = 0.875 and so sqrt(2/0.875) at N = 1/4. [York 8.24]
  expect_near(york_courant_limit(0.25), 1.5118578920, 5e-11);
}

TEST(BarStability, YorksBoundIsNeverAboveTheLimit) {
  for (int i = 1; i < 50; ++i) {
    const double weight = 0.01 * i;
    EXPECT_LT(york_courant_limit(weight).value, frozen_courant_limit(usf, weight).value) << weight;
    EXPECT_GT(york_courant_limit(weight).value, 0.85 * frozen_courant_limit(usf, weight).value) << weight;
  }
}

TEST(BarStability, TheLimitIsWhereTheFirstWaveGrows) {
  for (StressUpdate update : {usf, usl, musl}) {
    for (double weight : {0.0, 0.03, 0.1464466094, 0.2, 0.37, 0.5, 0.81, 1.0}) {
      const double limit = frozen_courant_limit(update, weight).value;
      double below = 0, above = 0;
      for (int i = 1; i <= 20000; ++i) {  // the steepest wave is missed by at most 5e-5 in s, 1e-8 of the stiffness
        below = std::max(below, growth_of_wave(update, weight, (1 - 1e-7) * limit, i / 20000.0));
        above = std::max(above, growth_of_wave(update, weight, (1 + 1e-7) * limit, i / 20000.0));
      }
      EXPECT_LE(below, 1 + 1e-12) << weight;
      EXPECT_GT(above, 1 + 1e-8) << weight;
    }
  }
}

TEST(BarStability, GrowthIsThatOfTheFastestWave) {
  for (StressUpdate update : {usf, usl}) {
    for (double weight : {0.0, 0.1, 0.3, 0.5}) {
      for (double courant : {0.3, 0.9, 1.05, 1.7, 2.5, 8.0}) {
        double fastest = 1;
        for (int i = 1; i <= 4000; ++i) {
          fastest = std::max(fastest, growth_of_wave(update, weight, courant, i / 4000.0));
        }
        const Bounded growth = frozen_growth(update, weight, courant);
        EXPECT_NEAR(growth.value, fastest, 1e-5 * fastest);  // missed by at most 1.25e-4 in s, of a flat maximum
        EXPECT_LE(growth.bound, 1e-6);                       // the root of a rounding where two eigenvalues meet
      }
    }
  }
  EXPECT_EQ(frozen_growth(usf, 0.5, 1.999).value, 1);
  EXPECT_EQ(frozen_growth(usf, 0.5, 1.999).bound, 0);
  expect_near(frozen_growth(usf, 0.0, 1.25), 4, 1e-10);  // trace 2 - 6.25: roots -4 and -1/4
}

TEST(BarStability, WrongArgumentsAreRefusedByKey) {
  EXPECT_EQ(refused_key([] { frozen_courant_limit(usf, -0.1); }), "weight");
  EXPECT_EQ(refused_key([] { york_courant_limit(1.1); }), "weight");
  EXPECT_EQ(refused_key([] { frozen_growth(usf, 0.5, 0); }), "courant");
  EXPECT_EQ(refused_key([] { corner_courant_limit(4); }), "dimensions");
}

}  // namespace
}  // namespace plumbline::reference::bar_stability_test
