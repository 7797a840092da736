#include "kernel/points/columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernel/pack.hpp"

namespace plumbline::columns_test {
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

// Neighbours that stay neighbours are copied together: whatever their number, wherever they stand, and again and again.
TEST(Columns, ReordersRunsOfAnyLength) {
  for (int n : {7, 8, 9, 500, 60000}) {
    for (int threads : {1, 3}) {
      Columns points(n);
      points.add(column::mass);
      points.add(column::position, 2);
      points.add(column::energy);
      std::vector<double> expected(static_cast<std::size_t>(n));
      for (int p = 0; p < n; ++p) {
        expected[static_cast<std::size_t>(p)] = points(column::mass)[p] = points(column::energy)[p] = p;
        for (int k = 0; k < 2; ++k) points(column::position, k)[p] = p;
      }
      for (int turn = 0; turn < 3; ++turn) {
        std::vector<int> order;  // pieces of 1, 2, ... 40 points, the last first
        for (int end = n, length = 1 + turn; end > 0; length = length % 40 + 1) {
          const int first = std::max(0, end - length);
          for (int p = first; p < end; ++p) order.push_back(p);
          end = first;
        }
        points.reorder(order, {}, threads);
        std::vector<double> now;
        for (const int from : order) now.push_back(expected[static_cast<std::size_t>(from)]);
        expected = now;
        for (int p = 0; p < n; ++p) {
          const double here = expected[static_cast<std::size_t>(p)];
          ASSERT_EQ(points(column::mass)[p], here);
          ASSERT_EQ(points(column::energy)[p], here);
          for (int k = 0; k < 2; ++k) ASSERT_EQ(points(column::position, k)[p], here);
        }
      }
    }
  }
}

// Columns that hold nothing of use stay as they are; all others follow the points, by however many threads.
TEST(Columns, StaleColumnsAreLeftAlone) {
  const int n = 10000;  // more than a thread takes at a time
  for (int threads : {1, 2, 3}) {
    Columns points(n);
    points.add(column::mass);
    points.add(column::stress, 3);
    points.add(column::position, 2);
    std::vector<int> order(n);
    for (int p = 0; p < n; ++p) {
      order[static_cast<std::size_t>(p)] = (p * 7919 + 13) % n;  // 7919 is prime to n
      points(column::mass)[p] = p;
      for (int k = 0; k < 3; ++k) points(column::stress, k)[p] = 10 * p + k;
      for (int k = 0; k < 2; ++k) points(column::position, k)[p] = 100 * p + k;
    }
    const ColumnId stale[] = {column::stress, column::energy};
    points.reorder(order, stale, threads);
    for (int p = 0; p < n; ++p) {
      const int from = order[static_cast<std::size_t>(p)];
      ASSERT_EQ(points(column::mass)[p], from);
      for (int k = 0; k < 3; ++k) ASSERT_EQ(points(column::stress, k)[p], 10 * p + k);
      for (int k = 0; k < 2; ++k) ASSERT_EQ(points(column::position, k)[p], 100 * from + k);
    }
    EXPECT_FALSE(points.has(column::energy));
  }
}

// Behind the last point a pack may be read, before and after a new order: zeros.
TEST(Columns, APackMayBeReadAtTheLastPoint) {
  Columns points(3);
  points.add(column::mass);
  points.add(column::position, 2);
  for (double& m : points.values(column::mass)) m = 1;
  for (double& x : points.values(column::position)) x = 2;
  for (int again = 0; again < 2; ++again) {
    const Pack mass = load(points(column::mass) + 2), y = load(points(column::position, 1) + 2);
    EXPECT_EQ(mass[0], 1);
    EXPECT_EQ(y[0], 2);
    for (std::size_t lane = 1; lane < static_cast<std::size_t>(lanes); ++lane) {
      EXPECT_EQ(mass[lane], 0);
      EXPECT_EQ(y[lane], 0);
    }
    points.reorder(std::vector<int>{2, 1, 0});
  }
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
}  // namespace plumbline::columns_test
