// The order of points along curves whose points were put out of order: known, since they were made in it. [Curve 1]
#include "kernel/curve_order.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "tests/kernel/scenes.hpp"

namespace plumbline::curve_order_test {
namespace {

struct Points {
  std::vector<double> x, y;
  std::vector<int> made;  // the place of each along the curve
};

// n points at ((k + jitter) / n) of the curve, in an order that has nothing to do with it.
template <class At>
Points scattered(int n, double jitter, At&& at) {
  scenes::Random random(11);
  std::vector<int> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t k = order.size() - 1; k > 0; --k) {
    std::swap(order[k], order[static_cast<std::size_t>(random(0, static_cast<double>(k + 1)))]);
  }
  Points points;
  for (const int k : order) {
    const auto [x, y] = at((k + random(-jitter, jitter)) / n);
    points.x.push_back(x);
    points.y.push_back(y);
    points.made.push_back(k);
  }
  return points;
}

using Place = std::array<double, 2>;

Place circle(double s) { return {std::cos(2 * std::numbers::pi * s), std::sin(2 * std::numbers::pi * s)}; }
// Nears itself to a tenth, where the curvature is up to 20.
Place neck(double s) {
  const double a = 2 * std::numbers::pi * s;
  return {std::cos(a), std::sin(a) * (0.05 + std::cos(a) * std::cos(a))};
}
Place spiral(double s) {
  const double a = 1 + 14 * s;
  return {0.1 * a * std::cos(a), 0.1 * a * std::sin(a)};
}

// Each step goes on by one, around the end too for a closed one.
void expect_in_order(const Points& points, bool closed) {
  const CurveOrder order = order_along_curve(points.x, points.y);
  const int n = static_cast<int>(points.x.size());
  EXPECT_EQ(order.closed, closed);
  ASSERT_EQ(static_cast<int>(order.points.size()), n);
  const auto made = [&](int k) {
    return points.made[static_cast<std::size_t>(order.points[static_cast<std::size_t>(k)])];
  };
  const int step = (made(1) - made(0) + n) % n;
  ASSERT_TRUE(step == 1 || step == n - 1) << step;
  for (int k = 1; k < n; ++k) EXPECT_EQ((made(k) - made(k - 1) + n) % n, step) << k;
}

TEST(CurveOrder, ClosedCurvesAreFollowedAround) {
  expect_in_order(scattered(24, 0, circle), true);
  expect_in_order(scattered(200, 0.25, circle), true);
  expect_in_order(scattered(400, 0.25, neck), true);
}

TEST(CurveOrder, OpenCurvesStartAtTheEndOfTheLowerNumber) {
  const auto half = [](double s) { return circle(s / 2); };
  for (const Points& points : {scattered(30, 0.2, half), scattered(300, 0.2, spiral), scattered(17, 0.3, [](double s) {
                                 return Place{s, 2 * s};
                               })}) {
    expect_in_order(points, false);
    const CurveOrder order = order_along_curve(points.x, points.y);
    EXPECT_LT(order.points.front(), order.points.back());
  }
}

TEST(CurveOrder, TwoPointsAreALine) {
  const CurveOrder order = order_along_curve(std::vector<double>{1, 0}, std::vector<double>{0, 0});
  EXPECT_EQ(order.points, (std::vector<int>{0, 1}));
  EXPECT_FALSE(order.closed);
}

// Two curves, a corner that points are too far apart for, points in one place, a place that is no number.
TEST(CurveOrder, RefusesWhatIsNotOneCurve) {
  Points two = scattered(40, 0, circle);
  const Points away = scattered(40, 0, [](double s) { return Place{circle(s)[0] + 5, circle(s)[1]}; });
  two.x.insert(two.x.end(), away.x.begin(), away.x.end());
  two.y.insert(two.y.end(), away.y.begin(), away.y.end());
  const std::vector<double> corner_x{0, 1, 2, 2, 2}, corner_y{0, 0, 0, 1, 2}, twice_x{0, 1, 1, 2}, twice_y{0, 0, 0, 0};
  const std::vector<double> lost{0, 1, std::numeric_limits<double>::quiet_NaN()}, line{0, 1, 2}, one{1};
  EXPECT_THROW(order_along_curve(two.x, two.y), std::invalid_argument);
  EXPECT_THROW(order_along_curve(corner_x, corner_y), std::invalid_argument);
  EXPECT_THROW(order_along_curve(twice_x, twice_y), std::invalid_argument);
  EXPECT_THROW(order_along_curve(lost, line), std::invalid_argument);
  EXPECT_THROW(order_along_curve(one, one), std::invalid_argument);
  EXPECT_THROW(order_along_curve(line, one), std::invalid_argument);
}

}  // namespace
}  // namespace plumbline::curve_order_test
