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
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    Pack masses[nodes], momenta[nodes * dim];
    clear(masses);
    clear(momenta);
    const auto with_pack = [&](int p, int count) __attribute__((always_inline)) {
      const PackStencil weights = stencil(places, anchor, p);
      Pack shares[nodes];  // m N
      weights.find_weights(kept(load(mass + p), count), shares);
      for (int k = 0; with_mass && k < nodes; ++k) masses[k] += shares[k];
      for (int d = 0; d < dim; ++d) {
        const Pack v = load(velocity[d] + p);
        if constexpr (affine) {
          Pack slope[dim];
          for (int e = 0; e < dim; ++e) slope[e] = load(twist[d][e] + p);
          weights.spread_moment(shares, v, slope, momenta + d, dim);  // [EC-APIC 1]
        } else {
          for (int k = 0; k < nodes; ++k) momenta[k * dim + d] += shares[k] * v;  // [York 3.16]
        }
      }
    };
    for_packs(first, last, with_pack);
    if (with_mass) add_to_nodes<1>(print, masses, field.mass.data());
    add_to_nodes<dim>(print, momenta, component(field.momentum, 0));
  });
}

template <class G, class S>
void ShapeLoops<G, S>::take_pressure(const Columns& points, const At& at, const Chunk& chunk,
                                     const std::vector<double>& pressure, Field& field) const {
  if constexpr (!corrects) {
    Base::take_pressure(points, at, chunk, pressure, field);
  } else {
    const Places<dim> places = at.places(points, S::boxes);
    const double* volume = points(column::volume);
    for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
      BinNumbers even;
      Pack forces[nodes * dim];
      collect(print, pressure, even);
      clear(forces);
      for_packs(
          first, last, [&](int p, int count) __attribute__((always_inline)) {
            const PackStencil weights = stencil(places, anchor, p);
            const Pack here = weights.gather_array([&](int k) { return even[k]; }).value;
            weights.spread_divergence(kept(-load(volume + p), count) * here, forces, dim);
          });
      add_to_nodes<dim>(print, forces, component(field.force, 0));
    });
  }
}

template <class G, class S>
void ShapeLoops<G, S>::map_divergence(const Columns& points, const At& at, const Chunk& chunk,
                                      const std::vector<Vec>& velocity, std::vector<double>& sums) const {
  if constexpr (!corrects) {
    Base::map_divergence(points, at, chunk, velocity, sums);
  } else {
    const Places<dim> places = at.places(points, S::boxes);
    const double* volume = points(column::volume);
    for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
      BinVectors flow;
      Pack shares[nodes];
      collect(print, velocity, flow);
      clear(shares);
      for_packs(
          first, last, [&](int p, int count) __attribute__((always_inline)) {
            const PackStencil weights = stencil(places, anchor, p);
            Pack divergence = 0.0;
            for_directions<dim>([&](auto direction) __attribute__((always_inline)) {
              constexpr int d = direction;
              divergence += weights.gather_array([&](int k) { return flow[k][d]; }).gradient[d];
            });
            weights.spread(kept(load(volume + p), count) * divergence, shares, 1);
          });
      add_to_nodes<1>(print, shares, sums.data());
    });
  }
}

template <class G, class S>
template <StressMeasure measure, Shares shares>
double ShapeLoops<G, S>::map_forces(const Body& body, const At& at, const Chunk& chunk, Field& field) const {
  constexpr bool isotropic = measure == StressMeasure::pressure, full = measure == StressMeasure::full;
  constexpr int strains = stress_components(measure, dim, G::axisymmetric), normals = isotropic ? 1 : G::normals;
  const bool at_nodes = isotropic && !field.gas.pressure.empty();
  constexpr bool gas = shares != Shares::none, noise = shares == Shares::heat_and_sound;
  const Places<dim> places = at.places(body.points, S::boxes);
  const double *volume = body.points(column::volume), *mass = body.points(column::mass);
  const double* energy = gas ? body.points(column::energy) : nullptr;
  const double* sound = noise ? body.points(column::sound_speed) : nullptr;
  const double *stress[strains], *rate[strains];
  for (int k = 0; k < strains; ++k) {
    stress[k] = body.points(column::stress, k);
    rate[k] = body.points(column::strain_rate, k);
  }
  Pack hoop_force = 0.0;
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    Pack forces[nodes * dim], pressures[nodes], heats[nodes], closings[nodes], sounds[nodes];
    clear(forces);
    if constexpr (isotropic) clear(pressures);
    if constexpr (gas) {
      clear(heats);
      clear(closings);
    }
    if constexpr (noise) clear(sounds);
    const auto with_pack = [&](int p, int count) __attribute__((always_inline)) {
      const PackStencil weights = stencil(places, anchor, p);
      const Pack v = kept(-load(volume + p), count);
      Pack s[strains];
      for (int k = 0; k < strains; ++k) s[k] = v * load(stress[k] + p);
      if constexpr (G::axisymmetric && measure != StressMeasure::point_force) {
        const Pack hoop = kept(s[isotropic ? 0 : full ? dim * dim : 2] / load(places.x[0] + p), count);
        hoop_force += hoop;
        weights.spread(hoop, forces, dim);
      }
      if constexpr (isotropic) {
        if (at_nodes)
          weights.spread(s[0], pressures, 1);  // [Pressure 1]
        else
          weights.spread_divergence(s[0], forces, dim);
      } else if constexpr (measure == StressMeasure::point_force) {
        for (int d = 0; d < dim; ++d) weights.spread(s[d], forces + d, dim);
        if constexpr (G::axisymmetric)
          hoop_force += s[0];  // forces along the surface cancel; what is left is the hoops'
      } else {
        Pack flux[dim][dim];
        if constexpr (full) {
          for (int k = 0; k < dim * dim; ++k) flux[k / dim][k % dim] = s[k];
        } else {
          G::flux(s, flux);
        }
        for (int d = 0; d < dim; ++d) weights.spread_gradient(flux[d], forces + d, dim);
      }
      if constexpr (gas) {
        const Pack m = kept(load(mass + p), count);
        Pack divergence = load(rate[0] + p);
        for (int k = 1; k < normals; ++k) divergence += load(rate[k] + p);
        weights.spread(m * load(energy + p), heats, 1);
        weights.spread(m * max(-divergence, Pack(0.0)), closings, 1);
        if constexpr (noise) weights.spread(m * load(sound + p), sounds, 1);
      }
    };
    for_packs(first, last, with_pack);
    if (at_nodes)
      add_to_nodes<1>(print, pressures, field.gas.pressure.data());
    else
      add_to_nodes<dim>(print, forces, component(field.force, 0));
    if constexpr (gas) {
      add_to_nodes<1>(print, heats, field.gas.heat.data());
      add_to_nodes<1>(print, closings, field.gas.exchange.data());
    }
    if constexpr (noise) add_to_nodes<1>(print, sounds, field.gas.kept.data());
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
