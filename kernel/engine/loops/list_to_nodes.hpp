// Points to nodes, along lists.
#pragma once

#include <algorithm>

#include "kernel/engine/loops/list_loops.hpp"

namespace plumbline {

template <class G>
void ListLoops<G>::map_motion(const Body& body, const At& at, const Chunk& chunk, bool with_mass, Field& field) const {
  const Columns& points = body.points;
  const Reach reached = reach(points, at.places(points, traits_.boxes), {chunk.first, chunk.last});
  for (int p = chunk.first; p < chunk.last; ++p) {
    const double m = points(column::mass)[p];
    Vec v;
    Matrix c = Matrix::Zero();
    for (int d = 0; d < dim; ++d) {
      v[d] = points(column::velocity, d)[p];
      for (int e = 0; transfer_.affine && e < dim; ++e) c(d, e) = points(column::affine, d * dim + e)[p];
    }
    for (const auto& [node, n, gradient] : reached.of(p)) {
      const auto i = static_cast<std::size_t>(node);
      if (with_mass) field.mass[i] += n * m;
      field.momentum[i] += n * m * (v + c * arm(reached, p, node));  // [York 3.16] [EC-APIC 1]
    }
  }
}

template <class G>
void ListLoops<G>::map_mass_and_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const {
  map_motion(body, at, chunk, true, field);
}

template <class G>
void ListLoops<G>::map_momentum(const Body& body, const At& at, const Chunk& chunk, Field& field) const {
  map_motion(body, at, chunk, false, field);
}

template <class G>
double ListLoops<G>::map_forces(const Body& body, const At& at, const Chunk& chunk, Shares shares, Field& field) const {
  const Columns& points = body.points;
  const StressMeasure measure = body.material->measure();
  const bool exchange = shares != Shares::none;
  const bool at_nodes = measure == StressMeasure::pressure && !field.gas.pressure.empty();
  const bool on_points = measure == StressMeasure::point_force, pressure = measure == StressMeasure::pressure,
             full = measure == StressMeasure::full;
  const int components = stress_components(measure, dim, G::axisymmetric), normals = pressure ? 1 : G::normals;
  const Reach reached = reach(points, at.places(points, traits_.boxes), {chunk.first, chunk.last});
  double hoop_force = 0;
  for (int p = chunk.first; p < chunk.last; ++p) {
    const double volume = points(column::volume)[p], m = points(column::mass)[p];
    double s[dim * dim + 1] = {}, hoop = 0, divergence = 0;
    for (int k = 0; k < components; ++k) s[k] = -volume * points(column::stress, k)[p];
    for (int k = 0; exchange && k < normals; ++k) divergence += points(column::strain_rate, k)[p];
    if (G::axisymmetric) {
      hoop = on_points ? s[0] : s[pressure ? 0 : full ? dim * dim : 2] / reached.place(p)[0];
      hoop_force += hoop;
    }
    Vec force = Vec::Zero();       // of each node, times N
    Matrix flux = Matrix::Zero();  // times grad N [York 3.17] [EC-APIC 4]
    if (on_points) {
      for (int d = 0; d < dim; ++d) force[d] = s[d];
    } else {
      if (G::axisymmetric) force[0] = hoop;
      if (pressure) flux = s[0] * Matrix::Identity();
      for (int k = 0; full && k < dim * dim; ++k) flux(k / dim, k % dim) = s[k];
      if (!pressure && !full) {
        double stress[G::strains], of[dim][dim];
        std::copy_n(s, G::strains, stress);
        G::flux(stress, of);
        for (int k = 0; k < dim * dim; ++k) flux(k / dim, k % dim) = of[k / dim][k % dim];
      }
    }
    for (const auto& [node, n, gradient] : reached.of(p)) {
      const auto i = static_cast<std::size_t>(node);
      if (at_nodes)
        field.gas.pressure[i] += n * s[0];  // [Pressure 1]
      else
        field.force[i] += n * force + flux * gradient;
      if (!exchange) continue;
      field.gas.heat[i] += n * m * points(column::energy)[p];
      field.gas.exchange[i] += n * m * std::max(0.0, -divergence);  // [Exchange 1]
      if (shares == Shares::heat_and_sound) field.gas.kept[i] += n * m * points(column::sound_speed)[p];
    }
  }
  return hoop_force;
}

template <class G>
void ListLoops<G>::spread(const Columns& points, const At& at, const Chunk& chunk, std::span<const Spread> all) const {
  const Reach reached = reach(points, at.places(points, traits_.boxes), {chunk.first, chunk.last});
  for (int p = chunk.first; p < chunk.last; ++p) {
    for (const Spread& one : all) {
      const double q = one.mass ? one.mass[p] * one.values[p] : one.values[p];
      for (const auto& [node, n, gradient] : reached.of(p)) one.nodes[node * one.stride] += n * q;
    }
  }
}

}  // namespace plumbline
