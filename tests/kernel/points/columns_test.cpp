#include "kernel/points/columns.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace plumbline {
namespace {

TEST(Columns, AddsColumnsOfZerosOnDemand) {
  Columns points(3);
  EXPECT_FALSE(points.has(column::velocity));
  EXPECT_EQ(points.doubles_per_point(), 0);
  points.add(column::velocity, 2);
  EXPECT_TRUE(points.has(column::velocity));
  EXPECT_FALSE(points.has(column::energy));
  EXPECT_EQ(points.components(column::velocity), 2);
  EXPECT_EQ(points.doubles_per_point(), 2);
  for (double v : points.values(column::velocity)) EXPECT_EQ(v, 0);
}

TEST(Columns, ComponentsAreContiguous) {
  Columns points(4);
  points.add(column::position, 2);
  for (int p = 0; p < 4; ++p) points(column::position, 1)[p] = p + 10;
  EXPECT_EQ(points(column::position, 1), points(column::position, 0) + 4);
  EXPECT_EQ(points.values(column::position).size(), 8u);
  EXPECT_EQ(points.values(column::position)[5], 11);
}

TEST(Columns, AddingAgainKeepsValues) {
  Columns points(2);
  points.add(column::mass);
  points(column::mass)[1] = 5;
  points.add(column::mass);
  EXPECT_EQ(points(column::mass)[1], 5);
  EXPECT_EQ(points.doubles_per_point(), 1);
}

TEST(Columns, ReordersEveryComponentOfEveryColumn) {
  Columns points(3);
  points.add(column::mass);
  points.add(column::position, 2);
  for (int p = 0; p < 3; ++p) {
    points(column::mass)[p] = p;
    points(column::position, 1)[p] = 10 * p;
  }
  points.reorder(std::vector<int>{2, 0, 1});
  EXPECT_EQ(std::vector<double>(points(column::mass), points(column::mass) + 3), (std::vector<double>{2, 0, 1}));
  EXPECT_EQ(points(column::position, 1)[0], 20);
  EXPECT_EQ(points(column::position, 1)[2], 10);
}

// A material in a plug-in names columns of its own; the same name is the same column.
TEST(Columns, IdentitiesGoByName) {
  const ColumnId damage("damage", "1"), again("damage", "1");
  EXPECT_EQ(damage.index(), again.index());
  EXPECT_NE(damage.index(), column::energy.index());
  EXPECT_EQ(damage.name(), "damage");
  EXPECT_EQ(column::stress.unit(), "Pa");
  Columns points(1);
  points.add(damage, 3);
  EXPECT_EQ(points.components(again), 3);
}

}  // namespace
}  // namespace plumbline
