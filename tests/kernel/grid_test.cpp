#include "kernel/grid.hpp"

#include "tests/kernel/scenes.hpp"

namespace plumbline::grid_test {
namespace {

TEST(Grid, CountsNodesWithOneGhostLayer) {
  const Grid<1> line(scenes::line(5, 0.1));
  EXPECT_EQ(line.node_count(), 8);
  EXPECT_EQ(line.rows(), 1);
  const Grid<2> plane(scenes::plane(5, 3, 0.1));
  EXPECT_EQ(plane.row_length(), 8);
  EXPECT_EQ(plane.rows(), 6);
  EXPECT_EQ(plane.node_count(), 48);
  const Grid<3> solid(scenes::box(scenes::Space::solid, {5, 3, 2}, 0.1));
  EXPECT_EQ(solid.row_length(), 8);
  EXPECT_EQ(solid.rows(), 30);
  EXPECT_EQ(solid.node_count(), 240);
}

// Node (3, 1, 2) of 8 x 6 x 5.
TEST(Grid, NumbersNodesRowByRow) {
  const Grid<3> grid(scenes::box(scenes::Space::solid, {5, 3, 2}, 0.1));
  const int node = 3 + 8 * (1 + 6 * 2);
  EXPECT_EQ(grid.stride(0), 1);
  EXPECT_EQ(grid.stride(1), 8);
  EXPECT_EQ(grid.stride(2), 48);
  EXPECT_EQ(grid.index(node, 0), 3);
  EXPECT_EQ(grid.index(node, 1), 1);
  EXPECT_EQ(grid.index(node, 2), 2);
  EXPECT_EQ(grid.row_index(node / 8, 1), 1);
  EXPECT_EQ(grid.row_index(node / 8, 2), 2);
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
  GridSpec deep = scenes::box(scenes::Space::solid, {5, 3, 2}, 0.5);
  deep.origin = {-1, 2, 8};
  EXPECT_EQ(Grid<3>(deep).position(2 + 8 * (1 + 6 * 3)), Eigen::Vector3d(-0.5, 2, 9));
}

TEST(Grid, KnowsItsWalls) {
  const Grid<2> grid(scenes::plane(5, 3, 0.5, scenes::walls(Wall::symmetry, Wall::free, Wall::no_slip, Wall::free)));
  EXPECT_EQ(grid.wall(0, 0), Wall::symmetry);
  EXPECT_EQ(grid.wall(0, 1), Wall::free);
  EXPECT_EQ(grid.wall(1, 0), Wall::no_slip);
  const Wall f = Wall::free;
  const Grid<3> solid(scenes::box(scenes::Space::solid, {5, 3, 2}, 0.5, scenes::walls(f, f, f, f, f, Wall::no_slip)));
  EXPECT_EQ(solid.wall(2, 0), Wall::free);
  EXPECT_EQ(solid.wall(2, 1), Wall::no_slip);
}

}  // namespace
}  // namespace plumbline::grid_test
