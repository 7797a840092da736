#include "cases/harness/description/drag.hpp"

#include <gtest/gtest.h>

#include <span>
#include <vector>

namespace plumbline::drag_test {
namespace {

TEST(Drag, ActsBesideTheLoadAgainstTheVelocity) {
  Columns points(2);
  points.add(column::velocity, 3);
  points.add(column::body_force, 3);
  for (int d = 0; d < 3; ++d) points(column::velocity, d)[1] = d + 1;
  double asked = 0;
  const Load load = with_drag(
      [&](double time, Columns& of, std::span<const int>) {
        asked = time;
        for (int p = 0; p < 2; ++p) of(column::body_force, 2)[p] = 20;
      },
      2.5);
  load(7, points, std::vector<int>{0, 1});
  EXPECT_EQ(asked, 7);
  EXPECT_EQ(points(column::body_force, 0)[1], -2.5);
  EXPECT_EQ(points(column::body_force, 1)[1], -5);
  EXPECT_EQ(points(column::body_force, 2)[1], 12.5);
  EXPECT_EQ(points(column::body_force, 2)[0], 20);
}

}  // namespace
}  // namespace plumbline::drag_test
