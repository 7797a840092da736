// What bodies of different materials that share nodes give each other, and what membranes do beside moving with the grid.
#pragma once

#include <algorithm>
#include <cmath>

#include "kernel/engine/mechanics.hpp"

namespace plumbline {

// Whether what the body loses goes to gas. [Coupling 1]
template <class G>
bool Mechanics<G>::hands_over(std::size_t b) const {
  return scene_.loss_to_gas && options_.keep_loss && mixed(field_of(b)) && !scene_.bodies[b].material->takes_heat();
}

// L_i = sum_p (loss_p + kept_p) N_ip of the bodies without an energy equation, then L_i / G_i, G_i the mass of gas. What
// falls on nodes without gas the point keeps until there is some: kept_p = (loss_p + kept_p) sum_{i: G_i = 0} N_ip.
// [Coupling 1]
template <class G>
void Mechanics<G>::hand_loss_over() {
  bool any = false;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    if (!hands_over(b)) continue;
    Field& field = field_of(b);
    if (!any) {
      for (Field& each : fields_) {
        if (mixed(each)) each.for_touched(grid_, [&](std::size_t i) { each.loss[i] = 0; });
      }
    }
    any = true;
    Body& body = scene_.bodies[b];
    const Weights<dim>& at = located_[b].weights;
    const double* loss = body.points(column::transfer_loss);
    double* waiting = body.points(column::kept_loss);
    std::vector<double> bare(field.gas_mass.size()),
        without_gas(static_cast<std::size_t>(body.points.points() + lanes));
    field.for_touched(grid_, [&](std::size_t i) { bare[i] = field.gas_mass[i] > least_mass ? 0.0 : 1.0; });
    const typename Loops::Spread all[] = {{waiting, nullptr, field.loss.data(), 1}};
    const typename Loops::Gather rest[] = {{bare.data(), 1, without_gas.data()}};
    for (int p = 0; p < body.points.points(); ++p) waiting[p] += loss[p];
    for_chunks_writing_nodes(at.bins, options_.threads, [&](const Chunk& chunk) {
      loops_->spread(body.points, at, chunk, all);
      loops_->gather(body.points, at, chunk, rest);
    });
    for (int p = 0; p < body.points.points(); ++p) waiting[p] *= without_gas[static_cast<std::size_t>(p)];
  }
  if (!any) return;
  for (Field& field : fields_) {
    if (!mixed(field)) continue;
    walls_.fold_even(field, field.loss);
    field.for_touched(grid_, [&](std::size_t i) {
      field.loss[i] = field.gas_mass[i] > least_mass ? field.loss[i] / field.gas_mass[i] : 0.0;
    });
    walls_.extend_even(field, field.loss);
  }
}

// Adds to what a gas point lost itself its share of what others lost at its nodes, m_p sum_i N_ip L_i / G_i.
template <class G>
void Mechanics<G>::take_loss(std::size_t b) {
  const Field& field = field_of(b);
  if (!scene_.loss_to_gas || !mixed(field)) return;
  Body& body = scene_.bodies[b];
  const Weights<dim>& at = located_[b].weights;
  const double* mass = body.points(column::mass);
  double* loss = body.points(column::transfer_loss);
  std::vector<double> share(static_cast<std::size_t>(body.points.points() + lanes));
  const typename Loops::Gather shares[] = {{field.loss.data(), 1, share.data()}};
  for_chunks(at.bins, options_.threads, [&](const Chunk& chunk) {
    loops_->gather(body.points, at, chunk, shares);
    for (int p = chunk.first; p < chunk.last; ++p) loss[p] += mass[p] * share[static_cast<std::size_t>(p)];
  });
}

// Points of a chain among each other have motions that no node sees and no force stops. Each step they go
//   dx_p = theta tau (F_p / m_p - sum_i N_ip A_i),  A_i = sum_p F_p N_ip / sum_p m_p N_ip,  tau = 1 / w^2 of the fastest,
// towards the rest of that part of their forces, which releases elastic energy: under m the map to the nodes and back is
// symmetric with eigenvalues from 0 to 1. Centre of mass and momentum stay; points on walls stay on them. [Coupling 2]
template <class G>
void Mechanics<G>::relax_chain(std::size_t b, MotionSums& sums) {
  Body& body = scene_.bodies[b];
  if (!body.chain || !(scene_.chain_relaxation > 0)) return;
  const double tau = scene_.chain_relaxation * body.material->point_forces(body.points, chain_force_);
  if (!(tau > 0)) return;
  const int n = body.points.points();
  chain_force_.resize(static_cast<std::size_t>(dim * n + lanes));
  chain_shift_.resize(static_cast<std::size_t>(dim * n + lanes));
  if (!own_field_) own_field_.emplace(grid_);
  Field& field = *own_field_;
  const Weights<dim>& at = located_[b].weights;
  touch_alone(at, field);
  field.for_touched(grid_, [&](std::size_t i) { field.force[i].setZero(); });
  const double* mass = body.points(column::mass);
  std::array<typename Loops::Spread, 1 + dim> to_nodes{{{mass, nullptr, field.mass.data(), 1}}};
  std::array<typename Loops::Gather, dim> to_points;
  for (int d = 0; d < dim; ++d) {
    const auto k = static_cast<std::size_t>(d);
    to_nodes[1 + k] = {chain_force_.data() + d * n, nullptr, component(field.force, d), dim};
    to_points[k] = {component(field.end, d), dim, chain_shift_.data() + d * n};
  }
  for_chunks_writing_nodes(at.bins, options_.threads,
                           [&](const Chunk& chunk) { loops_->spread(body.points, at, chunk, to_nodes); });
  walls_.fold_mass(field);
  walls_.fold(field, field.force);
  field.for_touched(grid_, [&](std::size_t i) {
    field.end[i] = field.mass[i] > least_mass ? Vec(field.force[i] / field.mass[i]) : Vec(Vec::Zero());
  });
  walls_.extend(field, field.end);
  for_chunks(at.bins, options_.threads, [&](const Chunk& chunk) { loops_->gather(body.points, at, chunk, to_points); });
  for (int k = 0; k < dim * n; ++k) {
    const auto at_k = static_cast<std::size_t>(k);
    chain_shift_[at_k] = tau * (chain_force_[at_k] / mass[k % n] - chain_shift_[at_k]);
  }
  shift_chain(body, sums);
}

template <class G>
void Mechanics<G>::shift_chain(Body& body, MotionSums& sums) const {
  const int n = body.points.points();
  const double* mass = body.points(column::mass);
  double *position[dim], *velocity[dim];
  for (int d = 0; d < dim; ++d) {
    position[d] = body.points(column::position, d);
    velocity[d] = body.points(column::velocity, d);
  }
  for (int p = 0; p < n; ++p) {
    double step[dim];
    for (int d = 0; d < dim; ++d) step[d] = chain_shift_[static_cast<std::size_t>(d * n + p)];
    for (int d = 0; d < dim; ++d) {
      const double cells = grid_.logical(position[d][p], d);
      for (int side = 0; side < 2; ++side) {
        if (grid_.wall(d, side) == Wall::free || std::abs(cells - side * grid_.cells(d)) > on_side) continue;
        for (int e = 0; e < dim; ++e) {
          if (e == d || grid_.wall(d, side) == Wall::no_slip) step[e] = 0;
        }
      }
    }
    for (int d = 0; d < dim; ++d) position[d][p] += step[d];  // [Coupling 2]
    for (int k = 0; k < rotations; ++k) {
      const int a = rotation_axis<dim>(k, 0), c = rotation_axis<dim>(k, 1);
      sums.moved[about + static_cast<std::size_t>(k)] += mass[p] *
                                                         (step[a] * velocity[c][p] - step[c] * velocity[a][p]);
    }
  }
}

// Strains that points carry themselves have modes, too, that no node sees, and nothing stops them:
//   eps_p += min(1, kappa dt c / h) (sum_i N_ip eps_i - eps_p),  eps_i = sum_p m_p eps_p N_ip / sum_p m_p N_ip.
// What that stores or releases is booked, and goes where the other losses go. [Coupling 3]
template <class G>
void Mechanics<G>::smooth_strain(std::size_t b, double dt) {
  Body& body = scene_.bodies[b];
  if (!body.chain || !(scene_.strain_smoothing > 0) || body.material->measure() == StressMeasure::point_force) return;
  if (!own_field_) own_field_.emplace(grid_);
  Field& field = *own_field_;
  const Weights<dim>& at = located_[b].weights;
  touch_alone(at, field);
  field.for_touched(grid_, [&](std::size_t i) { field.heat[i] = 0; });
  const double *mass = body.points(column::mass), *strain = body.points(column::strain);
  const typename Loops::Spread to_nodes[] = {{mass, nullptr, field.mass.data(), 1},
                                             {strain, mass, field.heat.data(), 1}};
  for_chunks_writing_nodes(at.bins, options_.threads,
                           [&](const Chunk& chunk) { loops_->spread(body.points, at, chunk, to_nodes); });
  walls_.fold_mass(field);
  walls_.fold_even(field, field.heat);
  field.for_touched(
      grid_, [&](std::size_t i) { field.heat[i] = field.mass[i] > least_mass ? field.heat[i] / field.mass[i] : 0.0; });
  walls_.extend_even(field, field.heat);
  const StepBounds bounds = body.material->step_bounds(body.points, all_points(body.points), dim);
  const double share = std::min(1.0, scene_.strain_smoothing * dt * bounds.fastest / grid_.h());
  chain_shift_.assign(static_cast<std::size_t>(body.points.points() + lanes), 0.0);
  const typename Loops::Gather to_points[] = {{field.heat.data(), 1, chain_shift_.data()}};
  for_chunks(at.bins, options_.threads, [&](const Chunk& chunk) { loops_->gather(body.points, at, chunk, to_points); });
  for (int p = 0; p < body.points.points(); ++p) {
    double& next = chain_shift_[static_cast<std::size_t>(p)];
    next = strain[p] + share * (next - strain[p]);  // [Coupling 3]
  }
  ledger_.energy.book(Flow::constitutive, body.material->set_strain(body.points, chain_shift_));
}

}  // namespace plumbline
