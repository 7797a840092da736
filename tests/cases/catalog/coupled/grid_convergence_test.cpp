// Extrapolation to ever finer grids, and its uncertainty.
#include "cases/catalog/coupled/grid_convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace plumbline::grid_convergence_test {
namespace {

// [GCI 1] Values that follow the law have no scatter: 1.25 times what is left.
TEST(GridConvergence, ValuesThatFollowTheLaw) {
  const auto law = [](double h) { return 3 - 2 * h * h; };
  const GridConvergence known = grid_convergence({{0.1, law(0.1)}, {0.4, law(0.4)}, {0.2, law(0.2)}}, 2);
  EXPECT_NEAR(known.limit, 3, 1e-14);
  EXPECT_NEAR(known.slope, -2, 1e-13);
  EXPECT_DOUBLE_EQ(known.finest, law(0.1));
  EXPECT_NEAR(known.uncertainty, 1.25 * 0.02, 1e-14);
}

// [GCI 1] h = 1, 2, 3 with 0, 0, 3: the line -2 + 1.5 h is off by 0.5, -1, 0.5, so sigma is sqrt(1.5) and the finest
// value off by 0.5; 1.25 times 1.5 is left at h = 1.
TEST(GridConvergence, ScatterCounts) {
  const GridConvergence known = grid_convergence({{1, 0}, {2, 0}, {3, 3}}, 1);
  EXPECT_NEAR(known.limit, -2, 1e-14);
  EXPECT_NEAR(known.slope, 1.5, 1e-14);
  EXPECT_NEAR(known.uncertainty, 1.25 * 1.5 + std::sqrt(1.5) + 0.5, 1e-14);
}

TEST(GridConvergence, NeedsThreeMeshes) {
  EXPECT_THROW(grid_convergence({{1, 0}, {2, 0}}, 1), std::invalid_argument);
  EXPECT_THROW(grid_convergence({{1, 0}, {2, 0}, {2, 1}}, 1), std::invalid_argument);
  EXPECT_THROW(grid_convergence({{0, 0}, {1, 0}, {2, 1}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::grid_convergence_test
