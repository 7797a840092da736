// York's mass matrix in space: colours of the eight nodes of a cell that are one on its points. [York 7.8-7.14]
#pragma once

#include <Eigen/Core>
#include <vector>

namespace plumbline {

// Normals of points, not normed: sum_i chi_i grad N_i with trilinear shapes in each cell of size h, the colours chi of minimum norm that
// are zero at the cell's points and one at its corner furthest from all of them. A point alone in its cell takes the eight cells around
// the node nearest to it as one; alone there, too, it has none, (0, 0, 0).
std::vector<Eigen::Vector3d> space_mass_matrix_normals(const std::vector<Eigen::Vector3d>& points, double h);

}  // namespace plumbline
