// The background grid with indices: one layer of ghost nodes beyond every side.
#pragma once

#include <Eigen/Core>

#include "kernel/grid_spec.hpp"

namespace plumbline {

// Node (i, j, k) of the flat arrays, ghosts included; a row is a line of nodes along x.
template <int dim>
class Grid {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  static constexpr int ghosts = 1;

  explicit Grid(const GridSpec& spec) : spec_(spec) {
    stride_[0] = 1;
    for (int d = 0; d < dim; ++d) {
      nodes_[d] = spec.cells[static_cast<std::size_t>(d)] + 1 + 2 * ghosts;
      stride_[d + 1] = stride_[d] * nodes_[d];
    }
  }

  double h() const { return spec_.h; }
  bool axisymmetric() const { return spec_.axisymmetric; }
  int cells(int d) const { return spec_.cells[static_cast<std::size_t>(d)]; }
  Wall wall(int d, int side) const { return spec_.walls[static_cast<std::size_t>(d)][static_cast<std::size_t>(side)]; }
  int nodes(int d) const { return nodes_[d]; }
  int stride(int d) const { return stride_[d]; }  // steps in the flat arrays from a node to the next along d
  int row_length() const { return nodes_[0]; }
  int node_count() const { return stride_[dim]; }
  int rows() const { return node_count() / row_length(); }
  // Index along d of a node of the flat arrays.
  int index(int node, int d) const { return node / stride_[d] % nodes_[d]; }
  // Index along d >= 1 of a row.
  int row_index(int row, int d) const { return index(row * row_length(), d); }

  // Position in cells from the lowest node line.
  double logical(double x, int d) const { return (x - origin(d)) / spec_.h; }
  double origin(int d) const { return spec_.origin[static_cast<std::size_t>(d)]; }
  // Position of node line `index` (ghosts counted) of direction d.
  double line(int index, int d) const { return origin(d) + spec_.h * (index - ghosts); }
  Vec position(int node) const {
    Vec x;
    for (int d = 0; d < dim; ++d) x[d] = line(index(node, d), d);
    return x;
  }

 private:
  GridSpec spec_;
  int nodes_[dim], stride_[dim + 1];
};

}  // namespace plumbline
