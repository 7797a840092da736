// The background grid: square cells of size h, walls on node lines, one layer of ghost nodes beyond every side.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "kernel/geometry.hpp"

namespace plumbline {

// What stands at a side of the grid.
//   free      nothing: nodes beyond the side move as all others
//   symmetry  mirror: the normal velocity is odd, the tangential even; in 1-D a rigid frictionless wall
//   no_slip   all velocity components are odd: the wall's velocity is exactly zero
enum class Wall { free, symmetry, no_slip };

// A grid as a scene states it. Lengths in m. cells: >= 1 a direction, at least 2 where a wall mirrors ghosts.
struct GridSpec {
  int dim = 1;  // 1 or 2
  std::array<int, 2> cells{1, 1};
  double h = 1.0;                          // > 0
  std::array<double, 2> origin{0.0, 0.0};  // lowest node line of each direction
  std::array<std::array<Wall, 2>, 2> walls{
      {{Wall::free, Wall::free}, {Wall::free, Wall::free}}};  // [direction][low, high]
};

// The same with indices: node (i, j) of the flat arrays, ghosts included.
template <int dim>
class Grid {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  static constexpr int ghosts = 1;

  explicit Grid(const GridSpec& spec) : spec_(spec) {
    for (int d = 0; d < dim; ++d) nodes_[d] = spec.cells[static_cast<std::size_t>(d)] + 1 + 2 * ghosts;
  }

  double h() const { return spec_.h; }
  int cells(int d) const { return spec_.cells[static_cast<std::size_t>(d)]; }
  Wall wall(int d, int side) const { return spec_.walls[static_cast<std::size_t>(d)][static_cast<std::size_t>(side)]; }
  int nodes(int d) const { return nodes_[d]; }
  int row_length() const { return nodes_[0]; }
  int rows() const { return dim == 1 ? 1 : nodes_[dim - 1]; }
  int node_count() const { return row_length() * rows(); }

  // Position in cells from the lowest node line.
  double logical(double x, int d) const { return (x - spec_.origin[static_cast<std::size_t>(d)]) / spec_.h; }
  // Position of node line `index` (ghosts counted) of direction d.
  double line(int index, int d) const { return spec_.origin[static_cast<std::size_t>(d)] + spec_.h * (index - ghosts); }
  Vec position(int node) const {
    Vec x;
    x[0] = line(node % row_length(), 0);
    if constexpr (dim == 2) x[1] = line(node / row_length(), 1);
    return x;
  }

 private:
  GridSpec spec_;
  int nodes_[dim];
};

}  // namespace plumbline
