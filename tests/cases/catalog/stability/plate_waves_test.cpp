#include "cases/catalog/stability/plate_waves.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace plumbline::plate_waves_test {
namespace {

const reference::MapScheme musl{};

TEST(PlateWaves, WavesAlongOneAxisBearWhatABarDoes) {
  // At the centres of cells and with tiled linear points the worst waves run along an axis. [Stability 1] [Plate 1]
  for (const double nu : {-0.3, 0.0, 0.3}) {
    EXPECT_NEAR(plate_limit(musl, {1, 0.5, 0.5}, nu), 2, 1e-9);
    EXPECT_NEAR(plate_limit(musl, {2, 0.5, 0.5}, nu), std::sqrt(3.0), 1e-9);
  }
}

TEST(PlateWaves, CornersBearTheStiffnessOfFiniteDifferences) {
  // Alternating along both axes: 4 (1 + k +- (1 - k)), of which the larger is 8 whatever k. [Plate 1]
  for (const double nu : {0.0, 0.2, 0.45}) EXPECT_NEAR(plate_limit(musl, {1, 1e-9, 1e-9}, nu), std::sqrt(0.5), 1e-8);
  EXPECT_NEAR(scalar_plate_limit(musl, {1, 1e-9, 1e-9}), std::sqrt(0.5), 1e-8);
}

TEST(PlateWaves, AuxeticCornersBearLess) {
  // On s_x + s_y = 1, out of phase: 2 (1 + k + |1 - 3 k|) at s_x = s_y, no more than the largest of all. [Plate 1]
  const double nu = -0.99, k = (1 - 2 * nu) / (2 - 2 * nu);
  const double limit = plate_limit(musl, {1, 1e-9, 1e-9}, nu);
  EXPECT_LT(limit, std::sqrt(0.5));
  EXPECT_LE(limit, 2 / std::sqrt(2 * (1 + k + std::abs(1 - 3 * k))));
}

TEST(PlateWaves, PeriodicPatchesMissTheWorstWave) {
  EXPECT_GT(scalar_plate_limit(musl, {2, 0.5, 0.5}, 8), 1.03 * scalar_plate_limit(musl, {2, 0.5, 0.5}));
}

}  // namespace
}  // namespace plumbline::plate_waves_test
