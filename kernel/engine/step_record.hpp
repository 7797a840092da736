// What is known of the step under way, from locate_points() on: a value that stages pass on. What they exchanged ends in the
// ledger; of advance_momentum and the maps the last call counts.
#pragma once

#include <optional>
#include <vector>

#include "kernel/contact/pair_friction.hpp"
#include "kernel/engine/sums.hpp"
#include "kernel/stages.hpp"
#include "kernel/walls.hpp"

namespace plumbline {

// Impulses, their moments, N s and N m s, and a work, J.
template <int dim>
struct Exchange {
  Eigen::Matrix<double, dim, 1> linear = Eigen::Matrix<double, dim, 1>::Zero();
  Spin<dim> angular = Spin<dim>::Zero();
  double work = 0;
};

// Forces on the nodes beside what their fields hold.
template <int dim>
struct MappedForces {
  double hoop = 0;  // what hoop stress adds to the radial momentum, N
  Eigen::Matrix<double, dim, 1> clamp = Eigen::Matrix<double, dim, 1>::Zero();  // by clamped edges, N
  Spin<dim> turn = Spin<dim>::Zero();                                           // torque that should be none, N m
  std::vector<PressedPair<dim>> pressed;                                        // that rub
};

// Strain before the forces are known: its stress power is booked with the stress that the forces use.
struct EarlyStrain {
  double dt = 0, stored = 0;  // s, J
};

// Of one advance of the nodal momenta over dt.
template <int dim>
struct AdvanceRecord {
  WallAction<dim> wall;
  Exchange<dim> body, contact;
  Spin<dim> turn = Spin<dim>::Zero();  // by stresses of another instant than the points' places
  double wall_work = 0, dt = 0;
};

// Times of a step, s.
struct StepClock {
  double start = 0;    // of the step
  double drifted = 0;  // how long after it points stand by drift_points() alone
};

template <int dim, int rotations>
struct StepRecord {
  double grid_mass = 0;      // on the nodes, kg
  WallAction<dim> map_wall;  // of the map to the nodes
  double map_wall_work = 0;
  std::optional<double> map_loss = 0;           // J; none: not summed yet
  std::optional<MappedForces<dim>> forces;      // none: not mapped
  std::optional<AdvanceRecord<dim>> advance;    // none: not advanced
  std::optional<PowerSums> power;               // of the forces that `advance` used; none: not summed yet
  Spin<dim> filter_turn = Spin<dim>::Zero();    // by filtered velocities
  EarlyStrain early;                            // not booked yet
  NodalVelocity newest = NodalVelocity::start;  // the velocity that NodalVelocity::current means
  std::optional<NodalVelocity> rates_of;        // velocity whose strain rates the points hold
  double stress_ahead = 0;                      // how long after the step's start the stresses are those of, s

  // Nothing is known of the next step yet, but for the mass on the nodes until the next map.
  void begin() {
    const double mapped = grid_mass;
    *this = {};
    grid_mass = mapped;
  }
  bool wants_power() const { return advance && !power; }
  NodalVelocity resolved(NodalVelocity which) const { return which == NodalVelocity::current ? newest : which; }

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
