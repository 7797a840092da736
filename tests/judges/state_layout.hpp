// Which numbers of a State are whose: of each body first all places, one direction after the other, then all velocities, then
// what its material carries.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "kernel/stages.hpp"

namespace plumbline::judged {

// Offsets in State::values, in the order in which they stand there.
struct PartOfBody {
  std::size_t places = 0, velocities = 0, carried = 0, end = 0;

  std::size_t directions_times_points() const { return carried - velocities; }
  std::size_t carried_values() const { return end - carried; }
  // Bodies on a line carry one number a point, in the materials of the catalog.
  bool on_a_line() const { return carried_values() == directions_times_points(); }
};

inline std::vector<PartOfBody> bodies_of(const Stages& mpm) {
  State ones = mpm.state();
  std::fill(ones.values.begin(), ones.values.end(), 1.0);
  const std::vector<double> is_velocity = mpm.velocities_of(ones).values;
  std::vector<PartOfBody> bodies;
  for (std::size_t k = 0; k < is_velocity.size(); ++k) {
    if (is_velocity[k] == 0 || (k > 0 && is_velocity[k - 1] != 0)) continue;
    const std::size_t last = static_cast<std::size_t>(
        std::find(is_velocity.begin() + static_cast<std::ptrdiff_t>(k), is_velocity.end(), 0.0) - is_velocity.begin());
    const std::size_t length = last - k;
    if (!bodies.empty()) bodies.back().end = k - length;
    bodies.push_back({k - length, k, last, is_velocity.size()});
  }
  return bodies;
}

}  // namespace plumbline::judged
