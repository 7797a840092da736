// Points to grid, and the momentum equation on the grid.
#pragma once

#include <stdexcept>

#include "kernel/engine/chunks.hpp"

namespace plumbline {

template <class G, class S, class T>
template <bool with_mass, bool with_momentum>
void Mechanics<G, S, T>::scatter_mass_and_momentum(const Body& body, const Located& at, const Chunk& chunk,
                                                   Field& field) const {
  const Places places = this->places(body, at);
  const double* mass = body.points(column::mass);
  const double *velocity[dim], *affine[dim][dim] = {};
  for (int d = 0; d < dim; ++d) {
    velocity[d] = body.points(column::velocity, d);
    for (int e = 0; T::affine && e < dim; ++e) affine[d][e] = body.points(column::affine, d * dim + e);
  }
  constexpr int parts = 1 + dim;
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    Pack sums[nodes * parts];
    for (Pack& s : sums) s = 0.0;
    for_packs(first, last, [&](int p, int count) {
      const PackStencil weights = stencil(places, anchor, p);
      const Pack m = kept(load(mass + p), count);
      if (with_mass) weights.spread(m, sums, parts);
      if (!with_momentum) return;
      for (int d = 0; d < dim; ++d) {
        const Pack momentum = m * load(velocity[d] + p);
        if constexpr (T::affine) {
          Pack slope[dim];
          for (int e = 0; e < dim; ++e) slope[e] = m * load(affine[d][e] + p);
          weights.spread_moment(momentum, slope, sums + 1 + d, parts);  // [EC-APIC 1]
        } else {
          weights.spread(momentum, sums + 1 + d, parts);  // [York 3.16]
        }
      }
    });
    add_to_nodes<parts>(print, sums, [&](std::size_t i, const double* total) {
      if (with_mass) field.mass[i] += total[0];
      for (int d = 0; with_momentum && d < dim; ++d) field.momentum[i][d] += total[1 + d];
    });
  });
}

template <class G, class S, class T>
void Mechanics<G, S, T>::solve_velocity(Field& field, std::vector<Vec>& velocity) const {
  field.for_touched(
      grid_,
      [&](std::size_t i) {
        velocity[i] = field.mass[i] > least_mass ? Vec(field.momentum[i] / field.mass[i]) : Vec(Vec::Zero());
      },
      options_.threads);
  walls_.extend(field, velocity);
}

// What pistons do to nodal velocities; returns their work, J.
template <class G, class S, class T>
double Mechanics<G, S, T>::drive(const Field& field, std::vector<Vec>& velocity, WallAction<dim>& action) const {
  if (pistons_.none()) return 0;
  const double work = pistons_.drive(grid_, field, velocity, action);
  walls_.extend(field, velocity);
  return work;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::map_mass_and_momentum() {
  want_places("map_mass_and_momentum");
  grid_mass_ = 0;
  pending_.map_wall = {};
  pending_.map_loss = pending_.map_wall_work = 0;
  for (Field& field : fields_) {
    field.for_touched(
        grid_,
        [&](std::size_t i) {
          field.mass[i] = 0;
          field.momentum[i].setZero();
        },
        options_.threads);
  }
  for (const bool gas : {true, false}) {  // gases first: where others share their nodes, their mass is wanted alone
    for (std::size_t b = 0; b < located_.size(); ++b) {
      if (scene_.bodies[b].material->takes_heat() != gas) continue;
      for_chunks_writing_nodes(located_[b], [&](const Chunk& chunk) {
        scatter_mass_and_momentum<true, true>(scene_.bodies[b], located_[b], chunk, field_of(b));
      });
    }
    for (Field& field : fields_) {
      if (!gas || !mixed(field)) continue;
      field.for_touched(grid_, [&](std::size_t i) { field.gas_mass[i] = field.mass[i]; });
      walls_.fold_even(field, field.gas_mass);
      walls_.extend_even(field, field.gas_mass);
    }
  }
  for (Field& field : fields_) {
    double mass = 0;
    field.for_touched(grid_, [&](std::size_t i) { mass += field.own_mass[i] = field.mass[i]; });
    grid_mass_ += mass;
    walls_.fold_mass(field);
    WallAction<dim> action = walls_.fold(field, field.momentum);
    solve_velocity(field, field.start);
    pending_.map_wall_work += drive(field, field.start, action);
    if (!transfer_.increments) {
      pending_.map_wall.linear += action.linear;
      pending_.map_wall.angular += action.angular;
    }
  }
  pending_.loss = !transfer_.increments;
  contact_decided_ = false;
  current_ = NodalVelocity::start;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::settle_loss() {
  if (!pending_.loss) return;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    pending_.map_loss += sum_over_chunks<double>(located_[b], [&](const Chunk& chunk) {
      return gather_start(scene_.bodies[b], located_[b], chunk, {.loss = &field_of(b).start});
    });
  }
  pending_.loss = false;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::map_momentum() {
  want_places("map_momentum");
  for (Field& field : fields_) field.for_touched(grid_, [&](std::size_t i) { field.momentum[i].setZero(); });
  for (std::size_t b = 0; b < located_.size(); ++b) {
    for_chunks_writing_nodes(located_[b], [&](const Chunk& chunk) {
      scatter_mass_and_momentum<false, true>(scene_.bodies[b], located_[b], chunk, field_of(b));
    });
  }
  for (Field& field : fields_) {
    walls_.fold(field, field.momentum);
    solve_velocity(field, field.remapped);  // [York 3.24]
  }
  if (contact_) contact_->apply_to_remapped(fields_);
  for (Field& field : fields_) {
    walls_.extend(field, field.remapped);
    WallAction<dim> not_kept;
    drive(field, field.remapped, not_kept);
  }
  current_ = NodalVelocity::remapped;
  if (rate_of_ == NodalVelocity::remapped) rate_of_ = NodalVelocity::current;
}

// -sum_p V_p sigma_p grad N_ip [York 3.17] [EC-APIC 4]; returns what hoop stress adds to the radial momentum, N.
// exchange: also sum_p m_p e_p N_ip and sum_p m_p N_ip max(0, -div v). [Exchange 1]
template <class G, class S, class T>
template <StressMeasure measure, bool exchange>
double Mechanics<G, S, T>::scatter_forces(const Body& body, const Located& at, const Chunk& chunk, Field& field) const {
  constexpr bool isotropic = measure == StressMeasure::pressure, full = measure == StressMeasure::full;
  constexpr int strains = stress_components(measure, dim, G::axisymmetric), normals = isotropic ? 1 : G::normals;
  constexpr int parts = dim + (exchange ? 2 : 0);
  const Places places = this->places(body, at);
  const double *volume = body.points(column::volume), *mass = body.points(column::mass);
  const double* energy = exchange ? body.points(column::energy) : nullptr;
  const double *stress[strains], *rate[strains];
  for (int k = 0; k < strains; ++k) {
    stress[k] = body.points(column::stress, k);
    rate[k] = body.points(column::strain_rate, k);
  }
  Pack hoop_force = 0.0;
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    Pack sums[nodes * parts];
    for (Pack& s : sums) s = 0.0;
    for_packs(first, last, [&](int p, int count) {
      const PackStencil weights = stencil(places, anchor, p);
      const Pack v = kept(-load(volume + p), count);
      Pack s[strains];
      for (int k = 0; k < strains; ++k) s[k] = v * load(stress[k] + p);
      if constexpr (G::axisymmetric && measure != StressMeasure::point_force) {
        const Pack hoop = kept(s[isotropic ? 0 : full ? dim * dim : 2] / load(places.x[0] + p), count);
        hoop_force += hoop;
        weights.spread(hoop, sums, parts);
      }
      if constexpr (isotropic) {
        weights.spread_divergence(s[0], sums, parts);
      } else if constexpr (measure == StressMeasure::point_force) {
        for (int d = 0; d < dim; ++d) weights.spread(s[d], sums + d, parts);
        if constexpr (G::axisymmetric)
          hoop_force += s[0];  // forces along the surface cancel; what is left is the hoops'
      } else {
        Pack flux[dim][dim];
        if constexpr (full) {
          for (int k = 0; k < dim * dim; ++k) flux[k / dim][k % dim] = s[k];
        } else {
          G::flux(s, flux);
        }
        for (int d = 0; d < dim; ++d) weights.spread_gradient(Pack(0.0), flux[d], sums + d, parts);
      }
      if constexpr (exchange) {
        const Pack m = kept(load(mass + p), count);
        Pack divergence = load(rate[0] + p);
        for (int k = 1; k < normals; ++k) divergence += load(rate[k] + p);
        weights.spread(m * load(energy + p), sums + dim, parts);
        weights.spread(m * max(-divergence, Pack(0.0)), sums + dim + 1, parts);
      }
    });
    add_to_nodes<parts>(print, sums, [&](std::size_t i, const double* total) {
      for (int d = 0; d < dim; ++d) field.force[i][d] += total[d];
      if constexpr (exchange) {
        field.heat[i] += total[dim];
        field.exchange[i] += total[dim + 1];
      }
    });
  });
  return sum(hoop_force);
}

template <class G, class S, class T>
double Mechanics<G, S, T>::scatter_forces(const Body& body, const Located& at, const Chunk& chunk, Field& field) const {
  const bool exchange = exchanges_heat(body);
  switch (body.material->measure()) {
    case StressMeasure::pressure:
      return exchange ? scatter_forces<StressMeasure::pressure, true>(body, at, chunk, field)
                      : scatter_forces<StressMeasure::pressure, false>(body, at, chunk, field);
    case StressMeasure::full:
      return scatter_forces<StressMeasure::full, false>(body, at, chunk, field);
    case StressMeasure::point_force:
      return scatter_forces<StressMeasure::point_force, false>(body, at, chunk, field);
    default:
      return exchange ? scatter_forces<StressMeasure::symmetric, true>(body, at, chunk, field)
                      : scatter_forces<StressMeasure::symmetric, false>(body, at, chunk, field);
  }
}

// E_i = sum_p m_p e_p N_ip / M_i, alpha_i = min(1, kappa dt sum_p m_p N_ip max(0, -div v) / M_i), M_i of the gas.
// [Exchange 1]
template <class G, class S, class T>
void Mechanics<G, S, T>::solve_exchange(Field& field, double dt) const {
  walls_.fold_even(field, field.heat);
  walls_.fold_even(field, field.exchange);
  const std::vector<double>& mass = gas_mass(field);
  field.for_touched(
      grid_,
      [&](std::size_t i) {
        const double share = mass[i] > least_mass ? 1 / mass[i] : 0.0;
        field.heat[i] *= share;
        field.exchange[i] = std::min(1.0, scene_.heat_exchange * dt * field.exchange[i] * share);
      },
      options_.threads);
  walls_.extend_even(field, field.heat);
  walls_.extend_even(field, field.exchange);
}

template <class G, class S, class T>
void Mechanics<G, S, T>::clear_forces() {
  hoop_force_ = 0;
  stress_turn_.setZero();
  for (Field& field : fields_) {
    field.for_touched(
        grid_,
        [&](std::size_t i) {
          field.force[i].setZero();
          field.body_force[i].setZero();
          field.heat[i] = field.exchange[i] = 0;
        },
        options_.threads);
  }
}

template <class G, class S, class T>
void Mechanics<G, S, T>::map_forces() {
  want_places("map_forces");
  settle_pending_strain();
  clear_forces();
  for (std::size_t b = 0; b < located_.size(); ++b) {
    hoop_force_ += sum_over_chunks_writing_nodes<double>(located_[b], [&](const Chunk& chunk) {
      return scatter_forces(scene_.bodies[b], located_[b], chunk, field_of(b));
    });
    add_stress_turn(b);
    map_load(b);
  }
  forces_mapped_ = true;
}

// Stresses of another instant than the points' places turn a body: sum_i x_i x f_i is -sum_p V_p (sigma_ba - sigma_ab) of a
// stress that is not symmetric, and sum_p x_p x F_p of forces between points where they will be.
template <class G, class S, class T>
void Mechanics<G, S, T>::add_stress_turn(std::size_t b) {
  const Body& body = scene_.bodies[b];
  const StressMeasure measure = body.material->measure();
  const bool full = measure == StressMeasure::full;
  if (rotations == 0 || (!full && measure != StressMeasure::point_force)) return;
  const Places places = this->places(body, located_[b]);
  const double* volume = body.points(column::volume);
  for (int k = 0; k < rotations; ++k) {
    const int d = rotation_axis<dim>(k, 0), e = rotation_axis<dim>(k, 1);
    const double *low = body.points(column::stress, full ? d * dim + e : d),
                 *high = body.points(column::stress, full ? e * dim + d : e);
    stress_turn_[k] -= sum_over_chunks<double>(located_[b], [&](const Chunk& chunk) {
      Pack turn = 0.0;
      for_packs(chunk.first, chunk.last, [&](int p, int count) {
        const Pack s = load(low + p), t = load(high + p);
        turn += kept(load(volume + p) * (full ? t - s : load(places.x[d] + p) * t - load(places.x[e] + p) * s), count);
      });
      return sum(turn);
    });
  }
}

// sum_p m_p b_p N_ip of what a body's load gives its points at the time of the stresses. [York 3.18]
template <class G, class S, class T>
void Mechanics<G, S, T>::map_load(std::size_t b) {
  Body& body = scene_.bodies[b];
  if (!body.load) return;
  body.points.add(column::body_force, dim);
  body.load(time_ + load_ahead_, body.points, body.id);
  const Located& at = located_[b];
  const Places places = this->places(body, at);
  const double *mass = body.points(column::mass), *force[dim];
  for (int d = 0; d < dim; ++d) force[d] = body.points(column::body_force, d);
  for_chunks_writing_nodes(at, [&](const Chunk& chunk) {
    for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
      Pack sums[nodes * dim];
      for (Pack& s : sums) s = 0.0;
      for_packs(first, last, [&](int p, int count) {
        const PackStencil weights = stencil(places, anchor, p);
        const Pack m = kept(load(mass + p), count);
        for (int d = 0; d < dim; ++d) weights.spread(m * load(force[d] + p), sums + d, dim);
      });
      add_to_nodes<dim>(print, sums, [&](std::size_t i, const double* total) {
        for (int d = 0; d < dim; ++d) field_of(b).body_force[i][d] += total[d];
      });
    });
  });
}

// Body forces fold like all others: what a point puts on a ghost node pulls the mirror node the other way.
template <class G, class S, class T>
void Mechanics<G, S, T>::add_body_force(Field& field, double dt) {
  if (!loaded_) return;
  field.for_touched(grid_, [&](std::size_t i) {
    const Vec f = field.body_force[i] + field.own_mass[i] * gravity_;  // [York 3.18]
    field.body_force[i] = f;
    field.force[i] += f;
    pending_.body += dt * f;
    pending_.body_angular += dt * cross<dim>(grid_.position(static_cast<int>(i)), f);
  });
}

// Contact between velocity fields, decided at the first advance after a map. Its work is what the nodes' kinetic energy
// changes by beyond the work of the other forces, as points will take it: FLIP from the velocity each field had.
template <class G, class S, class T>
void Mechanics<G, S, T>::touch_bodies(double dt) {
  if (!contact_) return;
  if (contact_->changes_start()) settle_loss();
  if (!contact_decided_) contact_->find(scene_, field_indices(), fields_);
  pending_.contact = {};
  contact_->apply(fields_, dt, !contact_decided_, [&](const ContactChange<dim>& c) {
    const Vec impulse = c.mass * (c.end - c.start) - c.mass * (c.own_end - c.own_start);
    const Vec kick = c.end - c.start, mean = 0.5 * (c.end + c.start);
    const Vec own_work = transfer_.increments ? Vec(c.own_start + 0.5 * kick) : Vec(0.5 * (c.end + c.own_start));
    const Vec gained = transfer_.increments ? kick : Vec(c.end - c.own_start);
    pending_.contact.work += c.mass * gained.dot(own_work) - c.mass * (c.own_end - c.own_start).dot(mean);
    const Vec given = transfer_.increments ? impulse : Vec(c.mass * (c.end - c.own_end));
    pending_.contact.linear += given;
    pending_.contact.angular += cross<dim>(grid_.position(c.node), given);
  });
  contact_decided_ = true;
  if (!contact_->changes_start()) return;
  for (Field& field : fields_) walls_.extend(field, field.start);
}

template <class G, class S, class T>
void Mechanics<G, S, T>::advance_momentum(double dt) {
  want_places("advance_momentum");
  pending_.wall = {};
  pending_.body.setZero();
  pending_.body_angular.setZero();
  pending_.force_turn = dt * stress_turn_;
  pending_.body_work = pending_.wall_work = 0;
  for (Field& field : fields_) {
    add_body_force(field, dt);
    const WallAction<dim> action = walls_.fold(field, field.force);
    pending_.wall.linear += dt * action.linear;
    pending_.wall.angular += dt * action.angular;
    field.for_touched(
        grid_,
        [&](std::size_t i) {
          const double m = field.mass[i];
          field.end[i] = m > least_mass ? Vec(field.force[i] / m) : Vec(Vec::Zero());  // [York 3.19]
        },
        options_.threads);
    if (!sharpening_.none()) {
      const SharpeningAction<dim> added = sharpening_.apply_to_accelerations(field, field.end, field.midpoint,
                                                                             options_.threads);  // [Sharpening 1]
      pending_.wall.linear += dt * added.walls.linear;
      pending_.wall.angular += dt * added.walls.angular;
      pending_.force_turn += dt * added.turn;
    }
    const std::vector<Vec>& acceleration = sharpening_.none() ? field.end : field.midpoint;
    field.for_touched(
        grid_,
        [&](std::size_t i) {
          const Vec dv = dt * acceleration[i];
          field.end[i] = field.start[i] + dv;  // [York 3.20]
          field.midpoint[i] = field.start[i] + 0.5 * dv;
        },
        options_.threads);
  }
  touch_bodies(dt);
  for (Field& field : fields_) {
    walls_.extend(field, field.end);
    walls_.extend(field, field.midpoint);
    pending_.wall_work += drive(field, field.end, pending_.wall);
    WallAction<dim> counted;
    drive(field, field.midpoint, counted);
    if (scene_.heat_exchange > 0) solve_exchange(field, dt);
    if (!loaded_) continue;
    const std::vector<Vec>& straining = straining_velocity(field, NodalVelocity::midpoint);
    field.for_touched(grid_, [&](std::size_t i) { pending_.body_work += dt * field.body_force[i].dot(straining[i]); });
  }
  pending_.wall.linear[0] += dt * hoop_force_;
  current_ = NodalVelocity::end;
  rate_of_ = NodalVelocity::current;
  pending_.power = true;
  pending_.dt = dt;
}

}  // namespace plumbline
