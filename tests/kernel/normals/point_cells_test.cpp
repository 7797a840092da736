#include "kernel/normals/point_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kernel/normals/curves.hpp"

namespace plumbline::point_cells_test {
namespace {

TEST(PointCells, RowsHoldThePointsOfTheirCellsInOrder) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<double> x(200), y(200);
  for (std::size_t p = 0; p < 200; ++p) x[p] = uniform(random), y[p] = uniform(random);
  PointCells cells;
  cells.sort(test::square(5, 0.2), x, y);
  std::vector<int> seen(200);
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 5; ++i) {
      const auto [first, last] = cells.row(i, i, j);
      int before = -1;
      for (int k = first; k < last; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const int p = cells.number()[at];
        ++seen[static_cast<std::size_t>(p)];
        EXPECT_GT(p, before);
        before = p;
        EXPECT_EQ(cells.x()[at], x[static_cast<std::size_t>(p)]);
        EXPECT_EQ(static_cast<int>(x[static_cast<std::size_t>(p)] / 0.2), i);
        EXPECT_EQ(static_cast<int>(y[static_cast<std::size_t>(p)] / 0.2), j);
      }
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 200);
}

TEST(PointCells, SymmetryWallsShowImagesAndCornersImagesOfThem) {
  GridSpec grid = test::square(10, 0.1, true);
  grid.walls[0][1] = Wall::no_slip;  // no mirror
  const std::vector<double> x{0.05, 0.55}, y{0.15, 0.05};
  PointCells cells;
  cells.sort(grid, x, y);
  ASSERT_EQ(cells.x().size(), 6u);  // two points; the first in x, in y and in both; the second in y
  const auto holds = [&](double px, double py) {
    for (std::size_t k = 0; k < cells.x().size(); ++k) {
      if (std::abs(cells.x()[k] - px) + std::abs(cells.y()[k] - py) < 1e-14) return cells.number()[k] < 0;
    }
    return false;
  };
  EXPECT_TRUE(holds(-0.05, 0.15));
  EXPECT_TRUE(holds(0.05, -0.15));
  EXPECT_TRUE(holds(-0.05, -0.15));
  EXPECT_TRUE(holds(0.55, -0.05));
}

TEST(PointCells, WallsStandWhereTheGridEnds) {
  GridSpec grid = test::square(4, 0.25);
  grid.origin = {3, -2, 0};
  grid.walls[0][0] = grid.walls[1][1] = Wall::symmetry;  // x = 3, y = -1
  const std::vector<double> x{3.1}, y{-1.2};
  PointCells cells;
  cells.sort(grid, x, y);
  ASSERT_EQ(cells.x().size(), 4u);
  double sum_x = 0, sum_y = 0;
  for (std::size_t k = 0; k < 4; ++k) sum_x += cells.x()[k], sum_y += cells.y()[k];
  EXPECT_NEAR(sum_x, 4 * 3, 1e-14);
  EXPECT_NEAR(sum_y, 4 * -1, 1e-14);
  const auto [first, last] = cells.row(-1, -1, 4);  // behind both
  ASSERT_EQ(last - first, 1);
  EXPECT_NEAR(cells.x()[static_cast<std::size_t>(first)], 2.9, 1e-14);
  EXPECT_NEAR(cells.y()[static_cast<std::size_t>(first)], -0.8, 1e-14);
}

TEST(PointCells, APointOnTheLastLineBelongsToTheLastCell) {
  const std::vector<double> x{1}, y{1};
  PointCells cells;
  cells.sort(test::square(4, 0.25), x, y);
  const auto [first, last] = cells.row(3, 3, 3);
  EXPECT_EQ(last - first, 1);
  EXPECT_EQ(cells.cell(1, 0), 3);
}

}  // namespace
}  // namespace plumbline::point_cells_test
