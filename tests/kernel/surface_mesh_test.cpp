// Who is whose neighbour along the edges of a mesh, on sheets whose rings are known.
#include "kernel/surface_mesh.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <vector>

namespace plumbline::surface_mesh_test {
namespace {

// A parallelogram of side x side points, each with six triangles about it but at the edges: point (i, j) is j side + i.
std::vector<Triangle> triangles(int side) {
  std::vector<Triangle> all;
  for (int j = 0; j + 1 < side; ++j) {
    for (int i = 0; i + 1 < side; ++i) {
      const int p = j * side + i;
      all.push_back({p, p + 1, p + side});
      all.push_back({p + 1, p + side + 1, p + side});
    }
  }
  return all;
}

// Edges from (0, 0) to (i, j): along i, along j, and along (1, -1).
int edges_to(int i, int j) {
  return i * j >= 0 ? std::abs(i + j) : std::abs(i) > std::abs(j) ? std::abs(i) : std::abs(j);
}

TEST(SurfaceMesh, RingsOfASheetHaveSixEighteenThirtySixPoints) {
  constexpr int side = 9, middle = 4 * side + 4;
  const std::size_t within[] = {6, 18, 36};
  for (int rings = 1; rings <= 3; ++rings) {
    const auto all = neighbours_in_mesh(triangles(side), side * side, rings);
    EXPECT_EQ(all[middle].size(), within[rings - 1]);
  }
}

TEST(SurfaceMesh, NeighboursAreThoseThatManyEdgesAway) {
  constexpr int side = 6;
  for (int rings = 1; rings <= 3; ++rings) {
    const auto all = neighbours_in_mesh(triangles(side), side * side, rings);
    for (int p = 0; p < side * side; ++p) {
      std::vector<int> expected;
      for (int q = 0; q < side * side; ++q) {
        if (q != p && edges_to(q % side - p % side, q / side - p / side) <= rings) expected.push_back(q);
      }
      EXPECT_EQ(all[static_cast<std::size_t>(p)], expected) << p << ", " << rings << " rings";
    }
  }
}

TEST(SurfaceMesh, PointsOfNoTriangleHaveNoNeighbours) {
  const auto all = neighbours_in_mesh({{2, 0, 3}}, 5, 2);
  EXPECT_TRUE(all[1].empty() && all[4].empty());
  EXPECT_EQ(all[0], (std::vector<int>{2, 3}));
}

TEST(SurfaceMesh, ClearErrors) {
  EXPECT_THROW(neighbours_in_mesh({{0, 1, 3}}, 3, 1), std::invalid_argument);
  EXPECT_THROW(neighbours_in_mesh({{0, -1, 2}}, 3, 1), std::invalid_argument);
  EXPECT_THROW(neighbours_in_mesh({{0, 1, 0}}, 3, 1), std::invalid_argument);
  EXPECT_THROW(neighbours_in_mesh({{0, 1, 2}}, 3, 0), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::surface_mesh_test
