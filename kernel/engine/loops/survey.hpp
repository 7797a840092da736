// What the ledger, the step limit and the checks read off the points.
#pragma once

#include <cmath>

#include "kernel/engine/loops/shape_loops.hpp"
#include "kernel/rotations.hpp"

namespace plumbline {

// What the material says of the points of a range, all of which stand on the grid or not.
inline void survey_material(const Body& body, PointRange range, int dim, bool on_grid, Survey& result) {
  const double stored = body.material->stored_energy(body.points, range);
  if (body.material->store() == Store::internal) result.totals.energy.internal = stored;
  if (body.material->store() == Store::elastic) {
    result.totals.energy.internal = body.material->heat(body.points, range);
    result.totals.energy.elastic = stored - result.totals.energy.internal;
  }
  result.bounds = body.material->step_bounds(body.points, range, dim);
  result.admissible = on_grid && body.material->first_fault(body.points, range).point < 0;
}

template <class G, class S>
template <bool affine>
Survey ShapeLoops<G, S>::survey(const Body& body, PointRange range) const {
  const Columns& points = body.points;
  const double* mass = points(column::mass);
  const double* half_size[dim] = {};
  for (int d = 0; S::boxes && d < dim; ++d) half_size[d] = points(column::half_size, d);
  const double *velocity[dim], *position[dim], *twist[dim][dim] = {};
  for (int d = 0; d < dim; ++d) {
    velocity[d] = points(column::velocity, d);
    position[d] = points(column::position, d);
    for (int e = 0; affine && e < dim; ++e) twist[d][e] = points(column::affine, d * dim + e);
  }
  Pack total = 0.0, kinetic = 0.0, scale = 0.0, angular_scale = 0.0, momentum[dim], angular[3] = {0.0, 0.0, 0.0};
  for (Pack& m : momentum) m = 0.0;
  bool inside = true;
  for_packs(range.first, range.last, [&](int p, int count) {
    const Pack m = kept(load(mass + p), count);
    Pack v[dim], x[dim], square = 0.0, distance = 0.0, inertia[dim], c[dim][dim];
    PackMask good = first_lanes(lanes);
    for (int d = 0; d < dim; ++d) {
      v[d] = load(velocity[d] + p);
      x[d] = load(position[d] + p);
      square += v[d] * v[d];
      distance += x[d] * x[d];
      momentum[d] += m * v[d];
      const double low = grid_.origin(d) - on_side * grid_.h();
      const double high = grid_.origin(d) + (grid_.cells(d) + on_side) * grid_.h();
      good = good && x[d] >= low && x[d] <= high && abs(v[d]) < HUGE_VAL;
    }
    inside = inside && all_of(good || !first_lanes(count));
    const Pack speed = sqrt(square);
    scale += m * speed;
    angular_scale += m * speed * sqrt(distance);
    if constexpr (affine) {
      for (int e = 0; e < dim; ++e) {
        const Pack cells = (x[e] - grid_.origin(e)) * per_h_;
        inertia[e] = inertia_at(cells, box(half_size[e], p)) * (grid_.h() * grid_.h());
        for (int d = 0; d < dim; ++d) {
          c[d][e] = load(twist[d][e] + p);
          square += inertia[e] * c[d][e] * c[d][e];
        }
      }
    }
    total += m;
    kinetic += 0.5 * m * square;
    for (int k = 0; k < rotations; ++k) {
      const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
      Pack turn = x[a] * v[b] - x[b] * v[a];
      if constexpr (affine) turn += inertia[a] * c[b][a] - inertia[b] * c[a][b];
      angular[k] += m * turn;
    }
  });
  Survey result;
  Totals& totals = result.totals;
  totals.mass = sum(total);
  totals.momentum_scale = sum(scale);
  totals.energy.kinetic = sum(kinetic);
  for (int d = 0; d < dim; ++d) totals.momentum[static_cast<std::size_t>(d)] = sum(momentum[d]);
  for (int k = 0; k < rotations; ++k) totals.angular_momentum[about + static_cast<std::size_t>(k)] = sum(angular[k]);
  if (rotations > 0) totals.angular_scale = sum(angular_scale);
  survey_material(body, range, dim, inside, result);
  return result;
}

}  // namespace plumbline
