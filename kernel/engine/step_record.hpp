// What the step under way exchanged, until it is booked: of advance_momentum and the maps the last call counts.
#pragma once

#include <optional>

#include "kernel/engine/sums.hpp"
#include "kernel/walls.hpp"

namespace plumbline {

// Impulses, their moments, N s and N m s, and a work, J.
template <int dim>
struct Exchange {
  Eigen::Matrix<double, dim, 1> linear = Eigen::Matrix<double, dim, 1>::Zero();
  Spin<dim> angular = Spin<dim>::Zero();
  double work = 0;
};

// Of one advance of the nodal momenta over dt.
template <int dim>
struct AdvanceRecord {
  WallAction<dim> wall;
  Exchange<dim> body, contact;
  Spin<dim> turn = Spin<dim>::Zero();  // by stresses of another instant than the points' places
  double wall_work = 0, dt = 0;
};

template <int dim, int rotations>
struct StepRecord {
  WallAction<dim> map_wall;  // of the map to the nodes
  double map_wall_work = 0;
  std::optional<double> map_loss = 0;  // J; none: not summed yet
  std::optional<AdvanceRecord<dim>> advance;
  Spin<dim> filter_turn = Spin<dim>::Zero();
  std::optional<PowerSums> power;  // of the forces that `advance` used

  bool wants_power() const { return advance && !power; }

  // With the map's loss and the power summed.
  void book(Ledger& ledger, const MotionSums& motion, bool with_contact) const {
    const AdvanceRecord<dim> advanced = advance.value_or(AdvanceRecord<dim>{});
    for (int d = 0; d < dim; ++d) {
      const auto axis = static_cast<std::size_t>(d);
      Account& account = ledger.momentum[axis];
      account.book(Flow::walls, advanced.wall.linear[d] + map_wall.linear[d] + motion.reflected[axis]);
      account.book(Flow::body_force, advanced.body.linear[d]);
      if (with_contact) account.book(Flow::contact, advanced.contact.linear[d]);
    }
    for (int k = 0; k < rotations; ++k) {
      const std::size_t axis = (dim == 2 ? 2 : 0) + static_cast<std::size_t>(k);
      Account& account = ledger.angular_momentum[axis];
      account.book(Flow::walls, advanced.wall.angular[k] + map_wall.angular[k] + motion.reflected_turn[axis]);
      account.book(Flow::body_force, advanced.body.angular[k]);
      if (with_contact) account.book(Flow::contact, advanced.contact.angular[k]);
      account.book(Flow::transfer, filter_turn[k] - motion.torque[axis]);
      account.book(Flow::integration, motion.moved[axis] + advanced.turn[k]);
    }
    ledger.energy.book(Flow::walls, advanced.wall_work + map_wall_work);
    ledger.energy.book(Flow::body_force, advanced.body.work);
    if (with_contact) ledger.energy.book(Flow::contact, advanced.contact.work);
    ledger.energy.book(Flow::transfer, -*map_loss - motion.lost);
    ledger.energy.book(Flow::integration, -power.value_or(PowerSums{}).power);
    ledger.viscous += power.value_or(PowerSums{}).viscous;
  }
};

}  // namespace plumbline
