// Boxes of points, of shapes that are averages over them, and other columns of shapes that follow the points.
#pragma once

#include <algorithm>
#include <utility>

#include "kernel/engine/discretisation.hpp"
#include "kernel/ledger.hpp"
#include "kernel/pack.hpp"
#include "kernel/rotations.hpp"

namespace plumbline {

// They start as cubes of the points' spacing. deforming: they follow the deformation of points that carry one.
template <class G>
void add_boxes(Body& body, bool deforming) {
  if (body.points.has(column::half_size)) return;
  body.points.add(column::half_size, G::dim);
  const bool deform = deforming && body.points.has(column::deformation);
  if (deform) body.points.add(column::half_size_at_start, G::dim);
  for (int p = 0; p < body.points.points(); ++p) {
    const double half = 0.5 * point_spacing(body, p, G::dim, G::axisymmetric);
    for (int d = 0; d < G::dim; ++d) {
      body.points(column::half_size, d)[p] = half;
      if (deform) body.points(column::half_size_at_start, d)[p] = half;
    }
  }
}

// Of shapes whose weights are those of the start.
inline void add_places_at_start(Columns& points) {
  if (points.has(column::position_at_start)) return;
  const auto keep = [&](const ColumnId& now, const ColumnId& at_start) {
    points.add(at_start, points.components(now));
    const auto values = std::as_const(points).values(now);
    std::copy(values.begin(), values.end(), points.values(at_start).begin());
  };
  keep(column::position, column::position_at_start);
  if (points.has(column::deformation)) keep(column::deformation, column::deformation_at_start);
}

// A box follows its point's deformation by its second moments: l_d^2 = sum_e F_de^2 l0_e^2, whatever the rotation. With
// it changes the inertia of the point's affine velocity, whose energy and spin are booked. [GIMP 2]
template <class G>
void deform_boxes(const Discretisation<G>& space, Columns& points, Ledger& ledger) {
  constexpr int dim = G::dim;
  if (!space.shape.boxes || space.loops->follows() || !points.has(column::half_size_at_start)) return;
  const bool affine = space.transfer.affine;
  const double *mass = points(column::mass), *at_start[dim], *f[dim][dim], *twist[dim][dim] = {};
  double* half_size[dim];
  for (int d = 0; d < dim; ++d) {
    at_start[d] = points(column::half_size_at_start, d);
    half_size[d] = points(column::half_size, d);
    for (int e = 0; e < dim; ++e) {
      f[d][e] = points(column::deformation, d * dim + e);
      if (affine) twist[d][e] = points(column::affine, d * dim + e);
    }
  }
  Pack energy = 0.0, spin[3] = {0.0, 0.0, 0.0};
  for_packs(0, points.points(), [&](int p, int count) {
    Pack change[dim];  // of m D
    for (int d = 0; d < dim; ++d) {
      Pack before = 0.0, square = 0.0;
      if (affine) before = space.loops->pack_inertia(points, d, p, count);
      for (int e = 0; e < dim; ++e) {
        const Pack edge = load(f[d][e] + p) * load(at_start[e] + p);
        square += edge * edge;
      }
      store(half_size[d] + p, sqrt(square), count);  // [GIMP 2]
      if (affine) change[d] = load(mass + p) * (space.loops->pack_inertia(points, d, p, count) - before);
    }
    if (!affine) return;
    const auto c = [&](int d, int e) { return kept(load(twist[d][e] + p), count); };
    for (int d = 0; d < dim; ++d) {
      for (int e = 0; e < dim; ++e) energy += 0.5 * change[e] * c(d, e) * c(d, e);
    }
    for (int k = 0; k < G::rotations; ++k) {
      const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
      spin[k] += change[a] * c(b, a) - change[b] * c(a, b);
    }
  });
  ledger.energy.book(Flow::transfer, sum(energy));
  for (int k = 0; k < G::rotations; ++k) {
    ledger.angular_momentum[Discretisation<G>::about + static_cast<std::size_t>(k)].book(Flow::transfer, sum(spin[k]));
  }
}

// The same of columns that a shape sets itself.
template <class G>
void follow_points(const Discretisation<G>& space, Body& body, Ledger& ledger) {
  if (!space.loops->follows()) return;
  const PointRange all = all_points(body.points);
  const Totals before = space.loops->survey_motion(body, all);
  space.loops->follow(body.points);
  const Totals after = space.loops->survey_motion(body, all);
  ledger.energy.book(Flow::transfer, after.energy.kinetic - before.energy.kinetic);
  for (std::size_t k = 0; k < 3; ++k) {
    ledger.angular_momentum[k].book(Flow::transfer, after.angular_momentum[k] - before.angular_momentum[k]);
  }
}

}  // namespace plumbline
