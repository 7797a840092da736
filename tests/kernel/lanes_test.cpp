#include "kernel/lanes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace plumbline::lanes_test {
namespace {

const double nan = std::nan(""), infinity = HUGE_VAL;
const double numbers[] = {0.0, -0.0, 1.5, -1.5, 2.0, -3.0, 1e300, -1e-300, infinity, -infinity, nan, 0.1};
constexpr int count = sizeof numbers / sizeof numbers[0];

// Each lane another number of the list, and lane by lane all of them.
Pack pack_from(int first) {
  return Pack([&](std::size_t lane) { return numbers[(first + 5 * static_cast<int>(lane)) % count]; });
}
void expect_same(double a, double b) {
  if (std::isnan(b)) {
    EXPECT_TRUE(std::isnan(a));
  } else {
    EXPECT_EQ(a, b);
    EXPECT_EQ(std::signbit(a), std::signbit(b));
  }
}
void for_pairs(const std::function<void(const Pack&, const Pack&)>& visit) {
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) visit(pack_from(i), pack_from(j));
  }
}

TEST(Lanes, HoldOneNumberOrSeveral) {
  for (const double x : numbers) {
    const Pack all = x;
    for (std::size_t lane = 0; lane < lanes; ++lane) expect_same(all[lane], x);
  }
  const Pack counted([](std::size_t lane) { return 3.0 * static_cast<double>(lane); });
  for (std::size_t lane = 0; lane < lanes; ++lane) EXPECT_EQ(counted[lane], 3.0 * static_cast<double>(lane));
}

TEST(Lanes, CountLikeNumbers) {
  for_pairs([](const Pack& a, const Pack& b) {
    Pack sum = a, difference = a, product = a, quotient = a;
    sum += b;
    difference -= b;
    product *= b;
    quotient /= b;
    for (std::size_t k = 0; k < lanes; ++k) {
      expect_same((a + b)[k], a[k] + b[k]);
      expect_same((a - b)[k], a[k] - b[k]);
      expect_same((a * b)[k], a[k] * b[k]);
      expect_same((a / b)[k], a[k] / b[k]);
      expect_same(sum[k], a[k] + b[k]);
      expect_same(difference[k], a[k] - b[k]);
      expect_same(product[k], a[k] * b[k]);
      expect_same(quotient[k], a[k] / b[k]);
      expect_same((-a)[k], -a[k]);
      expect_same((2.0 * a - 1)[k], 2.0 * a[k] - 1);
    }
  });
}

TEST(Lanes, CompareLikeNumbers) {
  for_pairs([](const Pack& a, const Pack& b) {
    for (std::size_t k = 0; k < lanes; ++k) {
      EXPECT_EQ((a < b)[k], a[k] < b[k]);
      EXPECT_EQ((a > b)[k], a[k] > b[k]);
      EXPECT_EQ((a <= b)[k], a[k] <= b[k]);
      EXPECT_EQ((a >= b)[k], a[k] >= b[k]);
      EXPECT_EQ((a == b)[k], a[k] == b[k]);
      EXPECT_EQ((a != b)[k], a[k] != b[k]);
      EXPECT_EQ(isnan(a)[k], std::isnan(a[k]));
      EXPECT_EQ((a < 1.0 && b < 1.0)[k], a[k] < 1 && b[k] < 1);
      EXPECT_EQ((a < 1.0 || b < 1.0)[k], a[k] < 1 || b[k] < 1);
      EXPECT_EQ((!(a < b))[k], !(a[k] < b[k]));
      expect_same(choose(a < b, a, b)[k], a[k] < b[k] ? a[k] : b[k]);
    }
  });
}

// Where one is no number it is the second; callers rely on a NaN in front being lost, and on one behind staying.
TEST(Lanes, SmallerAndLarger) {
  for_pairs([](const Pack& a, const Pack& b) {
    for (std::size_t k = 0; k < lanes; ++k) {
      expect_same(min(a, b)[k], a[k] < b[k] ? a[k] : b[k]);
      expect_same(max(a, b)[k], a[k] > b[k] ? a[k] : b[k]);
    }
  });
}

TEST(Lanes, Functions) {
  for (int i = 0; i < count; ++i) {
    const Pack a = pack_from(i);
    for (std::size_t k = 0; k < lanes; ++k) {
      expect_same(abs(a)[k], std::abs(a[k]));
      expect_same(floor(a)[k], std::floor(a[k]));
      if (!(a[k] < 0)) expect_same(sqrt(a)[k], std::sqrt(a[k]));
    }
  }
}

TEST(Lanes, OverAll) {
  for (std::size_t one = 0; one < lanes; ++one) {
    const Pack a([&](std::size_t lane) { return lane == one ? -2.0 : 5.0 + static_cast<double>(lane); });
    EXPECT_EQ(hmin(a), -2);
    EXPECT_EQ(hmax(-a), 2);
    EXPECT_TRUE(any_of(a < 0.0));
    EXPECT_FALSE(none_of(a < 0.0));
    EXPECT_FALSE(all_of(a > 0.0));
    EXPECT_TRUE(all_of(a > -3.0));
    EXPECT_TRUE(none_of(a < -3.0));
    EXPECT_EQ(find_first_set(a < 0.0), static_cast<int>(one));
  }
}

}  // namespace
}  // namespace plumbline::lanes_test
