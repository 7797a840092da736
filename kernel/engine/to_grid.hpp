// Points to grid, and the momentum equation on the grid.
#pragma once

#include "kernel/engine/mechanics.hpp"

namespace plumbline {

template <class G>
void Mechanics<G>::map_mass_and_momentum() {
  want_places("map_mass_and_momentum");
  step_.map_wall = {};
  step_.map_wall_work = 0;
  step_.advance.reset();
  for (Field& field : layout_.fields) momentum_.clear_map(field);
  for (const bool gas : {true, false}) {  // gases first: where others share their nodes, their mass is wanted alone
    for (std::size_t b = 0; b < bodies(); ++b) {
      const Body& body = scene_.bodies[b];
      if (body.material->takes_heat() != gas) continue;
      space_.for_chunks_writing_nodes(layout_.weights[b], [&](const Chunk& chunk) {
        space_.loops->map_mass_and_momentum(body, layout_.weights[b], chunk, field_of(b));
      });
    }
    for (Field& field : layout_.fields) {
      if (!gas || !field.mixed()) continue;
      field.for_touched(space_.grid, [&](std::size_t i) { field.gas_mass[i] = field.mass[i]; });
      space_.walls.fold_even(field, field.gas_mass);
      space_.walls.extend_even(field, field.gas_mass);
    }
  }
  grid_mass_ = 0;
  for (Field& field : layout_.fields) grid_mass_ += momentum_.start(field, step_);
  step_.map_loss.reset();
  if (space_.transfer.keep == 1) step_.map_loss = 0;
  current_ = NodalVelocity::start;
}

template <class G>
void Mechanics<G>::settle_loss() {
  if (step_.map_loss) return;
  double loss = 0;
  for (std::size_t b = 0; b < bodies(); ++b) {
    const Weights<dim>& at = layout_.weights[b];
    loss += space_.template sum_over_chunks<double>(at, [&](const Chunk& chunk) {
      return space_.loops->gather_start(scene_.bodies[b], at, chunk, {.loss = &field_of(b).start});
    });
  }
  step_.map_loss = loss;
}

template <class G>
void Mechanics<G>::map_momentum() {
  want_places("map_momentum");
  for (Field& field : layout_.fields) {
    field.for_touched(space_.grid, [&](std::size_t i) { field.momentum[i].setZero(); });
  }
  for (std::size_t b = 0; b < bodies(); ++b) {
    space_.for_chunks_writing_nodes(layout_.weights[b], [&](const Chunk& chunk) {
      space_.loops->map_momentum(scene_.bodies[b], layout_.weights[b], chunk, field_of(b));
    });
  }
  momentum_.start_again(layout_.fields);
  current_ = NodalVelocity::remapped;
  if (rate_of_ == NodalVelocity::remapped) rate_of_.reset();
}

template <class G>
void Mechanics<G>::clear_forces() {
  forces_.emplace();
  for (Field& field : layout_.fields) momentum_.clear_forces(field);
}

template <class G>
double Mechanics<G>::map_forces(std::size_t b, const Chunk& chunk) {
  const Body& body = scene_.bodies[b];
  return space_.loops->map_forces(body, layout_.weights[b], chunk, exchanges_heat(body), field_of(b));
}

template <class G>
void Mechanics<G>::map_forces() {
  want_places("map_forces");
  settle_pending_strain();
  clear_forces();
  for (std::size_t b = 0; b < bodies(); ++b) {
    forces_->hoop += space_.template sum_over_chunks_writing_nodes<double>(
        layout_.weights[b], [&](const Chunk& chunk) { return map_forces(b, chunk); });
    add_stress_turn(b);
    map_load(b);
  }
}

// Stresses of another instant than the points' places turn a body: sum_i x_i x f_i is -sum_p V_p (sigma_ba - sigma_ab) of a
// stress that is not symmetric, and sum_p x_p x F_p of forces between points where they will be.
template <class G>
void Mechanics<G>::add_stress_turn(std::size_t b) {
  const Body& body = scene_.bodies[b];
  const StressMeasure measure = body.material->measure();
  const bool full = measure == StressMeasure::full;
  if (rotations == 0 || (!full && measure != StressMeasure::point_force)) return;
  const Weights<dim>& at = layout_.weights[b];
  const Places<dim> places = at.places(body.points, false);
  const double* volume = body.points(column::volume);
  for (int k = 0; k < rotations; ++k) {
    const int d = rotation_axis<dim>(k, 0), e = rotation_axis<dim>(k, 1);
    const double *low = body.points(column::stress, full ? d * dim + e : d),
                 *high = body.points(column::stress, full ? e * dim + d : e);
    forces_->turn[k] -= space_.template sum_over_chunks<double>(at, [&](const Chunk& chunk) {
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
  std::array<typename Loops::Spread, dim> forces;
  for (int d = 0; d < dim; ++d) {
    forces[static_cast<std::size_t>(d)] = {body.points(column::body_force, d), body.points(column::mass),
                                           component(field_of(b).body_force, d), dim};
  }
  space_.spread(body.points, layout_.weights[b], forces);
}

template <class G>
void Mechanics<G>::advance_momentum(double dt) {
  want_places("advance_momentum");
  if (momentum_.contact_changes_start()) settle_loss();
  const bool first = !step_.advance;
  step_.advance = momentum_.advance(layout_.fields, forces_.value_or(MappedForces<dim>{}), dt, first);
  step_.power.reset();
  rate_of_.reset();
  current_ = NodalVelocity::end;
}

}  // namespace plumbline
