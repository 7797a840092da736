// Strain rates, densities, stresses and their power.
#pragma once

#include "kernel/density/cell_density.hpp"
#include "kernel/engine/chunks.hpp"

namespace plumbline {

template <class G, class S, class T>
void Mechanics<G, S, T>::find_strain_rates(Body& body, const Located& at, const Chunk& chunk,
                                           const std::vector<Vec>& velocity) const {
  const auto x = places(body, at);
  const bool isotropic = body.material->isotropic();
  double* rates[G::strains];
  for (int k = 0; k < G::strains; ++k) rates[k] = body.points(column::strain_rate, isotropic ? 0 : k);
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    double u[nodes][dim];
    for_stencil_nodes(print, [&](int k, std::size_t i) {
      for (int d = 0; d < dim; ++d) u[k][d] = velocity[i][d];
    });
    for_packs(first, last, [&](int p, int count) {
      const PackStencil weights = stencil(x, anchor, p);
      Pack gradient[dim][dim], hoop_rate = 0.0;
      for (int d = 0; d < dim; ++d) {
        const auto jet = weights.gather_array([&](int k) { return u[k][d]; });
        for (int e = 0; e < dim; ++e) gradient[d][e] = jet.gradient[e];
        if constexpr (G::axisymmetric) {
          if (d == 0) hoop_rate = jet.value / load(x[0] + p);
        }
      }
      if (isotropic) {
        Pack divergence = gradient[0][0] + hoop_rate;
        for (int d = 1; d < dim; ++d) divergence += gradient[d][d];
        store(rates[0] + p, divergence, count);
      } else {
        Pack rate[G::strains];
        G::strain(gradient, hoop_rate, rate);  // [York 3.23]
        for (int k = 0; k < G::strains; ++k) store(rates[k] + p, rate[k], count);
      }
    });
  });
}

template <class G, class S, class T>
void Mechanics<G, S, T>::find_all_strain_rates(NodalVelocity which) {
  if (which == NodalVelocity::current) which = current_;
  if (which == rate_of_) return;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    const std::vector<Vec>& velocity = nodal(field_of(b), which);
    for_chunks(located_[b],
               [&](const Chunk& chunk) { find_strain_rates(scene_.bodies[b], located_[b], chunk, velocity); });
  }
  rate_of_ = which;
}

// dt sum_p V_p sigma_p : strain_rate_p
template <class G, class S, class T>
double Mechanics<G, S, T>::stress_power(const Body& body, PointRange range, double dt) const {
  const double* volume = body.points(column::volume);
  const bool isotropic = body.material->isotropic();
  Pack power = 0.0;
  const double *stress[G::strains], *rate[G::strains];
  for (int k = 0; k < G::strains; ++k) {
    stress[k] = body.points(column::stress, isotropic ? 0 : k);
    rate[k] = body.points(column::strain_rate, isotropic ? 0 : k);
  }
  for_packs(range.first, range.last, [&](int p, int count) {
    Pack dot = load(stress[0] + p) * load(rate[0] + p);
    for (int k = 1; !isotropic && k < G::strains; ++k) dot += load(stress[k] + p) * load(rate[k] + p);
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

// rho_i = M_i / |cell_i|. [EC-APIC 2]
template <class G, class S, class T>
void Mechanics<G, S, T>::find_grid_density(Field& field) const {
  field.for_touched(
      grid_, [&](std::size_t i) { field.density[i] = field.mass[i] * inverse_volume_[i]; }, options_.threads);
  walls_.extend_even(field, field.density);
}

// V_p = m_p / rho_p, rho_p = sum_i N_ip rho_i. [EC-APIC 2]
template <class G, class S, class T>
void Mechanics<G, S, T>::find_volumes(Body& body, const Located& at, const Chunk& chunk, const Field& field) const {
  const auto x = places(body, at);
  const double* mass = body.points(column::mass);
  double* volume = body.points(column::volume);
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    double rho[nodes];
    for_stencil_nodes(print, [&](int k, std::size_t i) { rho[k] = field.density[i]; });
    for_packs(first, last, [&](int p, int count) {
      const Pack density = stencil(x, anchor, p).gather_array([&](int k) { return rho[k]; }).value;
      store(volume + p, load(mass + p) / density, count);
    });
  });
}

// Densities by the scene's method, then stresses; where the grid's mass of this step is the body's own, it serves.
template <class G, class S, class T>
void Mechanics<G, S, T>::evaluate_stress(NodalVelocity velocity) {
  settle_power();
  survey_.reset();
  if (velocity == NodalVelocity::current) velocity = current_;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    const bool has_density = body.material->has_density();
    const bool grid_density = has_density && scene_.density == DensityMethod::grid;
    Located elsewhere;  // where the points stand now, if they have moved since they were located
    const Located* at = &located_[b];
    Field* field = &field_of(b);
    if (grid_density && (moved_ || !alone_[at->field])) {
      if (!own_field_) own_field_.emplace(grid_);
      field = &*own_field_;
      elsewhere.lowest.resize(located_[b].lowest.size());
      if (moved_) at = &elsewhere;
      map_own_mass(body, moved_ ? elsewhere : located_[b], *field);
    }
    if (grid_density) find_grid_density(*field);
    if (has_density && !grid_density && scene_.density != DensityMethod::continuity) {
      cell_density<dim>(grid_, body.points, scene_.density == DensityMethod::quadratic);
    }
    const std::vector<Vec>& nodal_velocity = nodal(field_of(b), velocity);
    const bool rates_wanted = velocity != rate_of_, loss_wanted = pending_.loss;
    const bool frozen = moved_;
    pending_.map_loss += sum_over_chunks<double>(located_[b], [&](const Chunk& chunk) {
      double lost = 0;
      if (loss_wanted) lost = find_map_loss(body, located_[b], chunk, field_of(b));
      if (rates_wanted) find_strain_rates(body, located_[b], chunk, nodal_velocity);
      if (grid_density && !frozen) find_volumes(body, *at, chunk, *field);
      if (!grid_density || !frozen) {
        body.material->evaluate_stress(body.points, {chunk.first, chunk.last}, context());
      }
      return lost;
    });
    if (grid_density && frozen) {
      moved_ = false;  // weights of where the points stand now
      for_chunks(elsewhere, [&](const Chunk& chunk) {
        find_volumes(body, elsewhere, chunk, *field);
        body.material->evaluate_stress(body.points, {chunk.first, chunk.last}, context());
      });
      moved_ = true;
    }
  }
  rate_of_ = velocity;
  pending_.loss = false;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::map_own_mass(Body& body, Located& at, Field& field) {
  if (at.bins.bins() == 0) {
    place(body, at);
    at.bins.build(at.lowest, grid_.stride(dim - 1), block_height, false);
  }
  std::fill(field.touched.begin(), field.touched.end(), std::pair<int, int>{0, 0});
  touch(at, field);
  walls_.include_mirrors(field.touched);
  field.for_touched(grid_, [&](std::size_t i) { field.mass[i] = 0; });
  const bool frozen = std::exchange(moved_, false);
  for_chunks_writing_nodes(at, [&](const Chunk& chunk) { scatter_mass_and_momentum(body, at, chunk, field, true, false); });
  moved_ = frozen;
  walls_.fold_mass(field);
}

template <class G, class S, class T>
bool Mechanics<G, S, T>::reverse_cooling() {
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
