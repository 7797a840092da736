// Gravity on an incline, in axes along it and off it, that grows from zero.
#pragma once

#include <algorithm>

#include "cases/harness/description/drag.hpp"
#include "reference/incline.hpp"

namespace plumbline {

// Within the problem's rise, by a cubic whose slope is zero at both ends.
inline Load incline_gravity(const reference::Incline& incline) {
  return [incline](double time, Columns& points, std::span<const int>) {
    const double s = std::min(1.0, time / incline.problem().rise), grown = s * s * (3 - 2 * s);
    std::fill_n(points(column::body_force, 0), points.points(), grown * incline.along().value);
    std::fill_n(points(column::body_force, 1), points.points(), -grown * incline.across().value);
  };
}

}  // namespace plumbline
