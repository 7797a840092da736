// Normals of a surface in space from where its points stand, by fits to those nearby; no mesh, no tangents.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plumbline {

enum class SurfaceFit { plane, quadric };

// Unit normals of points, of either sign, by the neighbours q closer than `reach`, with the weights w = (1 - r^2/reach^2)^2.
//   plane    the direction n in which the neighbours spread least about their mean [Surface 15]:
//              min sum_q w_q (n . (x_q - <x>))^2, |n| = 1
//   quadric  heights z over that plane by a quadratic in the places (u, v) on it, min sum_q w_q (z_q - a - b . (u, v)_q - ...)^2;
//              then n - b, normed [Surface 16]
// reach: m, > 0. Throws std::invalid_argument for a point whose neighbours do not determine its fit.
std::vector<Eigen::Vector3d> fitted_normals(const std::vector<Eigen::Vector3d>& points, double reach, SurfaceFit fit);

}  // namespace plumbline
