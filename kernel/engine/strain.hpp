// Strain rates, densities, stresses and their power.
#pragma once

#include "kernel/density/cell_density.hpp"
#include "kernel/enclosed_volumes.hpp"
#include "kernel/engine/chunks.hpp"

namespace plumbline {

// Strain rates of a pack from the jets of the velocity components. [York 3.23]
template <class G, class S, class T>
template <class Component>
[[gnu::always_inline]] inline void Mechanics<G, S, T>::store_strain_rates(const RateColumns& rates,
                                                                          const PackStencil& weights,
                                                                          const Pack& radius, int p, int count,
                                                                          Component&& u) const {
  Pack gradient[dim][dim], hoop_rate = 0.0;
  for (int d = 0; d < dim; ++d) {
    const auto jet = weights.gather_array([&](int k) { return u(k, d); });
    if (rates.measure == StressMeasure::point_force) {
      store(rates.at[d] + p, jet.value, count);
      continue;
    }
    for (int e = 0; e < dim; ++e) gradient[d][e] = jet.gradient[e];
    if constexpr (G::axisymmetric) {
      if (d == 0) hoop_rate = jet.value / radius;
    }
  }
  if (rates.measure == StressMeasure::point_force) return;
  if (rates.measure == StressMeasure::pressure) {
    Pack divergence = gradient[0][0] + hoop_rate;
    for (int d = 1; d < dim; ++d) divergence += gradient[d][d];
    store(rates.at[0] + p, divergence, count);
    return;
  }
  if (rates.measure == StressMeasure::full) {
    for (int d = 0; d < dim; ++d) {
      for (int e = 0; e < dim; ++e) store(rates.at[d * dim + e] + p, gradient[d][e], count);
    }
    if constexpr (G::axisymmetric) store(rates.at[dim * dim] + p, hoop_rate, count);
    return;
  }
  Pack rate[G::strains];
  G::strain(gradient, hoop_rate, rate);
  for (int k = 0; k < G::strains; ++k) store(rates.at[k] + p, rate[k], count);
}

template <class G, class S, class T>
auto Mechanics<G, S, T>::rate_columns(Body& body) const -> RateColumns {
  RateColumns rates;
  rates.measure = body.material->measure();
  for (int k = 0; k < stress_components(rates.measure, dim, G::axisymmetric); ++k) {
    rates.at[k] = body.points(column::strain_rate, k);
  }
  return rates;
}

// What the points of a chunk take from the grid of the start of the step.
//   loss     sum_p m_p A_p with A_p = sum_i N_ip |v_p + C_p (x_i - x_p) - v_i|^2 / 2, returned, as the sum of three terms
//            that are never negative: what v_p and C_p differ by from the grid's, and what of the grid's velocity is not
//            affine [EC-APIC 1]
//   rates    strain rates of a nodal velocity [York 3.23]
//   density  V_p = m_p / rho_p, rho_p = sum_i N_ip rho_i [EC-APIC 2]; specific: V_p = m_p sum_i N_ip v_i [Coupling 4]
template <class G, class S, class T>
double Mechanics<G, S, T>::gather_start(Body& body, const Located& at, const Chunk& chunk, const Wanted& wanted) const {
  const Places places = this->places(body, at);
  const double* mass = body.points(column::mass);
  const double *velocity[dim], *affine[dim][dim] = {};
  for (int d = 0; d < dim; ++d) {
    velocity[d] = body.points(column::velocity, d);
    for (int e = 0; T::affine && e < dim; ++e) affine[d][e] = body.points(column::affine, d * dim + e);
  }
  double* loss = body.points.has(column::transfer_loss) ? body.points(column::transfer_loss) : nullptr;
  double* volume = body.points(column::volume);
  const RateColumns rates = rate_columns(body);
  Pack total = 0.0;
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    BinVelocity start;
    double strained[nodes][dim], rho[nodes];
    if (wanted.loss) start = bin_velocity(print, *wanted.loss);
    for_stencil_nodes(print, [&](int k, std::size_t i) {
      for (int d = 0; wanted.rates && d < dim; ++d) strained[k][d] = (*wanted.rates)[i][d];
      if (wanted.density) rho[k] = (*wanted.density)[i];
    });
    for_packs(first, last, [&](int p, int count) {
      const PackStencil weights = stencil(places, anchor, p);
      if (wanted.rates) {
        store_strain_rates(rates, weights, load(places.x[0] + p), p, count,
                           [&](int k, int d) { return strained[k][d]; });
      }
      if (wanted.density) {
        const Pack density = weights.gather_array([&](int k) { return rho[k]; }).value;
        store(volume + p, wanted.specific ? load(mass + p) * density : load(mass + p) / density, count);
      }
      if (!wanted.loss) return;
      Pack inertia[dim];
      for (int d = 0; d < dim; ++d) inertia[d] = weights.inertia(d);
      Pack spread = weights.gather_array([&](int k) { return start.square[k]; }).value, apart = 0.0;
      for (int d = 0; d < dim; ++d) {
        const auto u = weights.gather_array([&](int k) { return start.u[k][d]; });
        const Pack off = load(velocity[d] + p) - start.base[d] - u.value;
        apart += off * off;
        spread -= u.value * u.value;
        if constexpr (T::affine) {
          for (int e = 0; e < dim; ++e) {
            const Pack twist = load(affine[d][e] + p) - u.affine[e];
            apart += inertia[e] * twist * twist;
            spread -= inertia[e] * u.affine[e] * u.affine[e];
          }
        }
      }
      const Pack lost = 0.5 * load(mass + p) * (apart + max(spread, Pack(0.0)));
      if (loss) store(loss + p, lost, count);
      total += kept(lost, count);
    });
  });
  return sum(total);
}

// The nodal velocity whose gradients strain the points: sharpened as the accelerations are. [Sharpening 1]
template <class G, class S, class T>
auto Mechanics<G, S, T>::straining_velocity(Field& field, NodalVelocity which) const -> const std::vector<Vec>& {
  const std::vector<Vec>& velocity = nodal(field, which);
  if (sharpening_.none()) return velocity;
  sharpening_.apply(field, velocity, field.straining, options_.threads);
  walls_.extend(field, field.straining);
  return field.straining;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::find_all_strain_rates(NodalVelocity which) {
  if (which == NodalVelocity::current) which = current_;
  if (which == rate_of_) return;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    const std::vector<Vec>& velocity = straining_velocity(field_of(b), which);
    for_chunks(located_[b],
               [&](const Chunk& chunk) { gather_start(scene_.bodies[b], located_[b], chunk, {.rates = &velocity}); });
  }
  rate_of_ = which;
}

// dt sum_p V_p sigma_p : strain_rate_p
template <class G, class S, class T>
double Mechanics<G, S, T>::stress_power(const Body& body, PointRange range, double dt) const {
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
template <class G, class S, class T>
void Mechanics<G, S, T>::settle_power() {
  if (!pending_.power) return;
  find_all_strain_rates(NodalVelocity::midpoint);
  PowerSums sums;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    const Body& body = scene_.bodies[b];
    sums += sum_over_chunks<PowerSums>(located_[b], [&](const Chunk& chunk) {
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
template <class G, class S, class T>
void Mechanics<G, S, T>::strain_points(double dt, NodalVelocity velocity) {
  want_places("strain_points");
  settle_power();
  find_all_strain_rates(velocity);
  survey_.reset();
  PowerSums sums;  // power, and what is stored
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    sums += sum_over_chunks<PowerSums>(located_[b], [&](const Chunk& chunk) {
      const PointRange range{chunk.first, chunk.last};
      const double power = forces_mapped_ ? stress_power(body, range, dt) : 0.0;
      return PowerSums{power, body.material->advance(body.points, range, context(), dt)};
    });
  }
  const double stored = sums.viscous;
  for (std::size_t b = 0; b < located_.size(); ++b) smooth_strain(b, dt);
  if (forces_mapped_) {
    ledger_.energy.book(Flow::integration, sums.power);
    ledger_.energy.book(Flow::constitutive, stored - sums.power);
  } else {
    pending_stored_ += stored;
    pending_strain_dt_ += dt;
  }
}

template <class G, class S, class T>
void Mechanics<G, S, T>::settle_pending_strain() {
  if (pending_strain_dt_ == 0) return;
  double power = 0;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    power += sum_over_chunks<double>(located_[b], [&](const Chunk& chunk) {
      return stress_power(scene_.bodies[b], {chunk.first, chunk.last}, pending_strain_dt_);
    });
  }
  ledger_.energy.book(Flow::integration, power);
  ledger_.energy.book(Flow::constitutive, pending_stored_ - power);
  pending_strain_dt_ = pending_stored_ = 0;
}

// rho_i = M_i / |cell_i|. [EC-APIC 2] Of an enclosed gas its inverse, with what of the cell lies inside: volumes of points
// then sum to the enclosed one, whatever the points' places. [Coupling 4]
template <class G, class S, class T>
void Mechanics<G, S, T>::find_grid_density(Field& field, const std::vector<double>& mass, const Body& body) {
  if constexpr (dim == 2) {
    if (body.enclosure) {
      const auto chain = std::find_if(scene_.bodies.begin(), scene_.bodies.end(),
                                      [&](const Body& other) { return other.name == body.enclosure->chain; });
      if (chain == scene_.bodies.end()) {
        throw std::invalid_argument("body " + body.name + " names the enclosure " + body.enclosure->chain +
                                    ", which is no body of the scene");
      }
      enclosed_volumes<S>(grid_, chain->points, body.enclosure->corners, space_);
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
template <class G, class S, class T>
void Mechanics<G, S, T>::evaluate_stress_ahead(NodalVelocity velocity, double ahead, bool and_forces) {
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
    Located elsewhere;  // where the points stand now, if they have moved since they were located
    const Located* at = &located_[b];
    Field* field = &field_of(b);
    const auto takes_heat = [&](std::size_t o) {
      return located_[o].field == located_[b].field && scene_.bodies[o].material->takes_heat();
    };
    bool only_gas = true;  // of its field: then the step has mapped its mass
    for (std::size_t o = 0; o < located_.size(); ++o) only_gas = only_gas && (o == b || !takes_heat(o));
    if (grid_density && (moved_ || (!alone_[at->field] && !only_gas))) {
      if (!own_field_) own_field_.emplace(grid_);
      field = &*own_field_;
      elsewhere.lowest.resize(located_[b].lowest.size());
      if (moved_) at = &elsewhere;
      map_own_mass(body, moved_ ? elsewhere : located_[b], *field);
    }
    if (grid_density) find_grid_density(*field, field == &field_of(b) ? gas_mass(*field) : field->mass, body);
    if (has_density && !grid_density && scene_.density != DensityMethod::continuity) {
      cell_density<dim>(grid_, body.points, scene_.density == DensityMethod::quadratic);
    }
    const bool rates_wanted = velocity != rate_of_, loss_wanted = pending_.loss;
    const std::vector<Vec>& nodal_velocity = rates_wanted ? straining_velocity(field_of(b), velocity)
                                                          : field_of(b).start;
    const bool elsewhere_wanted = grid_density && moved_;
    Wanted wanted;
    if (loss_wanted) wanted.loss = &field_of(b).start;
    if (rates_wanted) wanted.rates = &nodal_velocity;
    if (grid_density && !elsewhere_wanted) wanted.density = &field->density;
    wanted.specific = body.enclosure.has_value();
    const auto evaluate = [&](const Chunk& chunk) {
      const double lost = wanted.none() ? 0.0 : gather_start(body, located_[b], chunk, wanted);
      if (!elsewhere_wanted) body.material->evaluate_stress(body.points, {chunk.first, chunk.last}, then);
      return lost;
    };
    if (and_forces) {
      const StartSums sums = sum_over_chunks_writing_nodes<StartSums>(located_[b], [&](const Chunk& chunk) {
        const double lost = evaluate(chunk);
        return StartSums{lost, scatter_forces(body, located_[b], chunk, field_of(b))};
      });
      pending_.map_loss += sums.lost;
      hoop_force_ += sums.hoop_force;
      add_stress_turn(b);
      map_load(b);
    } else {
      pending_.map_loss += sum_over_chunks<double>(located_[b], evaluate);
    }
    if (elsewhere_wanted) {
      moved_ = false;  // weights of where the points stand now
      for_chunks(elsewhere, [&](const Chunk& chunk) {
        gather_start(body, elsewhere, chunk, {.density = &field->density, .specific = body.enclosure.has_value()});
        body.material->evaluate_stress(body.points, {chunk.first, chunk.last}, then);
      });
      moved_ = true;
    }
  }
  rate_of_ = velocity;
  pending_.loss = false;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::evaluate_stress(NodalVelocity velocity) {
  evaluate_stress_ahead(velocity, 0, false);
}

template <class G, class S, class T>
void Mechanics<G, S, T>::predict_stress(double ahead, NodalVelocity velocity) {
  evaluate_stress_ahead(velocity, ahead, false);  // [Leapfrog 2]
}

template <class G, class S, class T>
void Mechanics<G, S, T>::predict_stress_and_map_forces(double ahead) {
  if (moved_) return Stages::predict_stress_and_map_forces(ahead);
  settle_pending_strain();
  clear_forces();
  evaluate_stress_ahead(NodalVelocity::start, ahead, true);
  forces_mapped_ = true;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::map_own_mass(Body& body, Located& at, Field& field) {
  if (at.bins.bins() == 0) {
    place(body, at);
    at.bins.build(at.lowest, grid_.stride(dim - 1), block_height, false);
  }
  touch_alone(at, field);
  const bool frozen = std::exchange(moved_, false);
  for_chunks_writing_nodes(at,
                           [&](const Chunk& chunk) { scatter_mass_and_momentum<true, false>(body, at, chunk, field); });
  moved_ = frozen;
  walls_.fold_mass(field);
}

template <class G, class S, class T>
bool Mechanics<G, S, T>::reverse_cooling() {
  want_places("reverse_cooling");
  find_all_strain_rates(NodalVelocity::midpoint);
  int changed = 0;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    changed += sum_over_chunks<int>(located_[b], [&](const Chunk& chunk) {
      return body.material->reverse_cooling(body.points, {chunk.first, chunk.last}, context()) ? 1 : 0;
    });
  }
  return changed > 0;
}

}  // namespace plumbline
