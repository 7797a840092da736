#include "kernel/pack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace plumbline::pack_test {
namespace {

Pack counting(double from) {
  return Pack([&](auto lane) { return from + static_cast<double>(lane); });
}
const double nan = std::nan("");

TEST(Pack, FirstLanesAreTheFirst) {
  for (int count = 0; count <= lanes; ++count) {
    const PackMask mask = first_lanes(count);
    for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(bool(mask[static_cast<std::size_t>(lane)]), lane < count);
  }
}

TEST(Pack, LoadsFromAnywhere) {
  std::vector<double> values(static_cast<std::size_t>(3 * lanes));
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = static_cast<double>(k);
  for (int from = 0; from <= 2 * lanes; ++from) {
    const Pack pack = load(values.data() + from);
    for (int lane = 0; lane < lanes; ++lane) EXPECT_EQ(pack[static_cast<std::size_t>(lane)], from + lane);
  }
}

TEST(Pack, StoresItsLanesAndNoOther) {
  for (int count = 0; count <= lanes; ++count) {
    std::vector<double> values(static_cast<std::size_t>(2 * lanes + 2), -1.0);
    store(values.data() + 1, counting(10), count);
    for (int k = 0; k < 2 * lanes + 2; ++k) {
      const bool mine = k >= 1 && k < 1 + count;
      EXPECT_EQ(values[static_cast<std::size_t>(k)], mine ? 9 + k : -1) << count << ' ' << k;
    }
  }
}

// What stands in lanes that are no points, not even a number perhaps, reaches no sum.
TEST(Pack, KeptLanesForgetTheOthers) {
  for (int count = 0; count <= lanes; ++count) {
    const Pack pack([&](std::size_t lane) {
      const int k = static_cast<int>(lane);
      return k < count ? 1.0 + k : k % 2 == 0 ? nan : HUGE_VAL;
    });
    EXPECT_EQ(sum(kept(pack, count)), count * (count + 1) / 2.0);
  }
}

TEST(Pack, ChoosesLaneByLane) {
  const Pack a = counting(0), b = counting(100);
  const Pack chosen = choose(first_lanes(1), a, b);
  EXPECT_EQ(chosen[0], 0);
  for (int lane = 1; lane < lanes; ++lane) EXPECT_EQ(chosen[static_cast<std::size_t>(lane)], 100 + lane);
  EXPECT_EQ(a[0], 0);
  EXPECT_EQ(b[0], 100);
}

// Every point once, in order, and only the last pack is partial.
TEST(Pack, LoopsMeetEveryPointOnce) {
  for (int first : {0, 3}) {
    for (int points = 0; points <= 3 * lanes; ++points) {
      std::vector<int> met;
      int partial = 0;
      for_packs(first, first + points, [&](int p, int count) {
        EXPECT_EQ(partial, 0);
        EXPECT_GE(count, 1);
        EXPECT_LE(count, lanes);
        partial += count < lanes;
        for (int k = 0; k < count; ++k) met.push_back(p + k);
      });
      ASSERT_EQ(met.size(), static_cast<std::size_t>(points));
      for (int k = 0; k < points; ++k) EXPECT_EQ(met[static_cast<std::size_t>(k)], first + k);
    }
  }
}

// Whatever number of them there is, and nothing behind the last.
template <int count>
void expect_lane_sums() {
  Pack packs[count + 1];
  for (int k = 0; k < count; ++k) packs[k] = counting(10 * k);
  packs[count] = nan;
  double values[count + 1];
  for (double& value : values) value = 7;
  add_lane_sums<count>(packs, values);
  for (int k = 0; k < count; ++k) EXPECT_EQ(values[k], 7 + 10 * k * lanes + lanes * (lanes - 1) / 2.0);
  EXPECT_EQ(values[count], 7);
}
TEST(Pack, SumsOfSeveral) {
  expect_lane_sums<1>();
  expect_lane_sums<2>();
  expect_lane_sums<3>();
  expect_lane_sums<4>();
  expect_lane_sums<6>();
  expect_lane_sums<12>();
}

}  // namespace
}  // namespace plumbline::pack_test
