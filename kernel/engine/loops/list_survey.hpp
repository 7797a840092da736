// What the ledger, the step limit and the checks read off the points, along lists.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "kernel/engine/loops/list_loops.hpp"
#include "kernel/engine/loops/survey.hpp"
#include "kernel/points/components.hpp"

namespace plumbline {

// 1 / s^2 at most, of the principal stretches s of the points: waves are 1 / s as fast among the places of the start as in space.
template <int dim>
double largest_shortening(const Columns& points, PointRange range) {
  if (!points.has(column::deformation_at_start)) return 1;
  using Matrix = Eigen::Matrix<double, dim, dim>;
  const Components<Matrix, const double> now(points, column::deformation),
      at_start(points, column::deformation_at_start);
  double largest = 0;
  for (int p = range.first; p < range.last; ++p) {
    const Matrix inverse = at_start[p] * now[p].inverse();
    largest = std::max(largest, (inverse * inverse.transpose()).cwiseAbs().rowwise().sum().maxCoeff());
  }
  return largest;
}

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
  if (points.has(column::position_at_start) && !body.material->bounds_at_start())
    result.bounds.fastest *= std::sqrt(largest_shortening<dim>(points, range));  // [Lagrangian 4]
  return result;
}

}  // namespace plumbline
