// What every method does with the directions it finds.
#pragma once

#include <cmath>
#include <cstddef>

#include "kernel/normals/normals.hpp"

namespace plumbline {

// Shorter than this a gradient is rounding of colours of size one, its length in cells.
inline constexpr double no_direction = 1e-12;

// The unit vector along (x, y); without a direction the previous normal of the point, or (0, 0).
inline void set_normal(const NormalsInput& input, std::size_t point, double x, double y, std::span<double> normal_x,
                       std::span<double> normal_y) {
  const double length = std::hypot(x, y);
  if (length > no_direction) {
    normal_x[point] = x / length;
    normal_y[point] = y / length;
  } else {
    normal_x[point] = input.previous_x.empty() ? 0 : input.previous_x[point];
    normal_y[point] = input.previous_y.empty() ? 0 : input.previous_y[point];
  }
}

}  // namespace plumbline
