#include "kernel/grid.hpp"

#include "tests/kernel/scenes.hpp"

namespace plumbline {
namespace {

TEST(Grid, CountsNodesWithOneGhostLayer) {
  const Grid<1> line(scenes::line(5, 0.1));
  EXPECT_EQ(line.node_count(), 8);
  EXPECT_EQ(line.rows(), 1);
  const Grid<2> plane(scenes::plane(5, 3, 0.1));
  EXPECT_EQ(plane.row_length(), 8);
  EXPECT_EQ(plane.rows(), 6);
  EXPECT_EQ(plane.node_count(), 48);
}

TEST(Grid, PlacesNodesAndPoints) {
  GridSpec spec = scenes::plane(5, 3, 0.5);
  spec.origin = {-1, 2};
  const Grid<2> grid(spec);
  EXPECT_EQ(grid.position(0), Eigen::Vector2d(-1.5, 1.5));
  EXPECT_EQ(grid.position(1 + grid.row_length()), Eigen::Vector2d(-1, 2));
  EXPECT_EQ(grid.line(6, 0), 1.5);
  EXPECT_EQ(grid.logical(-0.25, 0), 1.5);
  EXPECT_EQ(grid.logical(2.25, 1), 0.5);
}

TEST(Grid, KnowsItsWalls) {
  const Grid<2> grid(scenes::plane(5, 3, 0.5, scenes::walls(Wall::symmetry, Wall::free, Wall::no_slip, Wall::free)));
  EXPECT_EQ(grid.wall(0, 0), Wall::symmetry);
  EXPECT_EQ(grid.wall(0, 1), Wall::free);
  EXPECT_EQ(grid.wall(1, 0), Wall::no_slip);
}

}  // namespace
}  // namespace plumbline
