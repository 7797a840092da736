// What bodies of different materials that share nodes give each other, and what membranes do beside moving with the grid.
#pragma once

#include <algorithm>
#include <cmath>

#include "kernel/engine/chunks.hpp"

namespace plumbline {

// Whether what the body loses goes to gas. [Coupling 1]
template <class G, class S, class T>
bool Mechanics<G, S, T>::hands_over(std::size_t b) const {
  return scene_.loss_to_gas && options_.keep_loss && mixed(field_of(b)) && !scene_.bodies[b].material->takes_heat();
}

// L_i = sum_p (loss_p + kept_p) N_ip of the bodies without an energy equation, then L_i / G_i, G_i the mass of gas. What
// falls on nodes without gas the point keeps until there is some: kept_p = (loss_p + kept_p) sum_{i: G_i = 0} N_ip.
// [Coupling 1]
template <class G, class S, class T>
void Mechanics<G, S, T>::hand_loss_over() {
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
    const Places places = this->places(body, located_[b]);
    const double* loss = body.points(column::transfer_loss);
    double* waiting = body.points(column::kept_loss);
    for_chunks_writing_nodes(located_[b], [&](const Chunk& chunk) {
      for_bins(located_[b].bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
        Pack sums[nodes];
        double bare[nodes];
        for_stencil_nodes(print, [&](int k, std::size_t i) { bare[k] = field.gas_mass[i] > least_mass ? 0.0 : 1.0; });
        for (Pack& s : sums) s = 0.0;
        for_packs(first, last, [&](int p, int count) {
          const PackStencil weights = stencil(places, anchor, p);
          const Pack all = load(loss + p) + load(waiting + p);
          weights.spread(kept(all, count), sums, 1);
          store(waiting + p, all * weights.gather_array([&](int k) { return bare[k]; }).value, count);
        });
        add_to_nodes<1>(print, sums, [&](std::size_t i, const double* total) { field.loss[i] += total[0]; });
      });
    });
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
template <class G, class S, class T>
void Mechanics<G, S, T>::take_loss(std::size_t b) {
  const Field& field = field_of(b);
  if (!scene_.loss_to_gas || !mixed(field)) return;
  Body& body = scene_.bodies[b];
  const Places places = this->places(body, located_[b]);
  const double* mass = body.points(column::mass);
  double* loss = body.points(column::transfer_loss);
  for_chunks(located_[b], [&](const Chunk& chunk) {
    for_bins(located_[b].bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
      double share[nodes], most = 0;
      for_stencil_nodes(print, [&](int k, std::size_t i) {
        share[k] = field.loss[i];
        most = std::max(most, std::abs(share[k]));
      });
      if (most == 0) return;
      for_packs(first, last, [&](int p, int count) {
        const PackStencil weights = stencil(places, anchor, p);
        const Pack taken = load(mass + p) * weights.gather_array([&](int k) { return share[k]; }).value;
        store(loss + p, load(loss + p) + taken, count);
      });
    });
  });
}

// Points of a chain among each other have motions that no node sees and no force stops. Each step they go
//   dx_p = theta tau (F_p / m_p - sum_i N_ip A_i),  A_i = sum_p F_p N_ip / sum_p m_p N_ip,  tau = 1 / w^2 of the fastest,
// towards the rest of that part of their forces, which releases elastic energy: under m the map to the nodes and back is
// symmetric with eigenvalues from 0 to 1. Centre of mass and momentum stay; points on walls stay on them. [Coupling 2]
template <class G, class S, class T>
void Mechanics<G, S, T>::relax_chain(std::size_t b, MotionSums& sums) {
  Body& body = scene_.bodies[b];
  if (!body.chain || !(scene_.chain_relaxation > 0)) return;
  const double tau = scene_.chain_relaxation * body.material->point_forces(body.points, chain_force_);
  if (!(tau > 0)) return;
  const int n = body.points.points();
  chain_force_.resize(static_cast<std::size_t>(dim * n + lanes));
  chain_shift_.resize(static_cast<std::size_t>(dim * n + lanes));
  if (!own_field_) own_field_.emplace(grid_);
  Field& field = *own_field_;
  Located& at = located_[b];
  touch_alone(at, field);
  field.for_touched(grid_, [&](std::size_t i) { field.force[i].setZero(); });
  const Places places = this->places(body, at);
  const double* mass = body.points(column::mass);
  for_chunks_writing_nodes(at, [&](const Chunk& chunk) {
    for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
      constexpr int parts = 1 + dim;
      Pack node_sums[nodes * parts];
      for (Pack& s : node_sums) s = 0.0;
      for_packs(first, last, [&](int p, int count) {
        const PackStencil weights = stencil(places, anchor, p);
        weights.spread(kept(load(mass + p), count), node_sums, parts);
        for (int d = 0; d < dim; ++d) {
          weights.spread(kept(load(chain_force_.data() + d * n + p), count), node_sums + 1 + d, parts);
        }
      });
      add_to_nodes<parts>(print, node_sums, [&](std::size_t i, const double* total) {
        field.mass[i] += total[0];
        for (int d = 0; d < dim; ++d) field.force[i][d] += total[1 + d];
      });
    });
  });
  walls_.fold_mass(field);
  walls_.fold(field, field.force);
  field.for_touched(grid_, [&](std::size_t i) {
    field.end[i] = field.mass[i] > least_mass ? Vec(field.force[i] / field.mass[i]) : Vec(Vec::Zero());
  });
  walls_.extend(field, field.end);
  for_chunks(at, [&](const Chunk& chunk) {
    for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
      double seen[nodes][dim];
      for_stencil_nodes(print, [&](int k, std::size_t i) {
        for (int d = 0; d < dim; ++d) seen[k][d] = field.end[i][d];
      });
      for_packs(first, last, [&](int p, int count) {
        const PackStencil weights = stencil(places, anchor, p);
        for (int d = 0; d < dim; ++d) {
          const Pack own = load(chain_force_.data() + d * n + p) / load(mass + p);
          const Pack smooth = weights.gather_array([&](int k) { return seen[k][d]; }).value;
          store(chain_shift_.data() + d * n + p, tau * (own - smooth), count);
        }
      });
    });
  });
  shift_chain(body, sums);
}

template <class G, class S, class T>
void Mechanics<G, S, T>::shift_chain(Body& body, MotionSums& sums) const {
  const int n = body.points.points();
  const std::size_t about = dim == 2 ? 2 : 0;
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
template <class G, class S, class T>
void Mechanics<G, S, T>::smooth_strain(std::size_t b, double dt) {
  Body& body = scene_.bodies[b];
  if (!body.chain || !(scene_.strain_smoothing > 0) || body.material->measure() == StressMeasure::point_force) return;
  if (!own_field_) own_field_.emplace(grid_);
  Field& field = *own_field_;
  Located& at = located_[b];
  touch_alone(at, field);
  field.for_touched(grid_, [&](std::size_t i) { field.heat[i] = 0; });
  const Places places = this->places(body, at);
  const double *mass = body.points(column::mass), *strain = body.points(column::strain);
  for_chunks_writing_nodes(at, [&](const Chunk& chunk) {
    for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
      Pack sums[nodes * 2];
      for (Pack& s : sums) s = 0.0;
      for_packs(first, last, [&](int p, int count) {
        const PackStencil weights = stencil(places, anchor, p);
        const Pack m = kept(load(mass + p), count);
        weights.spread(m, sums, 2);
        weights.spread(m * load(strain + p), sums + 1, 2);
      });
      add_to_nodes<2>(print, sums, [&](std::size_t i, const double* total) {
        field.mass[i] += total[0];
        field.heat[i] += total[1];
      });
    });
  });
  walls_.fold_mass(field);
  walls_.fold_even(field, field.heat);
  field.for_touched(
      grid_, [&](std::size_t i) { field.heat[i] = field.mass[i] > least_mass ? field.heat[i] / field.mass[i] : 0.0; });
  walls_.extend_even(field, field.heat);
  const StepBounds bounds = body.material->step_bounds(body.points, all_points(body.points), dim);
  const double share = std::min(1.0, scene_.strain_smoothing * dt * bounds.fastest / grid_.h());
  chain_shift_.assign(static_cast<std::size_t>(body.points.points() + lanes), 0.0);
  for_chunks(at, [&](const Chunk& chunk) {
    for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
      double seen[nodes];
      for_stencil_nodes(print, [&](int k, std::size_t i) { seen[k] = field.heat[i]; });
      for_packs(first, last, [&](int p, int count) {
        const Pack smooth = stencil(places, anchor, p).gather_array([&](int k) { return seen[k]; }).value;
        const Pack own = load(strain + p);
        store(chain_shift_.data() + p, own + share * (smooth - own), count);  // [Coupling 3]
      });
    });
  });
  ledger_.energy.book(Flow::constitutive, body.material->set_strain(body.points, chain_shift_));
}

}  // namespace plumbline
