#include "cases/harness/verdict/line_fit.hpp"

#include <cmath>
#include <limits>

namespace plumbline {

StraightLine fit_line(std::span<const FitPoint> points) {
  double weights = 0, x_mean = 0, y_mean = 0;
  for (const FitPoint& p : points) {
    weights += p.weight;
    x_mean += p.weight * p.x;
    y_mean += p.weight * p.y;
  }
  x_mean /= weights;
  y_mean /= weights;
  double xx = 0, xy = 0;
  for (const FitPoint& p : points) {
    xx += p.weight * (p.x - x_mean) * (p.x - x_mean);
    xy += p.weight * (p.x - x_mean) * (p.y - y_mean);
  }
  const double slope = xy / xx;
  double residual = 0;
  for (const FitPoint& p : points) {
    const double r = (p.y - y_mean) - slope * (p.x - x_mean);
    residual += p.weight * r * r;
  }
  const double degrees = static_cast<double>(points.size()) - 2;
  return {slope, y_mean - slope * x_mean,
          degrees > 0 ? std::sqrt(residual / degrees / xx) : std::numeric_limits<double>::infinity()};
}

}  // namespace plumbline
