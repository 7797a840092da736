// Student's t with 1, 2 and 4 degrees of freedom, 0.025 cut off at either end. [W. T. Shaw, J. Comput. Finance 9 (2006) 37]
#pragma once

#include <cmath>
#include <numbers>

namespace plumbline {

inline constexpr double cut_off = 0.025, both_ends = 4 * cut_off * (1 - cut_off);
inline double student_of_one() { return std::tan(std::numbers::pi * (0.5 - cut_off)); }
inline double student_of_two() { return (1 - 2 * cut_off) * std::sqrt(2 / both_ends); }
inline double student_of_four() {
  return 2 * std::sqrt(std::cos(std::acos(std::sqrt(both_ends)) / 3) / std::sqrt(both_ends) - 1);
}

}  // namespace plumbline
