// What the ledger, the step limit and the checks read off the points between steps.
#pragma once

#include <cmath>
#include <numeric>

#include "kernel/engine/mechanics.hpp"

namespace plumbline {

template <class G>
const Survey& Mechanics<G>::surveyed() const {
  if (!survey_) {
    Survey all;
    for (std::size_t b = 0; b < located_.size(); ++b) {
      if (scene_.bodies[b].points.points() == 0) continue;
      all += sum_over_chunks<Survey>(located_[b].weights.bins, options_.threads, [&](const Chunk& chunk) {
        return loops_->survey(scene_.bodies[b], {chunk.first, chunk.last});
      });
    }
    all.totals.grid_mass = grid_mass_;
    survey_ = all;
  }
  return *survey_;
}

template <class G>
Totals Mechanics<G>::totals() const {
  return surveyed().totals;
}

template <class G>
void Mechanics<G>::check() const {
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

template <class G>
double Mechanics<G>::step_limit() const {
  const StepBounds& bounds = surveyed().bounds;
  double limit = HUGE_VAL;
  if (bounds.fastest > 0) limit = std::min(limit, grid_.h() / bounds.fastest);
  if (bounds.diffusivity > 0) limit = std::min(limit, grid_.h() * grid_.h() / (2 * dim * bounds.diffusivity));
  return limit;
}

// Until they are located, points of a body that has more or fewer of them than before count in the order they have.
template <class G>
void Mechanics<G>::points_added() {
  survey_.reset();
  places_known_ = false;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Weights<dim>& at = located_[b].weights;
    const auto points = static_cast<std::size_t>(scene_.bodies[b].points.points());
    at.bins_hold = false;
    if (at.lowest.size() == points) continue;
    at.lowest.assign(points, 0);
    std::iota(at.lowest.begin(), at.lowest.end(), 0);
    at.bins.build(at.lowest, grid_.stride(dim - 1), block_height, false);
  }
}

template <class G>
void Mechanics<G>::initialise() {
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

template <class G>
void Mechanics<G>::refresh_density() {
  initialise();
}

}  // namespace plumbline
