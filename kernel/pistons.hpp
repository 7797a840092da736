// Planes that move through the grid with a given velocity and drive the nodes behind them.
#pragma once

#include <vector>

#include "kernel/scene.hpp"
#include "kernel/walls.hpp"

namespace plumbline {

template <int dim>
class Pistons {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;

  explicit Pistons(const Scene& scene) : pistons_(scene.pistons) {}

  bool none() const { return pistons_.empty(); }
  void advance(double dt) { time_ += dt; }
  void set_time(double time) { time_ = time; }

  // Gives driven nodes the pistons' normal velocity. Adds the impulse to `action`; returns its work, J. Walls' ghosts are to
  // be extended afterwards.
  double drive(const Grid<dim>& grid, const VelocityField<dim>& field, std::vector<Vec>& velocity,
               WallAction<dim>& action) const {
    double work = 0;
    for_driven(grid, field, [&](std::size_t i, const Piston& piston) {
      const int d = piston.direction;
      Vec impulse = Vec::Zero();
      impulse[d] = field.mass[i] * (piston.velocity - velocity[i][d]);
      velocity[i][d] = piston.velocity;
      action.linear += impulse;
      action.angular += cross<dim>(grid.position(static_cast<int>(i)), impulse);
      work += impulse[d] * piston.velocity;
    });
    return work;
  }

  // visit(node, piston) for each touched node that a piston drives.
  template <class Visit>
  void for_driven(const Grid<dim>& grid, const VelocityField<dim>& field, Visit&& visit) const {
    for (const Piston& piston : pistons_) {
      const int d = piston.direction;
      const double reach = piston.position + piston.velocity * time_ + (piston.side == 0 ? 0.5 : -0.5) * grid.h();
      field.for_touched(grid, [&](std::size_t i) {
        const double x = grid.line(grid.index(static_cast<int>(i), d), d);
        if (piston.side == 0 ? x >= reach : x <= reach) return;
        if (!held(grid, static_cast<int>(i), d)) visit(i, piston);
      });
    }
  }

 private:
  // Ghosts of walls have given their mass to their mirrors, and nodes on walls do not move along what the wall holds.
  static bool held(const Grid<dim>& grid, int node, int direction) {
    for (int d = 0; d < dim; ++d) {
      const int k = grid.index(node, d), first = Grid<dim>::ghosts, last = grid.nodes(d) - 1 - Grid<dim>::ghosts;
      for (int side = 0; side < 2; ++side) {
        const Wall wall = grid.wall(d, side);
        if (wall == Wall::free) continue;
        const bool holds = wall == Wall::no_slip || d == direction;
        if (side == 0 ? k < first + holds : k > last - holds) return true;
      }
    }
    return false;
  }

  std::vector<Piston> pistons_;
  double time_ = 0;  // s, since the pistons stood where the scene put them
};

}  // namespace plumbline
