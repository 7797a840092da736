// What the ledger, the step limit and the checks read off the points, along lists.
#pragma once

#include <cmath>

#include "kernel/engine/loops/list_loops.hpp"
#include "kernel/engine/loops/survey.hpp"

namespace plumbline {

template <class G>
Survey ListLoops<G>::survey(const Body& body, PointRange range) const {
  const Columns& points = body.points;
  const Reach here = transfer_.affine ? reach(points, range) : Reach{};
  Survey result;
  Totals& totals = result.totals;
  Turn turn{};
  bool inside = true;
  for (int p = range.first; p < range.last; ++p) {
    const double m = points(column::mass)[p];
    Vec x, v;
    for (int d = 0; d < dim; ++d) {
      x[d] = points(column::position, d)[p];
      v[d] = points(column::velocity, d)[p];
      totals.momentum[static_cast<std::size_t>(d)] += m * v[d];
      inside = inside && std::isfinite(v[d]);
    }
    inside = inside && on_grid(points, p);
    double square = v.squaredNorm();
    const double speed = std::sqrt(square);
    totals.mass += m;
    totals.momentum_scale += m * speed;
    if (rotations > 0) totals.angular_scale += m * speed * x.norm();
    Matrix spin = v * x.transpose();
    if (transfer_.affine) {
      Matrix twist;
      for (int k = 0; k < dim * dim; ++k) twist(k / dim, k % dim) = points(column::affine, k)[p];
      const Matrix moment = twist * inertia_of(here, p);
      square += (moment * twist.transpose()).trace();
      spin += moment;
    }
    totals.energy.kinetic += 0.5 * m * square;
    add_turn(m, spin, turn);
  }
  totals.angular_momentum = turn;
  survey_material(body, range, dim, inside, result);
  return result;
}

}  // namespace plumbline
