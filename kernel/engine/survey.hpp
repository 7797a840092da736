// What the ledger, the step limit and the checks read off the points between steps.
#pragma once

#include <cmath>
#include <numeric>

#include "kernel/engine/chunks.hpp"
#include "kernel/rotations.hpp"

namespace plumbline {

template <class G, class S, class T>
auto Mechanics<G, S, T>::Survey::operator+=(const Survey& o) -> Survey& {
  totals += o.totals;
  bounds.include(o.bounds);
  admissible = admissible && o.admissible;
  return *this;
}

template <class G, class S, class T>
auto Mechanics<G, S, T>::survey(const Body& body, PointRange range) const -> Survey {
  const Columns& points = body.points;
  const double* mass = points(column::mass);
  Places places;
  for (int d = 0; S::boxes && d < dim; ++d) places.half_size[d] = points(column::half_size, d);
  const double *velocity[dim], *position[dim], *affine[dim][dim] = {};
  for (int d = 0; d < dim; ++d) {
    velocity[d] = points(column::velocity, d);
    position[d] = points(column::position, d);
    for (int e = 0; T::affine && e < dim; ++e) affine[d][e] = points(column::affine, d * dim + e);
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
    if constexpr (T::affine) {
      for (int e = 0; e < dim; ++e) {
        const Pack cells = (x[e] - grid_.origin(e)) * (1 / grid_.h());
        inertia[e] = inertia_at(cells, box(places, e, p)) * (grid_.h() * grid_.h());
        for (int d = 0; d < dim; ++d) {
          c[d][e] = load(affine[d][e] + p);
          square += inertia[e] * c[d][e] * c[d][e];
        }
      }
    }
    total += m;
    kinetic += 0.5 * m * square;
    for (int k = 0; k < rotations; ++k) {
      const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
      Pack turn = x[a] * v[b] - x[b] * v[a];
      if constexpr (T::affine) turn += inertia[a] * c[b][a] - inertia[b] * c[a][b];
      angular[k] += m * turn;
    }
  });
  Survey result;
  Totals& totals = result.totals;
  totals.mass = sum(total);
  totals.momentum_scale = sum(scale);
  totals.energy.kinetic = sum(kinetic);
  for (int d = 0; d < dim; ++d) totals.momentum[static_cast<std::size_t>(d)] = sum(momentum[d]);
  const std::size_t about = dim == 2 ? 2 : 0;
  for (int k = 0; k < rotations; ++k) totals.angular_momentum[about + static_cast<std::size_t>(k)] = sum(angular[k]);
  if (rotations > 0) totals.angular_scale = sum(angular_scale);
  const double stored = body.material->stored_energy(points, range);
  if (body.material->store() == Store::internal) totals.energy.internal = stored;
  if (body.material->store() == Store::elastic) totals.energy.elastic = stored;
  result.bounds = body.material->step_bounds(points, range, dim);
  result.admissible = inside && body.material->first_fault(points, range).point < 0;
  return result;
}

template <class G, class S, class T>
auto Mechanics<G, S, T>::surveyed() const -> const Survey& {
  if (!survey_) {
    Survey all;
    for (std::size_t b = 0; b < located_.size(); ++b) {
      if (scene_.bodies[b].points.points() == 0) continue;
      all += sum_over_chunks<Survey>(located_[b], [&](const Chunk& chunk) {
        return survey(scene_.bodies[b], {chunk.first, chunk.last});
      });
    }
    all.totals.grid_mass = grid_mass_;
    survey_ = all;
  }
  return *survey_;
}

template <class G, class S, class T>
Totals Mechanics<G, S, T>::totals() const {
  return surveyed().totals;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::check() const {
  if (surveyed().admissible) return;
  for (const Body& body : scene_.bodies) {
    const auto stop = [&](int p, const std::string& field, double value, const std::string& reason) {
      throw InadmissibleState(reason, body.name, body.id[static_cast<std::size_t>(p)], field, value);
    };
    for (int d = 0; d < dim; ++d) {
      const double *x = body.points(column::position, d), *v = body.points(column::velocity, d);
      const double low = grid_.origin(d) - on_side * grid_.h();
      const double high = grid_.origin(d) + (grid_.cells(d) + on_side) * grid_.h();
      for (int p = 0; p < body.points.points(); ++p) {
        if (!std::isfinite(v[p])) stop(p, column::velocity.name(), v[p], "the velocity must be finite");
        if (x[p] >= low && x[p] <= high) continue;
        stop(p, column::position.name(), x[p],
             std::isfinite(x[p]) ? "a point left the grid" : "the position must be finite");
      }
    }
    const Material::Fault fault = body.material->first_fault(body.points, all_points(body.points));
    if (fault.point >= 0) stop(fault.point, fault.field, fault.value, fault.reason);
  }
}

template <class G, class S, class T>
double Mechanics<G, S, T>::step_limit() const {
  const StepBounds& bounds = surveyed().bounds;
  double limit = HUGE_VAL;
  if (bounds.fastest > 0) limit = std::min(limit, grid_.h() / bounds.fastest);
  if (bounds.diffusivity > 0) limit = std::min(limit, grid_.h() * grid_.h() / (2 * dim * bounds.diffusivity));
  return limit;
}

// Until they are located, points of a body that has more or fewer of them than before count in the order they have.
template <class G, class S, class T>
void Mechanics<G, S, T>::points_added() {
  survey_.reset();
  places_known_ = false;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Located& at = located_[b];
    const auto points = static_cast<std::size_t>(scene_.bodies[b].points.points());
    at.bins_hold = false;
    if (at.lowest.size() == points) continue;
    at.lowest.assign(points, 0);
    std::iota(at.lowest.begin(), at.lowest.end(), 0);
    at.bins.build(at.lowest, grid_.stride(dim - 1), block_height, false);
  }
}

template <class G, class S, class T>
void Mechanics<G, S, T>::initialise() {
  survey_.reset();
  for (Body& body : scene_.bodies) {
    if (!options_.evaluates_stress_first) continue;
    const auto rates = body.points.values(column::strain_rate);  // of points as they stood before they were sorted
    std::fill(rates.begin(), rates.end(), 0.0);
  }
  locate_points();
  map_mass_and_momentum();
  rate_of_ = NodalVelocity::start;  // the rates that the points carry serve
  pending_.loss = false;
  evaluate_stress(NodalVelocity::start);
  for (Body& body : scene_.bodies) body.material->describe(body.points);
}

template <class G, class S, class T>
void Mechanics<G, S, T>::refresh_density() {
  initialise();
}

}  // namespace plumbline
