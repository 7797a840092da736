// Points to grid, and the momentum equation on the grid.
#pragma once

#include <stdexcept>

#include "kernel/engine/mechanics.hpp"

namespace plumbline {

template <class G>
void Mechanics<G>::solve_velocity(Field& field, std::vector<Vec>& velocity) const {
  field.for_touched(
      grid_,
      [&](std::size_t i) {
        velocity[i] = field.mass[i] > least_mass ? Vec(field.momentum[i] / field.mass[i]) : Vec(Vec::Zero());
      },
      options_.threads);
  walls_.extend(field, velocity);
}

// What pistons do to nodal velocities; returns their work, J.
template <class G>
double Mechanics<G>::drive(const Field& field, std::vector<Vec>& velocity, WallAction<dim>& action) const {
  if (pistons_.none()) return 0;
  const double work = pistons_.drive(grid_, field, velocity, action);
  walls_.extend(field, velocity);
  return work;
}

template <class G>
void Mechanics<G>::map_mass_and_momentum() {
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
      const Weights<dim>& at = located_[b].weights;
      for_chunks_writing_nodes(at.bins, options_.threads, [&](const Chunk& chunk) {
        loops_->map_mass_and_momentum(scene_.bodies[b], at, chunk, field_of(b));
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

template <class G>
void Mechanics<G>::settle_loss() {
  if (!pending_.loss) return;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    const Weights<dim>& at = located_[b].weights;
    pending_.map_loss += sum_over_chunks<double>(at.bins, options_.threads, [&](const Chunk& chunk) {
      return loops_->gather_start(scene_.bodies[b], at, chunk, {.loss = &field_of(b).start});
    });
  }
  pending_.loss = false;
}

template <class G>
void Mechanics<G>::map_momentum() {
  want_places("map_momentum");
  for (Field& field : fields_) field.for_touched(grid_, [&](std::size_t i) { field.momentum[i].setZero(); });
  for (std::size_t b = 0; b < located_.size(); ++b) {
    const Weights<dim>& at = located_[b].weights;
    for_chunks_writing_nodes(at.bins, options_.threads, [&](const Chunk& chunk) {
      loops_->map_momentum(scene_.bodies[b], at, chunk, field_of(b));
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

template <class G>
double Mechanics<G>::map_forces(std::size_t b, const Chunk& chunk) {
  const Body& body = scene_.bodies[b];
  return loops_->map_forces(body, located_[b].weights, chunk, exchanges_heat(body), field_of(b));
}

// E_i = sum_p m_p e_p N_ip / M_i, alpha_i = min(1, kappa dt sum_p m_p N_ip max(0, -div v) / M_i), M_i of the gas.
// [Exchange 1]
template <class G>
void Mechanics<G>::solve_exchange(Field& field, double dt) const {
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

template <class G>
void Mechanics<G>::clear_forces() {
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

template <class G>
void Mechanics<G>::map_forces() {
  want_places("map_forces");
  settle_pending_strain();
  clear_forces();
  for (std::size_t b = 0; b < located_.size(); ++b) {
    hoop_force_ += sum_over_chunks_writing_nodes<double>(located_[b].weights.bins, options_.threads,
                                                         [&](const Chunk& chunk) { return map_forces(b, chunk); });
    add_stress_turn(b);
    map_load(b);
  }
  forces_mapped_ = true;
}

// Stresses of another instant than the points' places turn a body: sum_i x_i x f_i is -sum_p V_p (sigma_ba - sigma_ab) of a
// stress that is not symmetric, and sum_p x_p x F_p of forces between points where they will be.
template <class G>
void Mechanics<G>::add_stress_turn(std::size_t b) {
  const Body& body = scene_.bodies[b];
  const StressMeasure measure = body.material->measure();
  const bool full = measure == StressMeasure::full;
  if (rotations == 0 || (!full && measure != StressMeasure::point_force)) return;
  const Weights<dim>& at = located_[b].weights;
  const Places<dim> places = at.places(body.points, false);
  const double* volume = body.points(column::volume);
  for (int k = 0; k < rotations; ++k) {
    const int d = rotation_axis<dim>(k, 0), e = rotation_axis<dim>(k, 1);
    const double *low = body.points(column::stress, full ? d * dim + e : d),
                 *high = body.points(column::stress, full ? e * dim + d : e);
    stress_turn_[k] -= sum_over_chunks<double>(at.bins, options_.threads, [&](const Chunk& chunk) {
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
template <class G>
void Mechanics<G>::map_load(std::size_t b) {
  Body& body = scene_.bodies[b];
  if (!body.load) return;
  body.points.add(column::body_force, dim);
  body.load(time_ + load_ahead_, body.points, body.id);
  const Weights<dim>& at = located_[b].weights;
  std::array<typename Loops::Spread, dim> forces;
  for (int d = 0; d < dim; ++d) {
    forces[static_cast<std::size_t>(d)] = {body.points(column::body_force, d), body.points(column::mass),
                                           component(field_of(b).body_force, d), dim};
  }
  for_chunks_writing_nodes(at.bins, options_.threads,
                           [&](const Chunk& chunk) { loops_->spread(body.points, at, chunk, forces); });
}

// Body forces fold like all others: what a point puts on a ghost node pulls the mirror node the other way.
template <class G>
void Mechanics<G>::add_body_force(Field& field, double dt) {
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
template <class G>
void Mechanics<G>::touch_bodies(double dt) {
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

template <class G>
void Mechanics<G>::advance_momentum(double dt) {
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
