#include "kernel/normals/colour_gradient.hpp"

#include <gtest/gtest.h>

#include "tests/kernel/normals/curves.hpp"

namespace plumbline::colour_gradient_test {
namespace {

// Shapes of York's appendix and of the cubic spline as functions of the distance in cells, with their derivatives.
double tent(double d) { return std::max(0.0, 1 - std::abs(d)); }
double tent_slope(double d) { return std::abs(d) >= 1 ? 0 : d > 0 ? -1 : 1; }
double quadratic(double d) {
  const double a = std::abs(d);
  return a < 0.5 ? 0.75 - a * a : a < 1.5 ? 0.5 * (1.5 - a) * (1.5 - a) : 0;
}
double cubic(double d) {
  const double a = std::abs(d);
  return a < 1 ? 2.0 / 3 - a * a + a * a * a / 2 : a < 2 ? (2 - a) * (2 - a) * (2 - a) / 6 : 0;
}
double cubic_slope(double d) {
  const double a = std::abs(d), s = d < 0 ? -1 : 1;
  return a < 1 ? s * (-2 * a + 1.5 * a * a) : a < 2 ? -s * (2 - a) * (2 - a) / 2 : 0;
}

struct Cloud {
  test::Curve membrane;
  std::vector<double> gas_x, gas_y;
  std::vector<double> all_x, all_y;  // in cells
};

// Away from the rim of a grid of 12 cells of 0.5, so that sums over all nodes miss nothing.
Cloud cloud() {
  Cloud c;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(1.6, 4.4);
  for (int p = 0; p < 20; ++p) c.membrane.add(uniform(random), uniform(random), 1, 0);
  for (int p = 0; p < 30; ++p) c.gas_x.push_back(uniform(random)), c.gas_y.push_back(uniform(random));
  for (std::size_t p = 0; p < 20; ++p) c.all_x.push_back(2 * c.membrane.x[p]), c.all_y.push_back(2 * c.membrane.y[p]);
  for (std::size_t p = 0; p < 30; ++p) c.all_x.push_back(2 * c.gas_x[p]), c.all_y.push_back(2 * c.gas_y[p]);
  return c;
}

template <class Gradient>
void expect_normals(const std::string& method, const Cloud& c, Gradient gradient) {
  const test::Normals n = test::find(method, test::square(12, 0.5), c.membrane, c.gas_x, c.gas_y);
  for (std::size_t p = 0; p < c.membrane.size(); ++p) {
    const auto [gx, gy] = gradient(c.all_x[p], c.all_y[p]);
    const double length = std::hypot(gx, gy);
    EXPECT_NEAR(n.x[p], gx / length, 1e-12) << method << " point " << p;
    EXPECT_NEAR(n.y[p], gy / length, 1e-12) << method << " point " << p;
  }
}

TEST(ColourGradient, SimpleIsTheInterpolatedSumOfShapeGradients) {  // [York 7.2, 7.3]
  const Cloud c = cloud();
  expect_normals("york-simple", c, [&](double x, double y) {
    std::array<double, 2> n_p{};
    for (int j = 0; j <= 12; ++j) {
      for (int i = 0; i <= 12; ++i) {
        double nx = 0, ny = 0;
        for (std::size_t q = 0; q < c.all_x.size(); ++q) {
          nx += tent_slope(c.all_x[q] - i) * tent(c.all_y[q] - j);
          ny += tent(c.all_x[q] - i) * tent_slope(c.all_y[q] - j);
        }
        n_p[0] += nx * tent(x - i) * tent(y - j);
        n_p[1] += ny * tent(x - i) * tent(y - j);
      }
    }
    return n_p;
  });
}

TEST(ColourGradient, QuadraticIsTheInterpolatedGradientOfCellColours) {  // [York 7.4, 7.5]
  const Cloud c = cloud();
  std::vector<double> colour(144);
  for (int cell = 0; cell < 144; ++cell) {
    for (std::size_t q = 0; q < c.all_x.size(); ++q) {
      colour[static_cast<std::size_t>(cell)] += quadratic(c.all_x[q] - cell % 12 - 0.5) *
                                                quadratic(c.all_y[q] - cell / 12 - 0.5);
    }
  }
  expect_normals("york-quadratic", c, [&](double x, double y) {
    std::array<double, 2> n_p{};
    for (int j = 0; j <= 12; ++j) {
      for (int i = 0; i <= 12; ++i) {
        double nx = 0, ny = 0;
        for (int cell = 0; cell < 144; ++cell) {
          const double cx = cell % 12 + 0.5 - i, cy = cell / 12 + 0.5 - j, chi = colour[static_cast<std::size_t>(cell)];
          nx += tent_slope(cx) * tent(cy) * chi;
          ny += tent(cx) * tent_slope(cy) * chi;
        }
        n_p[0] += nx * tent(x - i) * tent(y - j);
        n_p[1] += ny * tent(x - i) * tent(y - j);
      }
    }
    return n_p;
  });
}

TEST(ColourGradient, CubicIsTheSplinesGradientOfNodalColours) {  // [York 7.6, 7.7]
  const Cloud c = cloud();
  expect_normals("york-cubic", c, [&](double x, double y) {
    std::array<double, 2> n_p{};
    for (int j = 0; j <= 12; ++j) {
      for (int i = 0; i <= 12; ++i) {
        double chi = 0;
        for (std::size_t q = 0; q < c.all_x.size(); ++q) chi += cubic(c.all_x[q] - i) * cubic(c.all_y[q] - j);
        n_p[0] += chi * cubic_slope(x - i) * cubic(y - j);
        n_p[1] += chi * cubic(x - i) * cubic_slope(y - j);
      }
    }
    return n_p;
  });
}

TEST(ColourGradient, MirrorsAreAsGoodAsTheOtherHalf) {
  const test::Curve quarter = test::arc(0, 0, 1, 0, 90, 37);
  std::vector<double> gas_x, gas_y;
  test::fill_circle(0.1, 2, gas_x, gas_y);
  test::Curve gas;
  for (std::size_t p = 0; p < gas_x.size(); ++p) gas.add(gas_x[p], gas_y[p], 1, 0);
  gas = test::unfolded(gas);
  const GridSpec grid = test::square(14, 0.1, true);
  for (const char* method : {"york-simple", "york-quadratic", "york-cubic"}) {
    const test::Normals folded = test::find(method, grid, quarter, gas_x, gas_y);
    const test::Normals whole = test::find(method, test::unfolded(grid), test::unfolded(quarter), gas.x, gas.y);
    for (std::size_t p = 0; p < quarter.size(); ++p) {
      EXPECT_NEAR(folded.x[p], whole.x[p], 1e-11) << method << " point " << p;
      EXPECT_NEAR(folded.y[p], whole.y[p], 1e-11) << method << " point " << p;
    }
  }
}

// York's Figs. 67 to 71: unusable when empty, better with points inside, best with many.
TEST(ColourGradient, NeedsPointsInside) {
  const test::Curve quarter = test::arc(0, 0, 1, 0, 90, 179);
  const GridSpec grid = test::square(15, 0.1, true);
  for (const char* method : {"york-simple", "york-quadratic", "york-cubic"}) {
    double last = 90;
    for (const int n : {0, 2, 4}) {
      std::vector<double> x, y;
      if (n > 0) test::fill_circle(0.1, n, x, y);
      const test::Normals normals = test::find(method, grid, quarter, x, y);
      if (n == 0) {
        EXPECT_GT(test::largest_angle(normals, quarter), 45) << method;
      }
      EXPECT_LT(test::mean_angle(normals, quarter), last) << method << " with " << n * n << " points per cell";
      last = test::mean_angle(normals, quarter);
    }
  }
}

TEST(ColourGradient, WithoutGradientThePreviousNormalStays) {
  const test::Curve one = test::line(2.5, 2.5, 0, {0});  // at a cell centre: no gradient
  const GridSpec grid = test::square(5, 1);
  const std::vector<double> before_x{0.6}, before_y{0.8};
  std::vector<double> nx(1), ny(1);
  for (const char* method : {"york-simple", "york-quadratic", "york-cubic"}) {
    make_normals(method)->find({grid, one.x, one.y, {}, {}, before_x, before_y, false}, nx, ny);
    EXPECT_EQ(nx[0], 0.6) << method;
    EXPECT_EQ(ny[0], 0.8) << method;
    make_normals(method)->find({grid, one.x, one.y, {}, {}, {}, {}, false}, nx, ny);
    EXPECT_EQ(std::hypot(nx[0], ny[0]), 0) << method;
  }
}

}  // namespace
}  // namespace plumbline::colour_gradient_test
