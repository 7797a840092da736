// Points to nodes.
#pragma once

#include "kernel/engine/loops/shape_loops.hpp"

namespace plumbline {

template <class G, class S>
template <bool affine, bool with_mass>
void ShapeLoops<G, S>::map_motion(const Body& body, const At& at, const Chunk& chunk, Field& field) const {
  const Places<dim> places = at.places(body.points, S::boxes);
  const double* mass = body.points(column::mass);
  const double *velocity[dim], *twist[dim][dim] = {};
  for (int d = 0; d < dim; ++d) {
    velocity[d] = body.points(column::velocity, d);
    for (int e = 0; affine && e < dim; ++e) twist[d][e] = body.points(column::affine, d * dim + e);
  }
  constexpr int parts = 1 + dim;
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    Pack sums[nodes * parts];
    for (Pack& s : sums) s = 0.0;
    for_packs(first, last, [&](int p, int count) {
      const PackStencil weights = stencil(places, anchor, p);
      const Pack m = kept(load(mass + p), count);
      if (with_mass) weights.spread(m, sums, parts);
      for (int d = 0; d < dim; ++d) {
        const Pack momentum = m * load(velocity[d] + p);
        if constexpr (affine) {
          Pack slope[dim];
          for (int e = 0; e < dim; ++e) slope[e] = m * load(twist[d][e] + p);
          weights.spread_moment(momentum, slope, sums + 1 + d, parts);  // [EC-APIC 1]
        } else {
          weights.spread(momentum, sums + 1 + d, parts);  // [York 3.16]
        }
      }
    });
    add_to_nodes<parts>(print, sums, [&](std::size_t i, const double* total) {
      if (with_mass) field.mass[i] += total[0];
      for (int d = 0; d < dim; ++d) field.momentum[i][d] += total[1 + d];
    });
  });
}

template <class G, class S>
template <StressMeasure measure, Shares shares>
double ShapeLoops<G, S>::map_forces(const Body& body, const At& at, const Chunk& chunk, Field& field) const {
  constexpr bool isotropic = measure == StressMeasure::pressure, full = measure == StressMeasure::full;
  constexpr int strains = stress_components(measure, dim, G::axisymmetric), normals = isotropic ? 1 : G::normals;
  constexpr int parts = dim + (shares == Shares::none ? 0 : shares == Shares::heat ? 2 : 3);
  const Places<dim> places = at.places(body.points, S::boxes);
  const double *volume = body.points(column::volume), *mass = body.points(column::mass);
  const double* energy = parts > dim ? body.points(column::energy) : nullptr;
  const double* sound = parts > dim + 2 ? body.points(column::sound_speed) : nullptr;
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
      if constexpr (parts > dim) {
        const Pack m = kept(load(mass + p), count);
        Pack divergence = load(rate[0] + p);
        for (int k = 1; k < normals; ++k) divergence += load(rate[k] + p);
        weights.spread(m * load(energy + p), sums + dim, parts);
        weights.spread(m * max(-divergence, Pack(0.0)), sums + dim + 1, parts);
        if constexpr (parts > dim + 2) weights.spread(m * load(sound + p), sums + dim + 2, parts);
      }
    });
    add_to_nodes<parts>(print, sums, [&](std::size_t i, const double* total) {
      for (int d = 0; d < dim; ++d) field.force[i][d] += total[d];
      if constexpr (parts > dim) {
        field.heat[i] += total[dim];
        field.exchange[i] += total[dim + 1];
      }
      if constexpr (parts > dim + 2) field.kept[i] += total[dim + 2];
    });
  });
  return sum(hoop_force);
}

template <class G, class S>
template <StressMeasure measure>
double ShapeLoops<G, S>::map_forces_of_gas(const Body& body, const At& at, const Chunk& chunk, Shares shares,
                                           Field& field) const {
  switch (shares) {
    case Shares::heat:
      return map_forces<measure, Shares::heat>(body, at, chunk, field);
    case Shares::heat_and_sound:
      return map_forces<measure, Shares::heat_and_sound>(body, at, chunk, field);
    default:
      return map_forces<measure, Shares::none>(body, at, chunk, field);
  }
}

template <class G, class S>
double ShapeLoops<G, S>::map_forces(const Body& body, const At& at, const Chunk& chunk, Shares shares,
                                    Field& field) const {
  switch (body.material->measure()) {
    case StressMeasure::pressure:
      return map_forces_of_gas<StressMeasure::pressure>(body, at, chunk, shares, field);
    case StressMeasure::full:
      return map_forces<StressMeasure::full, Shares::none>(body, at, chunk, field);
    case StressMeasure::point_force:
      return map_forces<StressMeasure::point_force, Shares::none>(body, at, chunk, field);
    default:
      return map_forces_of_gas<StressMeasure::symmetric>(body, at, chunk, shares, field);
  }
}

}  // namespace plumbline
