// The ledger: mass, momentum, angular momentum and energy of a run. Identity, for each quantity and step:
//   stores(now) - stores(initial) = sum of flows + residual.
// Stores are summed from the points alone; flows are booked by their own local formulas where they arise.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/summation.hpp"

namespace plumbline {

// Flows, positive into the system.
//   walls         impulse of walls
//   body_force    dt sum_i M_i b . vm_i; for momentum dt sum_i M_i b
//   contact       between velocity fields; of energy the work of friction, which leaves, and what a law adds of its own
//   transfer      what the maps between points and grid lose
//   constitutive  energy stored beyond the stress power: V (W(eps + deps) - W(eps) - sigma : deps)
//   integration   dt sum_p V_p sigma_p : (strain rate used - grad vm(x_p)); for angular momentum what moving points add
//   released      carried by points that leave
enum class Flow { walls, body_force, contact, transfer, constitutive, integration, released };
inline constexpr int flow_count = 7;
inline constexpr std::array<std::string_view, flow_count> flow_names{
    "walls", "body_force", "contact", "transfer", "constitutive", "integration", "released"};

// One quantity's account.
class Account {
 public:
  void open(double store, double scale);
  void book(Flow flow, double amount) {
    flows_[static_cast<std::size_t>(flow)].add(amount);
    booked_ += amount < 0 ? -amount : amount;
  }
  // Closes a step: `store` and `scale` as they are now.
  void close(double store, double scale);

  double initial() const { return initial_; }
  double store() const { return store_; }
  double flow(Flow flow) const { return flows_[static_cast<std::size_t>(flow)].value(); }
  double residual() const { return residual_; }
  double largest_residual() const { return largest_residual_; }  // in magnitude, over all closed steps
  double scale() const { return scale_; }                        // largest so far
  double booked() const { return booked_; }                      // sum of |amounts|
  // largest |residual| / scale, with |booked amounts| added to the scale if `with_booked`.
  double relative_drift(bool with_booked) const;

 private:
  double initial_ = 0, store_ = 0, residual_ = 0, largest_residual_ = 0, scale_ = 0, booked_ = 0;
  std::array<RunningSum, flow_count> flows_;
};

struct EnergyStores {
  double kinetic = 0;  // affine part included
  double internal = 0;
  double elastic = 0;
  double total() const { return kinetic + internal + elastic; }
};

// Everything summed over the points at one instant.
struct Totals {
  double mass = 0;
  double grid_mass = 0;  // sum_i M_i of the last map
  std::array<double, 3> momentum{0, 0, 0};
  double momentum_scale = 0;                        // sum m |v|
  std::array<double, 3> angular_momentum{0, 0, 0};  // about x, y, z; in the plane about z alone
  double angular_scale = 0;                         // sum m |x| |v|
  EnergyStores energy;
  Totals& operator+=(const Totals& o);  // but for grid_mass
};

struct Ledger {
  Account mass;
  std::array<Account, 3> momentum;
  std::array<Account, 3> angular_momentum;  // about x, y, z; in the plane about z alone
  Account energy;
  EnergyStores initial_stores, stores;
  double viscous = 0;  // memo: heat by physical and artificial viscosity, part of the internal energy, J

  void open(const Totals& totals);
  void close_step(const Totals& totals);

  // The accounts that a scene has, by name: mass, momentum_x ..., angular_momentum (in space _x, _y, _z), energy.
  // An axisymmetric scene without swirl has no angular momentum of its own.
  std::vector<std::pair<std::string, const Account*>> accounts(int dim, bool axisymmetric) const;
};

}  // namespace plumbline
