// Points to grid, and the momentum equation on the grid.
#pragma once

#include "kernel/engine/chunks.hpp"

namespace plumbline {

template <class G, class S, class T>
void Mechanics<G, S, T>::scatter_mass_and_momentum(const Body& body, const Located& at, const Chunk& chunk,
                                                   Field& field, bool with_mass, bool with_momentum) const {
  const auto x = places(body, at);
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
      const PackStencil weights = stencil(x, anchor, p);
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

template <class G, class S, class T>
void Mechanics<G, S, T>::map_mass_and_momentum() {
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
  for (std::size_t b = 0; b < located_.size(); ++b) {
    for_chunks_writing_nodes(located_[b], [&](const Chunk& chunk) {
      scatter_mass_and_momentum(scene_.bodies[b], located_[b], chunk, field_of(b), true, true);
    });
  }
  for (Field& field : fields_) {
    double mass = 0;
    field.for_touched(grid_, [&](std::size_t i) { mass += field.own_mass[i] = field.mass[i]; });
    grid_mass_ += mass;
    walls_.fold_mass(field);
    WallAction<dim> action = walls_.fold(field, field.momentum);
    solve_velocity(field, field.start);
    if (!pistons_.none()) pending_.map_wall_work += pistons_.drive(grid_, field, field.start, action);
    if constexpr (!T::increments) {
      pending_.map_wall.linear += action.linear;
      pending_.map_wall.angular += action.angular;
    }
  }
  pending_.loss = !T::increments;
  current_ = NodalVelocity::start;
}

// sum_p m_p A_p with A_p = sum_i N_ip |v_p + C_p (x_i - x_p) - v_i|^2 / 2, as the sum of three terms that are never
// negative: what v_p and C_p differ by from the grid's, and what of the grid's velocity is not affine. [EC-APIC 1]
template <class G, class S, class T>
double Mechanics<G, S, T>::find_map_loss(Body& body, const Located& at, const Chunk& chunk, const Field& field) const {
  const auto x = places(body, at);
  const double* mass = body.points(column::mass);
  const double *velocity[dim], *affine[dim][dim] = {};
  for (int d = 0; d < dim; ++d) {
    velocity[d] = body.points(column::velocity, d);
    for (int e = 0; T::affine && e < dim; ++e) affine[d][e] = body.points(column::affine, d * dim + e);
  }
  double* loss = body.points.has(column::transfer_loss) ? body.points(column::transfer_loss) : nullptr;
  Pack total = 0.0;
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    const BinVelocity bin = bin_velocity(print, field.start);
    for_packs(first, last, [&](int p, int count) {
      const PackStencil weights = stencil(x, anchor, p);
      Pack inertia[dim];
      for (int d = 0; d < dim; ++d) inertia[d] = weights.inertia(d);
      Pack spread = weights.gather_array([&](int k) { return bin.square[k]; }).value, apart = 0.0;
      for (int d = 0; d < dim; ++d) {
        const auto u = weights.gather_array([&](int k) { return bin.u[k][d]; });
        const Pack off = load(velocity[d] + p) - bin.base[d] - u.value;
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

template <class G, class S, class T>
void Mechanics<G, S, T>::settle_loss() {
  if (!pending_.loss) return;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    pending_.map_loss += sum_over_chunks<double>(located_[b], [&](const Chunk& chunk) {
      return find_map_loss(scene_.bodies[b], located_[b], chunk, field_of(b));
    });
  }
  pending_.loss = false;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::map_momentum() {
  for (Field& field : fields_) field.for_touched(grid_, [&](std::size_t i) { field.momentum[i].setZero(); });
  for (std::size_t b = 0; b < located_.size(); ++b) {
    for_chunks_writing_nodes(located_[b], [&](const Chunk& chunk) {
      scatter_mass_and_momentum(scene_.bodies[b], located_[b], chunk, field_of(b), false, true);
    });
  }
  for (Field& field : fields_) {
    walls_.fold(field, field.momentum);
    solve_velocity(field, field.remapped);  // [York 3.24]
    WallAction<dim> not_kept;
    if (!pistons_.none()) pistons_.drive(grid_, field, field.remapped, not_kept);
  }
  current_ = NodalVelocity::remapped;
  if (rate_of_ == NodalVelocity::remapped) rate_of_ = NodalVelocity::current;
}

// -sum_p V_p sigma_p grad N_ip [York 3.17] [EC-APIC 4]; returns what hoop stress adds to the radial momentum, N.
template <class G, class S, class T>
double Mechanics<G, S, T>::scatter_forces(const Body& body, const Located& at, const Chunk& chunk, Field& field) const {
  const auto x = places(body, at);
  const double* volume = body.points(column::volume);
  const bool isotropic = body.material->isotropic();
  const double* stress[G::strains];
  for (int k = 0; k < G::strains; ++k) stress[k] = body.points(column::stress, isotropic ? 0 : k);
  Pack hoop_force = 0.0;
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    Pack sums[nodes * dim];
    for (Pack& s : sums) s = 0.0;
    for_packs(first, last, [&](int p, int count) {
      const PackStencil weights = stencil(x, anchor, p);
      const Pack v = kept(load(volume + p), count);
      Pack flux[dim][dim], s[G::strains];
      if (isotropic) {
        const Pack pressure = -v * load(stress[0] + p);
        for (int d = 0; d < dim; ++d) {
          for (int e = 0; e < dim; ++e) flux[d][e] = d == e ? pressure : Pack(0.0);
        }
        for (Pack& component : s) component = pressure;
      } else {
        for (int k = 0; k < G::strains; ++k) s[k] = -v * load(stress[k] + p);
        G::flux(s, flux);
      }
      for (int d = 0; d < dim; ++d) {
        Pack hoop = 0.0;
        if constexpr (G::axisymmetric) {
          if (d == 0) {
            hoop = kept(s[G::hoop] / load(x[0] + p), count);
            hoop_force += hoop;
          }
        }
        weights.spread_gradient(hoop, flux[d], sums + d, dim);
      }
    });
    add_to_nodes<dim>(print, sums, [&](std::size_t i, const double* total) {
      for (int d = 0; d < dim; ++d) field.force[i][d] += total[d];
    });
  });
  return sum(hoop_force);
}

template <class G, class S, class T>
void Mechanics<G, S, T>::map_forces() {
  settle_pending_strain();
  hoop_force_ = 0;
  for (Field& field : fields_) {
    field.for_touched(grid_, [&](std::size_t i) { field.force[i].setZero(); }, options_.threads);
  }
  for (std::size_t b = 0; b < located_.size(); ++b) {
    const Located& at = located_[b];
    std::vector<double> hoop(G::axisymmetric ? at.bins.chunks().size() : 0);
    for_chunks_writing_nodes(at, [&](const Chunk& chunk) {
      const double force = scatter_forces(scene_.bodies[b], at, chunk, field_of(b));
      if (G::axisymmetric) hoop[static_cast<std::size_t>(&chunk - at.bins.chunks().data())] = force;
    });
    hoop_force_ += pairwise_sum(hoop.data(), hoop.size());
  }
  forces_mapped_ = true;
}

// Body forces fold like all others: what a point puts on a ghost node pulls the mirror node the other way.
template <class G, class S, class T>
void Mechanics<G, S, T>::add_body_force(Field& field, double dt) {
  if (gravity_.isZero(0)) return;
  field.for_touched(grid_, [&](std::size_t i) {
    const Vec f = field.own_mass[i] * gravity_;  // [York 3.18]
    field.force[i] += f;
    pending_.body += dt * f;
    pending_.body_angular += dt * cross<dim>(grid_.position(static_cast<int>(i)), f);
  });
}

template <class G, class S, class T>
void Mechanics<G, S, T>::advance_momentum(double dt) {
  pending_.wall = {};
  pending_.body.setZero();
  pending_.body_angular.setZero();
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
          const Vec dv = m > least_mass ? Vec(dt / m * field.force[i]) : Vec(Vec::Zero());
          field.end[i] = field.start[i] + dv;  // [York 3.19, 3.20]
          field.midpoint[i] = field.start[i] + 0.5 * dv;
        },
        options_.threads);
    walls_.extend(field, field.end);
    walls_.extend(field, field.midpoint);
    if (!pistons_.none()) {
      pending_.wall_work += pistons_.drive(grid_, field, field.end, pending_.wall);
      WallAction<dim> counted;
      pistons_.drive(grid_, field, field.midpoint, counted);
    }
    if (gravity_.isZero(0)) continue;
    field.for_touched(
        grid_, [&](std::size_t i) { pending_.body_work += dt * field.own_mass[i] * gravity_.dot(field.midpoint[i]); });
  }
  pending_.wall.linear[0] += dt * hoop_force_;
  current_ = NodalVelocity::end;
  rate_of_ = NodalVelocity::current;
  pending_.power = true;
  pending_.dt = dt;
}

}  // namespace plumbline
