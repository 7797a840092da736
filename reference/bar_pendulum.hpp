#pragma once
// The pendulum of elastic_pendulum.hpp by finite elements: two-noded bars in a row, lumped masses, updated Lagrangian,
// explicit by central differences, as York computed it beside his own (section 5.7.2). How many elements he took is not
// printed.
#include <array>
#include <vector>

#include "reference/elastic_pendulum.hpp"

namespace plumbline::reference {

using BarNodes = std::vector<std::array<double, 2>>;

/// Places of the `elements` + 1 nodes, from the pivot to the bob, at each of `times` (>= 0, not decreasing). Steps are
/// half the time that a wave needs along an element of the density `problem.density` > 0. Throws ParameterError.
std::vector<BarNodes> bar_pendulum(const ElasticPendulumProblem& problem, int elements,
                                   const std::vector<double>& times);

}  // namespace plumbline::reference
