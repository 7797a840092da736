// Who is whose neighbour on a surface in space where a mesh between its points is known.
#pragma once

#include <array>
#include <vector>

namespace plumbline {

using Triangle = std::array<int, 3>;  // numbers of the points at its corners

// Of each of `points` points those at most `rings` edges away, in ascending order and without itself. In a mesh of equal triangles
// one ring has 6 points, two have 18.
// Throws std::invalid_argument for a corner that is no point or twice in its triangle, and for fewer than one ring.
std::vector<std::vector<int>> neighbours_in_mesh(const std::vector<Triangle>& mesh, int points, int rings);

}  // namespace plumbline
