#pragma once
// Weights of a point on the nodes of a unit grid: what mpm_amplification builds its matrices from.
#include <array>

#include "reference/mpm_amplification.hpp"

namespace plumbline::reference {

/// Of the nodes first, first + 1, ...: S_pi, dS_pi/dx, x_i - x_p, and the weights that give C_p from nodal velocities,
/// S_pi (x_i - x_p)/D_p, which for tents is the gradient even where D_p = 0.
struct PointWeights {
  static constexpr int nodes = 4;
  int first = 0;
  std::array<Bounded, nodes> weight, gradient, arm, affine;
};

/// A point on a node belongs to the cell above. `box` is its width, used by GridShape::boxes alone, at most 1.
PointWeights point_weights(GridShape shape, double x, double box);

/// Half the variance of the shape; of boxes that of half a cell, whatever their width.
Bounded blur(GridShape shape);

}  // namespace plumbline::reference
