// A gas tube with a diaphragm: one struct of parameters from which both the points and the reference are made.
#pragma once

#include <memory>

#include "cases/catalog/gas/gas_problem.hpp"
#include "reference/riemann.hpp"

namespace plumbline {

// Lengths in m, times in s. The tube is [low, high]; walls stand on the node lines at or beyond its ends. Where gas
// moves through an end, the gas goes on beyond it, so far that nothing reaches the tube from the wall there.
struct ShockTube {
  reference::RiemannProblem states;
  double low = 0, high = 1;
  double diaphragm = 0.5;   // low < diaphragm < high
  double end_time = 0.143;  // > 0
  int dimension = 1;        // of the space it is run in; the tube lies along x
};

// Keys of the states (left.density, ..., gamma), the diaphragm, t_end and dimension, with the tube's values as defaults.
std::vector<Key> shock_tube_keys(const ShockTube& tube);
// The tube that the settings describe. Throws UsageError if the reference refuses the states.
ShockTube shock_tube_from(const Settings& settings, const ShockTube& defaults);

// Gas that a wall at rest may disturb until `time`, m; 0 for gas at rest. The wave that it sends into gas of speed u and
// sound speed c is slower than |u| + c: a rarefaction's head at most that, a shock (gamma + 1)/4 |u| +
// sqrt(((gamma + 1)/4 u)^2 + c^2) - |u| <= (gamma - 1)/2 |u| + c. gamma <= 3.
double disturbed_by_wall(const reference::GasState& gas, double gamma, double time);

// The finite-volume stick on the tube, ends left open.
Comparator tube_stick(const ShockTube& tube, const std::vector<double>& cells);

// The flow of a tube on a line, whatever its dimension says.
GasFlow tube_flow(const ShockTube& tube);
// Points, scene and measures of it. Cells are counted along the tube; across it there are a few, between mirrors, and
// points that stand alike on every line along it: a run on a line, plane or solid.
constexpr int cells_across_tube = 4;
std::unique_ptr<Problem> shock_tube_problem(const ShockTube& tube, const Settings& settings);

}  // namespace plumbline
