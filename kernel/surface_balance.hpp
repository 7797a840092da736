// Weights by which tangents of a surface follow from its points, changed so that a uniform tension is at rest.
#pragma once

#include <array>
#include <vector>

#include "kernel/points/columns.hpp"

namespace plumbline {

// What a neighbour adds to the tangents of a point.
struct SurfaceLink {
  int of, on;  // the point, and its neighbour or the partner of an image
  bool image;  // of an image, which moves the other way than its partner
  std::array<double, 5>
      terms;  // xi_1, xi_2, xi_1^2/2, xi_1 xi_2, xi_2^2/2 of its place at rest over the reach; 0 of the point itself
  std::array<double, 2> weight;  // c_1, c_2, 1/m
};

// A tension that is the same everywhere pulls at point k with
//   g_k = sum_p A_p sum_a c_pka f_a(p),
// of which nothing may be left in the surface, and along its normal n only what its curvature asks for. Weights of moving least squares
// leave some where points are irregular or stand on one side alone; they are changed by the least sum of squares with which
//   sum_k c_pka (1, xi, xi xi) stays,  e . g_k = 0 for all directions e of the surface but across a free edge, [Surface 14]
//   n . g_k = -A_k n . sum_a d^2 x/d xi_a^2 [Surface 18]
// of the quadratic surface through the neighbours of k, as far as the work of such a tension in a motion of the whole allows, which no
// such weights change.
// (Variational consistency: J.-S. Chen, M. Hillman, M. Rueter, Int. J. Numer. Meth. Engng 95 (2013) 387, doi 10.1002/nme.4512.)
//   points   with tangents and volumes
//   reach    m at rest, > 0
//   outward  for each point: of length 1 in the surface, out of the free edge that is no farther than the reach; none: 0
// Throws std::invalid_argument where `outward` has not one vector for each point, a surface that is not flat has images, or no such
// weights are found.
void balance_weights(std::vector<SurfaceLink>& links, const Columns& points, double reach,
                     const std::vector<std::array<double, 3>>& outward);

}  // namespace plumbline
