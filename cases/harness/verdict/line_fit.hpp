// A straight line through points, by weighted least squares.
#pragma once

#include <span>

namespace plumbline {

struct FitPoint {
  double x = 0, y = 0;
  double weight = 1;
};

struct StraightLine {
  double slope = 0, intercept = 0;
  double slope_error = 0;  // standard error of the slope, its scale taken from the residuals; infinite with two points
};

// At least two points with different x; else the numbers are not finite.
StraightLine fit_line(std::span<const FitPoint> points);

}  // namespace plumbline
