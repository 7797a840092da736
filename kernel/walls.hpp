// Walls by mirror images. What points put on a ghost node is folded back to its mirror node after a map to the grid,
// and ghost nodes are given the mirrored velocity before a map back, so that no stencil is ever truncated. A node on a
// wall is its own mirror and loses its odd components. [EC-APIC walls]
#pragma once

#include "kernel/rotations.hpp"
#include "kernel/velocity_field.hpp"

namespace plumbline {

// What the walls gave to the nodes they acted on: sum of the changes, and of x cross the changes.
template <int dim>
struct WallAction {
  Eigen::Matrix<double, dim, 1> linear = Eigen::Matrix<double, dim, 1>::Zero();
  Spin<dim> angular = Spin<dim>::Zero();
  WallAction operator+(const WallAction& o) const { return {linear + o.linear, angular + o.angular}; }
};

template <int dim>
class Walls {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  explicit Walls(const Grid<dim>& grid) : grid_(grid) {}

  // Widens the touched rows so that the mirror node of each touched ghost node is touched too.
  void include_mirrors(std::vector<std::pair<int, int>>& touched) const;

  // Adds the ghosts' mass to their mirror nodes; the ghosts keep theirs for the impulse of the map back.
  void fold_mass(VelocityField<dim>& field) const;

  // The same for sums of a scalar.
  void fold_even(const VelocityField<dim>& field, std::vector<double>& values) const;

  // Folds momenta or forces with the signs of velocity and removes what a wall node may not have.
  WallAction<dim> fold(const VelocityField<dim>& field, std::vector<Vec>& values) const;

  // Sets wall nodes' odd components to zero and ghosts to the mirrored value.
  void extend(const VelocityField<dim>& field, std::vector<Vec>& velocity) const;

  // Ghost nodes take the mirror node's density: a scalar is even.
  void extend_even(const VelocityField<dim>& field, std::vector<double>& values) const;

  // Ghosts of the velocities of the faces above the nodes and of how fast cells stretch along each axis: a velocity along the
  // normal is odd, all else even. [Pressure 2]
  void extend_flow(const VelocityField<dim>& field, std::vector<Vec>& faces, std::vector<Vec>& stretch) const;

  // Momentum that the walls give to the points in a map back with the extended velocities u:
  // sum over ghosts of M_g (u_g - u_mirror).
  WallAction<dim> extension_impulse(const VelocityField<dim>& field, const std::vector<Vec>& u) const;

 private:
  // Calls visit(node, mirror, d, no_slip) for each touched ghost node of direction d, and wall(node, d, no_slip) for
  // each touched wall node.
  template <class Ghost, class OnWall>
  void for_walls(const VelocityField<dim>& field, int d, Ghost&& ghost, OnWall&& wall) const;

  bool ghost_of_lower(int row, int d) const;

  Grid<dim> grid_;
};

extern template class Walls<1>;
extern template class Walls<2>;
extern template class Walls<3>;

}  // namespace plumbline
