// Lines through six points and Student's t in closed form.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace plumbline {

// Off a straight line through six evenly spaced points, orthogonal to constants and to lines: the line fitted is the same.
inline constexpr std::array<double, 6> off_line{1, -1, 0, 0, -1, 1};
// The standard error of its slope where points are a factor two apart, in logarithms, and off by `size` times these: of both the
// squares add up, along the line to 17.5 (ln 2)^2, off it to 4 size^2, with four degrees of freedom.
inline double slope_error_of_six(double size) { return size / std::sqrt(17.5) / std::numbers::ln2; }

// Student's t with 1, 2 and 4 degrees of freedom, 0.025 cut off at either end. [W. T. Shaw, J. Comput. Finance 9 (2006) 37]
inline constexpr double cut_off = 0.025, both_ends = 4 * cut_off * (1 - cut_off);
inline double student_of_one() { return std::tan(std::numbers::pi * (0.5 - cut_off)); }
inline double student_of_two() { return (1 - 2 * cut_off) * std::sqrt(2 / both_ends); }
inline double student_of_four() {
  return 2 * std::sqrt(std::cos(std::acos(std::sqrt(both_ends)) / 3) / std::sqrt(both_ends) - 1);
}

}  // namespace plumbline
