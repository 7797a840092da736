#include "kernel/points/components.hpp"

#include <gtest/gtest.h>

namespace plumbline::components_test {
namespace {

TEST(Components, ReadAndWriteOnePoint) {
  Columns points(3);
  points.add(column::velocity, 2);
  points.add(column::affine, 4);
  Components<Eigen::Vector2d, double> velocity(points, column::velocity);
  velocity.set(1, {5, 7});
  EXPECT_EQ(points(column::velocity, 0)[1], 5);
  EXPECT_EQ(points(column::velocity, 1)[1], 7);
  EXPECT_EQ(velocity[1], Eigen::Vector2d(5, 7));
  EXPECT_EQ(velocity[2], Eigen::Vector2d(0, 0));
}

// Matrices stand row by row, whatever Eigen does inside.
TEST(Components, MatricesAreRowMajor) {
  Columns points(2);
  points.add(column::affine, 4);
  Components<Eigen::Matrix2d, double> affine(points, column::affine);
  Eigen::Matrix2d c;
  c << 1, 2, 3, 4;
  affine.set(1, c);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(points(column::affine, k)[1], k + 1);
  const Columns& reading = points;
  EXPECT_EQ((Components<Eigen::Matrix2d, const double>(reading, column::affine)[1]), c);
}

}  // namespace
}  // namespace plumbline::components_test
