// Planes that move through the grid with given velocities and drive the nodes behind them.
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

  // Gives driven nodes the normal velocity that the pistons have dt from now. Adds the impulse to `action`; returns its work, J,
  // over the mean of the pistons' velocities now and then, with which nodes move that had the first. Walls' ghosts are to be
  // extended afterwards.
  double drive(const Grid<dim>& grid, const VelocityField<dim>& field, std::vector<Vec>& velocity,
               WallAction<dim>& action, double dt) const {
    double work = 0;
    for_driven(grid, field, [&](std::size_t i, const Piston& piston) {
      const int d = piston.direction;
      const double then = piston.velocity_at(time_ + dt);
      Vec impulse = Vec::Zero();
      impulse[d] = field.mass[i] * (then - velocity[i][d]);
      velocity[i][d] = then;
      action.linear += impulse;
      action.angular += cross<dim>(grid.position(static_cast<int>(i)), impulse);
      work += impulse[d] * mean_velocity(piston, dt);
    });
    return work;
  }

  // Gives them that mean.
  void drive_midpoint(const Grid<dim>& grid, const VelocityField<dim>& field, std::vector<Vec>& velocity,
                      double dt) const {
    for_driven(grid, field,
               [&](std::size_t i, const Piston& piston) { velocity[i][piston.direction] = mean_velocity(piston, dt); });
  }

  // visit(node, piston) for each touched node that a piston drives.
  template <class Visit>
  void for_driven(const Grid<dim>& grid, const VelocityField<dim>& field, Visit&& visit) const {
    for (const Piston& piston : pistons_) {
      const int d = piston.direction;
      const double reach = piston.place_at(time_) + (piston.side == 0 ? 0.5 : -0.5) * grid.h();
      field.for_touched(grid, [&](std::size_t i) {
        const double x = grid.line(grid.index(static_cast<int>(i), d), d);
        if (piston.side == 0 ? x >= reach : x <= reach) return;
        if (!held(grid, static_cast<int>(i), d)) visit(i, piston);
      });
    }
  }

 private:
  double mean_velocity(const Piston& piston, double dt) const {
    return 0.5 * (piston.velocity_at(time_) + piston.velocity_at(time_ + dt));
  }

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
