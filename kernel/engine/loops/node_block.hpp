// A square block of nodes that the points of one bin reach, whatever its size: nodal values in, sums of packs out.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "kernel/pack.hpp"

namespace plumbline {

// side: nodes in each direction.
template <int side>
struct NodeBlock {
  static constexpr int nodes = side * side;

  int lowest;      // node in the flat arrays
  double x, y;     // its indices, ghosts counted
  int row_length;  // from a node to the one above it
  int reach;       // nodes in each direction that the grid has: fewer than `side` on a small grid

  // visit(k, i): the k-th node of the block, row by row, is the i-th of the flat arrays.
  template <class Visit>
  [[gnu::always_inline]] inline void for_nodes(Visit&& visit) const {
    for (int b = 0; b < along(); ++b) {
      for (int a = 0; a < along(); ++a) visit(a + side * b, static_cast<std::size_t>(lowest + a + b * row_length));
    }
  }
  int middle() const { return lowest + along() / 2 * (1 + row_length); }
  // Adds the lanes of so many sums a node to as many values a node.
  template <int components>
  [[gnu::always_inline]] inline void add_to_nodes(const Pack (&sums)[nodes * components], double* values) const {
    if (along() == side) {
#pragma GCC unroll 6
      for (int b = 0; b < side; ++b)
        add_lane_sums<side * components>(sums + b * side * components, values + (lowest + b * row_length) * components);
      return;
    }
    for_nodes([&](int k, std::size_t i) { add_lane_sums<components>(sums + k * components, values + i * components); });
  }

 private:
  int along() const { return side > 4 ? reach : side; }  // no grid has fewer than four nodes in a direction
};

// Nodal velocities of a block relative to its middle node's, because what the maps lose is a difference of squares; a node at
// the edge of what points reach could be all but massless and fast.
template <int side>
struct BlockVelocity {
  double base[2], u[NodeBlock<side>::nodes][2], square[NodeBlock<side>::nodes];

  BlockVelocity() = default;
  [[gnu::always_inline]] inline BlockVelocity(const NodeBlock<side>& block,
                                              const std::vector<Eigen::Vector2d>& velocity) {
    if (block.reach < side) *this = {};  // what the grid lacks counts nothing
    const Eigen::Vector2d& middle = velocity[static_cast<std::size_t>(block.middle())];
    for (int d = 0; d < 2; ++d) base[d] = middle[d];
    block.for_nodes([&](int k, std::size_t i) {
      for (int d = 0; d < 2; ++d) u[k][d] = velocity[i][d] - base[d];
      square[k] = u[k][0] * u[k][0] + u[k][1] * u[k][1];
    });
  }
};

}  // namespace plumbline
