// B-splines with knots one apart, centred on zero, by the recursion of Cox and de Boor, and what they integrate to.
#pragma once

namespace plumbline::kernel_functions {

inline double spline(int degree, double x) {
  if (degree == 0) return x >= -0.5 && x < 0.5 ? 1 : 0;
  const double half = 0.5 * (degree + 1);
  return ((half + x) * spline(degree - 1, x + 0.5) + (half - x) * spline(degree - 1, x - 0.5)) / degree;
}

inline double spline_slope(int degree, double x) { return spline(degree - 1, x + 0.5) - spline(degree - 1, x - 0.5); }

// Integrated so many times from -inf to x: slopes of splines of one degree more, one after another, sum to one of this degree.
inline double spline_integral(int degree, double x, int times = 1) {
  if (times == 0) return spline(degree, x);
  double sum = 0;
  for (double at = x - 0.5; at > -0.5 * (degree + 2 * times); --at) sum += spline_integral(degree + 1, at, times - 1);
  return sum;
}

// int B s ds from -inf to x, by parts.
inline double spline_moment(int degree, double x) {
  return x * spline_integral(degree, x) - spline_integral(degree, x, 2);
}

}  // namespace plumbline::kernel_functions
