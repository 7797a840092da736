// What the ledger, the step limit and the checks read off the points between steps.
#pragma once

#include <cmath>

#include "kernel/engine/mechanics.hpp"

namespace plumbline {

template <class G>
const Survey& Mechanics<G>::surveyed() const {
  if (!survey_) {
    Survey all;
    for (std::size_t b = 0; b < bodies(); ++b) {
      if (scene_.bodies[b].points.points() == 0) continue;
      all += space_.template sum_over_chunks<Survey>(layout_.weights[b], [&](const Chunk& chunk) {
        return space_.loops->survey(scene_.bodies[b], {chunk.first, chunk.last});
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
      const double low = space_.grid.origin(d) - on_side * space_.grid.h();
      const double high = space_.grid.origin(d) + (space_.grid.cells(d) + on_side) * space_.grid.h();
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
  if (bounds.fastest > 0) limit = std::min(limit, space_.grid.h() / bounds.fastest);
  if (bounds.diffusivity > 0)
    limit = std::min(limit, space_.grid.h() * space_.grid.h() / (2 * dim * bounds.diffusivity));
  return limit;
}

}  // namespace plumbline
