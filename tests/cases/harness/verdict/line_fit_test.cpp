// A straight line through points: exact ones, and ones that scatter by what has no share in the line.
#include "cases/harness/verdict/line_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace plumbline::line_fit_test {
namespace {

TEST(LineFit, OfPointsOnALine) {
  const StraightLine line = fit_line(std::vector<FitPoint>{{-1, 5, 3}, {2, -1, 0.2}, {7, -11, 1}});
  EXPECT_NEAR(line.slope, -2, 1e-14);
  EXPECT_NEAR(line.intercept, 3, 1e-14);
  EXPECT_NEAR(line.slope_error, 0, 1e-14);
  EXPECT_TRUE(std::isinf(fit_line(std::vector<FitPoint>{{0, 1}, {1, 2}}).slope_error));
}

// Residuals e (1, -2, 1) at x = -1, 0, 1 are square to 1 and to x: they leave the line as it is, and its slope's variance is
// their squares' sum over n - 2 = 1 and over the sum of x^2 = 2. With (1, -3, 3, -1) at four places the other way round.
TEST(LineFit, ResidualsThatAreNoPartOfTheLineAreItsError) {
  const double e = 0.1;
  const StraightLine three = fit_line(std::vector<FitPoint>{{4, 2 + e}, {5, 5 - 2 * e}, {6, 8 + e}});
  EXPECT_NEAR(three.slope, 3, 1e-14);
  EXPECT_NEAR(three.intercept, -10, 1e-13);
  EXPECT_NEAR(three.slope_error, e * std::sqrt(6.0 / 2), 1e-14);
  const StraightLine four = fit_line(std::vector<FitPoint>{{-3, e}, {-1, -3 * e}, {1, 3 * e}, {3, -e}});
  EXPECT_NEAR(four.slope, 0, 1e-14);
  EXPECT_NEAR(four.slope_error, e * std::sqrt(20.0 / 2 / 20), 1e-14);
}

// A point of weight three counts as three points in its place.
TEST(LineFit, WeightsCountPoints) {
  const StraightLine weighted = fit_line(std::vector<FitPoint>{{0, 1, 3}, {1, 4}, {3, 2}});
  const StraightLine repeated = fit_line(std::vector<FitPoint>{{0, 1}, {0, 1}, {0, 1}, {1, 4}, {3, 2}});
  EXPECT_NEAR(weighted.slope, repeated.slope, 1e-14);
  EXPECT_NEAR(weighted.intercept, repeated.intercept, 1e-14);
  EXPECT_NEAR(weighted.slope_error, repeated.slope_error * std::sqrt(3), 1e-14);  // of 3 - 2 degrees, not 5 - 2
}

}  // namespace
}  // namespace plumbline::line_fit_test
