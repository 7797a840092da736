// The limit of something for dt -> 0 as a gate judges it: with as many step sizes as the verdict needs.
#pragma once

#include <functional>
#include <vector>

#include "cases/harness/verdict/verdict.hpp"

namespace plumbline {

// What may be left for dt -> 0, relative: a hundredth of the smallest defect that has to be seen, one per mille of a force, a
// strain or a motion, which changes places and velocities by about as much.
inline constexpr double most_left_over = 1e-5;

// Step counts steps, 2 steps, 4 steps, ...: at least `least` of them, at most `most`, until it can be told on which side of
// the bound the limit lies. The interval is three times the extrapolation's own uncertainty to both sides; a sequence
// that does not fall at all is its own limit.
struct Halvings {
  int steps, least, most;
  double bound = most_left_over;
};
Measured measured_limit(const Halvings& halvings, const std::function<std::vector<double>(int steps)>& values_at);

}  // namespace plumbline
