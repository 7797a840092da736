// Strain rates, densities, stresses and their power.
#pragma once

#include "kernel/density/cell_density.hpp"
#include "kernel/engine/mechanics.hpp"

namespace plumbline {

// The nodal velocity whose gradients strain the points: sharpened as the accelerations are. [Sharpening 1]
template <class G>
auto Mechanics<G>::straining_velocity(Field& field, NodalVelocity which) const -> const std::vector<Vec>& {
  const std::vector<Vec>& velocity = nodal(field, which);
  if (sharpening_.none()) return velocity;
  sharpening_.apply(field, velocity, field.straining, options_.threads);
  walls_.extend(field, field.straining);
  return field.straining;
}

template <class G>
void Mechanics<G>::find_all_strain_rates(NodalVelocity which) {
  if (which == NodalVelocity::current) which = current_;
  if (which == rate_of_) return;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    const std::vector<Vec>& velocity = straining_velocity(field_of(b), which);
    const Weights<dim>& at = located_[b].weights;
    for_chunks(at.bins, options_.threads,
               [&](const Chunk& chunk) { loops_->gather_start(scene_.bodies[b], at, chunk, {.rates = &velocity}); });
  }
  rate_of_ = which;
}

// dt sum_p V_p sigma_p : strain_rate_p
template <class G>
double Mechanics<G>::stress_power(const Body& body, PointRange range, double dt) const {
  const double* volume = body.points(column::volume);
  const int components = stress_components(body.material->measure(), dim, G::axisymmetric);
  Pack power = 0.0;
  const double *stress[most_components], *rate[most_components];
  for (int k = 0; k < components; ++k) {
    stress[k] = body.points(column::stress, k);
    rate[k] = body.points(column::strain_rate, k);
  }
  for_packs(range.first, range.last, [&](int p, int count) {
    Pack dot = load(stress[0] + p) * load(rate[0] + p);
    for (int k = 1; k < components; ++k) dot += load(stress[k] + p) * load(rate[k] + p);
    power += kept(dt * load(volume + p) * dot, count);
  });
  return sum(power);
}

// The stress power of the forces that advance_momentum used, with the midpoint velocity: before anything changes either.
template <class G>
void Mechanics<G>::settle_power() {
  if (!pending_.power) return;
  find_all_strain_rates(NodalVelocity::midpoint);
  PowerSums sums;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    const Body& body = scene_.bodies[b];
    sums += sum_over_chunks<PowerSums>(located_[b].weights.bins, options_.threads, [&](const Chunk& chunk) {
      const PointRange range{chunk.first, chunk.last};
      return PowerSums{stress_power(body, range, pending_.dt),
                       body.material->viscous_heat(body.points, range, context(), pending_.dt)};
    });
  }
  pending_.stress_power = sums.power;
  pending_.viscous = sums.viscous;
  pending_.power = false;
}

// Strain before the forces are known waits: its stress power is booked with the stress that the forces use.
template <class G>
void Mechanics<G>::strain_points(double dt, NodalVelocity velocity) {
  want_places("strain_points");
  settle_power();
  find_all_strain_rates(velocity);
  survey_.reset();
  PowerSums sums;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    sums += sum_over_chunks<PowerSums>(located_[b].weights.bins, options_.threads, [&](const Chunk& chunk) {
      const PointRange range{chunk.first, chunk.last};
      const double power = forces_mapped_ ? stress_power(body, range, dt) : 0.0;
      return PowerSums{.power = power, .stored = body.material->advance(body.points, range, context(), dt)};
    });
  }
  for (std::size_t b = 0; b < located_.size(); ++b) smooth_strain(b, dt);
  if (forces_mapped_) {
    ledger_.energy.book(Flow::integration, sums.power);
    ledger_.energy.book(Flow::constitutive, sums.stored - sums.power);
  } else {
    pending_stored_ += sums.stored;
    pending_strain_dt_ += dt;
  }
}

template <class G>
void Mechanics<G>::settle_pending_strain() {
  if (pending_strain_dt_ == 0) return;
  double power = 0;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    power += sum_over_chunks<double>(located_[b].weights.bins, options_.threads, [&](const Chunk& chunk) {
      return stress_power(scene_.bodies[b], {chunk.first, chunk.last}, pending_strain_dt_);
    });
  }
  ledger_.energy.book(Flow::integration, power);
  ledger_.energy.book(Flow::constitutive, pending_stored_ - power);
  pending_strain_dt_ = pending_stored_ = 0;
}

// rho_i = M_i / |cell_i|. [EC-APIC 2] Of an enclosed gas its inverse, with what of the cell lies inside: volumes of points
// then sum to the enclosed one, whatever the points' places. [Coupling 4]
template <class G>
void Mechanics<G>::find_grid_density(Field& field, const std::vector<double>& mass, const Body& body) {
  if constexpr (dim == 2) {
    if (body.enclosure) {
      const auto chain = std::find_if(scene_.bodies.begin(), scene_.bodies.end(),
                                      [&](const Body& other) { return other.name == body.enclosure->chain; });
      if (chain == scene_.bodies.end()) {
        throw std::invalid_argument("body " + body.name + " names the enclosure " + body.enclosure->chain +
                                    ", which is no body of the scene");
      }
      loops_->find_enclosed_volumes(chain->points, body.enclosure->corners, space_);
      walls_.fold_even(field, space_);
      field.for_touched(
          grid_, [&](std::size_t i) { field.density[i] = mass[i] > least_mass ? space_[i] / mass[i] : 0.0; },
          options_.threads);
      walls_.extend_even(field, field.density);
      return;
    }
  }
  field.for_touched(
      grid_, [&](std::size_t i) { field.density[i] = mass[i] * inverse_volume_[i]; }, options_.threads);
  walls_.extend_even(field, field.density);
}

// Densities by the scene's method, then stresses, and_forces: then the forces, before the points have moved; where the
// grid's mass of this step is the body's own, it serves. Point forces are those of places, which may have drifted.
template <class G>
void Mechanics<G>::evaluate_stress_ahead(NodalVelocity velocity, double ahead, bool and_forces) {
  want_places(ahead == 0 ? "evaluate_stress" : "predict_stress");
  settle_power();
  survey_.reset();
  load_ahead_ = ahead;
  if (velocity == NodalVelocity::current) velocity = current_;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    const bool has_density = body.material->has_density();
    const bool grid_density = has_density && scene_.density == DensityMethod::grid;
    const bool of_places = body.material->measure() == StressMeasure::point_force;
    const MaterialContext then = context(of_places && ahead != 0 ? ahead - drifted_ : ahead);
    Weights<dim> elsewhere;  // where the points stand now, if they have moved since they were located
    Weights<dim>& at = located_[b].weights;
    const bool moved = at.kept();
    Field* field = &field_of(b);
    const auto takes_heat = [&](std::size_t o) {
      return located_[o].field == located_[b].field && scene_.bodies[o].material->takes_heat();
    };
    bool only_gas = true;  // of its field: then the step has mapped its mass
    for (std::size_t o = 0; o < located_.size(); ++o) only_gas = only_gas && (o == b || !takes_heat(o));
    if (grid_density && (moved || (!alone_[located_[b].field] && !only_gas))) {
      if (!own_field_) own_field_.emplace(grid_);
      field = &*own_field_;
      elsewhere.lowest.resize(at.lowest.size());
      map_own_mass(body, moved ? elsewhere : at, *field);
    }
    if (grid_density) find_grid_density(*field, field == &field_of(b) ? gas_mass(*field) : field->mass, body);
    if (has_density && !grid_density && scene_.density != DensityMethod::continuity) {
      cell_density<dim>(grid_, body.points, scene_.density == DensityMethod::quadratic);
    }
    const bool rates_wanted = velocity != rate_of_, loss_wanted = pending_.loss;
    const std::vector<Vec>& nodal_velocity = rates_wanted ? straining_velocity(field_of(b), velocity)
                                                          : field_of(b).start;
    const bool elsewhere_wanted = grid_density && moved;
    Wanted wanted;
    if (loss_wanted) wanted.loss = &field_of(b).start;
    if (rates_wanted) wanted.rates = &nodal_velocity;
    if (grid_density && !elsewhere_wanted) wanted.density = &field->density;
    wanted.specific = body.enclosure.has_value();
    const auto evaluate = [&](const Chunk& chunk) {
      const double lost = wanted.none() ? 0.0 : loops_->gather_start(body, at, chunk, wanted);
      if (!elsewhere_wanted) body.material->evaluate_stress(body.points, {chunk.first, chunk.last}, then);
      return lost;
    };
    if (and_forces) {
      const StartSums sums = sum_over_chunks_writing_nodes<StartSums>(at.bins, options_.threads,
                                                                      [&](const Chunk& chunk) {
                                                                        const double lost = evaluate(chunk);
                                                                        return StartSums{lost, map_forces(b, chunk)};
                                                                      });
      pending_.map_loss += sums.lost;
      hoop_force_ += sums.hoop_force;
      add_stress_turn(b);
      map_load(b);
    } else {
      pending_.map_loss += sum_over_chunks<double>(located_[b].weights.bins, options_.threads, evaluate);
    }
    if (elsewhere_wanted) {
      for_chunks(elsewhere.bins, options_.threads, [&](const Chunk& chunk) {
        loops_->gather_start(body, elsewhere, chunk,
                             {.density = &field->density, .specific = body.enclosure.has_value()});
        body.material->evaluate_stress(body.points, {chunk.first, chunk.last}, then);
      });
    }
  }
  rate_of_ = velocity;
  pending_.loss = false;
}

template <class G>
void Mechanics<G>::evaluate_stress(NodalVelocity velocity) {
  evaluate_stress_ahead(velocity, 0, false);
}

template <class G>
void Mechanics<G>::predict_stress(double ahead, NodalVelocity velocity) {
  evaluate_stress_ahead(velocity, ahead, false);  // [Leapfrog 2]
}

template <class G>
void Mechanics<G>::predict_stress_and_map_forces(double ahead) {
  if (moved_) return Stages::predict_stress_and_map_forces(ahead);
  settle_pending_strain();
  clear_forces();
  evaluate_stress_ahead(NodalVelocity::start, ahead, true);
  forces_mapped_ = true;
}

template <class G>
void Mechanics<G>::map_own_mass(const Body& body, Weights<dim>& at, Field& field) {
  if (at.bins.bins() == 0) {
    place(body, at);
    at.bins.build(at.lowest, grid_.stride(dim - 1), block_height, false);
  }
  touch_alone(at, field);
  const typename Loops::Spread mass[] = {{body.points(column::mass), nullptr, field.mass.data(), 1}};
  for_chunks_writing_nodes(at.bins, options_.threads,
                           [&](const Chunk& chunk) { loops_->spread(body.points, at, chunk, mass); });
  walls_.fold_mass(field);
}

template <class G>
bool Mechanics<G>::reverse_cooling() {
  want_places("reverse_cooling");
  find_all_strain_rates(NodalVelocity::midpoint);
  int changed = 0;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    changed += sum_over_chunks<int>(located_[b].weights.bins, options_.threads, [&](const Chunk& chunk) {
      return body.material->reverse_cooling(body.points, {chunk.first, chunk.last}, context()) ? 1 : 0;
    });
  }
  return changed > 0;
}

}  // namespace plumbline
