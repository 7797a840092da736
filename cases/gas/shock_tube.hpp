// A gas tube with a diaphragm: one struct of parameters from which both the points and the reference are made.
#pragma once

#include <memory>

#include "cases/harness/case.hpp"
#include "reference/riemann.hpp"

namespace plumbline {

// Lengths in m, times in s. The tube is [low, high]; walls stand on the node lines at or beyond its ends.
struct ShockTube {
  reference::RiemannProblem states;
  double low = 0, high = 1;
  double diaphragm = 0.5;   // low < diaphragm < high
  double end_time = 0.143;  // > 0
};

// Keys of the states (left.density, ..., gamma), the diaphragm and t_end, with the tube's values as defaults.
std::vector<Key> shock_tube_keys(const ShockTube& tube);
// The tube that the settings describe. Throws UsageError if the reference refuses the states.
ShockTube shock_tube_from(const Settings& settings, const ShockTube& defaults);

// Points, scene and measures of a tube on a line. Cells are counted along a length of 1 m.
std::unique_ptr<Problem> shock_tube_problem(const ShockTube& tube, const Settings& settings);

}  // namespace plumbline
