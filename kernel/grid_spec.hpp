// The background grid as a scene states it: square cells of size h, walls on node lines.
#pragma once

#include <array>

namespace plumbline {

// What stands at a side of the grid.
//   free      nothing: nodes beyond the side move as all others
//   symmetry  mirror: the normal velocity is odd, the tangential even; in 1-D a rigid frictionless wall
//   no_slip   all velocity components are odd: the wall's velocity is exactly zero
enum class Wall { free, symmetry, no_slip };

// A grid as a scene states it. Lengths in m. cells: >= 1 a direction, at least 2 where a wall mirrors ghosts.
struct GridSpec {
  int dim = 1;                // 1, 2 or 3
  bool axisymmetric = false;  // with dim = 2: x is the radius, y the axis; points and cells are rings, per radian
  std::array<int, 3> cells{1, 1, 1};
  double h = 1.0;                               // > 0
  std::array<double, 3> origin{0.0, 0.0, 0.0};  // lowest node line of each direction
  std::array<std::array<Wall, 2>, 3> walls{
      {{Wall::free, Wall::free}, {Wall::free, Wall::free}, {Wall::free, Wall::free}}};  // [direction][low, high]
};

}  // namespace plumbline
