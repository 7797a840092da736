// A gas tube with a diaphragm: one struct of parameters from which both the points and the reference are made.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "cases/catalog/gas/gas_problem.hpp"
#include "cases/harness/description/parameters.hpp"
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

// A tube's parameters, its own values as defaults.
struct TubeParameters : Parameters {
  ShockTube tube;
  explicit TubeParameters(const ShockTube& defaults, Parameters given = {});
};

// Case::problem: cells are counted along the tube; across it there are a few, between mirrors, and points stand alike
// on every line along it, whatever the dimension.
std::function<std::unique_ptr<Problem>(const Settings&)> tube_run(const ShockTube& defaults);

// Case::comparators: finite volumes on a line, ends left open.
std::function<std::vector<Comparator>(const Settings&, const std::vector<double>&)> beside_finite_volumes(
    const ShockTube& defaults);

// Gas that a wall at rest may disturb until `time`, m; 0 for gas at rest. The wave that it sends into gas of speed u and
// sound speed c is slower than |u| + c: a rarefaction's head at most that, a shock (gamma + 1)/4 |u| +
// sqrt(((gamma + 1)/4 u)^2 + c^2) - |u| <= (gamma - 1)/2 |u| + c. gamma <= 3.
double disturbed_by_wall(const reference::GasState& gas, double gamma, double time);

// The flow of a tube on a line, whatever its dimension says.
GasFlow tube_flow(const ShockTube& tube);

}  // namespace plumbline
