// What points with corners take from the nodes, and what the ledger reads off them.
#pragma once

#include <cmath>

#include "kernel/engine/loops/corner_loops.hpp"
#include "kernel/engine/loops/survey.hpp"

namespace plumbline {

template <class G>
[[gnu::always_inline]] inline void CornerLoops<G>::store_strain_rates(const RateColumns& rates, int p,
                                                                      const CornerWeights::Jet& jet, double radius) {
  const double hoop = G::axisymmetric ? jet.value[0] / radius : 0;
  if (rates.full) {
    for (int k = 0; k < dim * dim; ++k) rates.at[k][p] = jet.gradient(k / dim, k % dim);
    if (G::axisymmetric) rates.at[dim * dim][p] = hoop;
    return;
  }
  double gradient[dim][dim], rate[G::strains];
  for (int k = 0; k < dim * dim; ++k) gradient[k / dim][k % dim] = jet.gradient(k / dim, k % dim);
  G::strain(gradient, hoop, rate);  // [York 3.23]
  for (int k = 0; k < G::strains; ++k) rates.at[k][p] = rate[k];
}

template <class G>
double CornerLoops<G>::gather_start(Body& body, const At& at, const Chunk& chunk, const Wanted& wanted) const {
  if (!side_by_side(body) || wanted.density || wanted.closing) return Lists::gather_start(body, at, chunk, wanted);
  const MovingColumns<const double> from(body.points);
  const RateColumns rates(body);
  const double* radius = at.places(body.points, true).x[0];
  const double* start = wanted.loss ? wanted.loss->front().data() : nullptr;
  const double* strained = wanted.rates ? wanted.rates->front().data() : nullptr;
  double* loss = body.points.has(column::transfer_loss) ? body.points(column::transfer_loss) : nullptr;
  double total = 0;
  for_points(
      body.points, at, chunk, [&](int p, const CornerWeights& weights) __attribute__((always_inline)) {
        if (strained) store_strain_rates(rates, p, weights.jet(strained), domains_.radius(radius[p]));
        if (!start) return;
        const CornerWeights::Moments u = weights.moments(start);
        const Matrix inertia = weights.inertia(), taken = u.moment * inverse(inertia), off = from.affine[p] - taken;
        const double apart = (from.velocity[p] - u.value).squaredNorm() + affine_square(off, inertia);
        const double spread = u.spread - affine_square(taken, inertia);
        const double lost = 0.5 * from.mass[p] * (apart + std::max(spread, 0.0));  // [EC-APIC 1]
        if (loss) loss[p] = lost;
        total += lost;
      });
  return total;
}

template <class G>
MotionSums CornerLoops<G>::gather_motion(Body& body, const At& at, const Chunk& chunk, const Field& field,
                                         const Motion& motion) const {
  if (!side_by_side(body) || motion.exchange || motion.beyond || !field.gas.kept.empty())
    return Lists::gather_motion(body, at, chunk, field, motion);
  Columns& points = body.points;
  MovingColumns<double> to(points);
  const RateColumns rates(body);
  const DomainEdges<dim> edges(points);
  const CellRange all = all_cells();
  const double* const x[] = {points(column::position, 0), points(column::position, 1)};
  const double* radius = at.places(points, true).x[0];
  const double* straining = motion.straining ? motion.straining->front().data() : nullptr;
  const double* carrying = motion.carrying ? motion.carrying->front().data() : nullptr;
  const double* end = field.end.front().data();
  double* loss = points.has(column::transfer_loss) ? points(column::transfer_loss) : nullptr;
  MotionSums sums;
  for_points(
      points, at, chunk, [&](int p, const CornerWeights& weights) __attribute__((always_inline)) {
        const CornerWeights::Moments u = weights.moments(end);
        Vec carried = u.value;
        if (straining) {
          const CornerWeights::Jet jet = weights.jet(straining);
          store_strain_rates(rates, p, jet, domains_.radius(radius[p]));
          if (carrying == straining) carried = jet.value;
        }
        if (carrying && carrying != straining) carried = weights.value(carrying);
        const Matrix twist = u.moment * inverse(weights.inertia());  // [EC-APIC 5]
        const Vec step = motion.drift ? Vec(*motion.drift * u.value) : Vec(motion.dt * carried);
        if (sums.too_far < 0 && !(step.cwiseAbs().maxCoeff() <= this->grid().h())) sums.too_far = p;
        const double m = to.mass[p];
        to.velocity.set(p, u.value);
        to.position.set(p, to.position[p] + step);  // [York 3.21]
        to.affine.set(p, twist);
        // With the inertia of the new place: where that is another, so are the energy and the spin of the affine part.
        const Matrix there = this->weights(x, edges, p, all).inertia();
        add_spin(m, u.moment - twist * there, sums.torque);
        if (!motion.drift) add_spin(m * motion.dt, u.value * carried.transpose(), sums.moved);
        const double given = 0.5 * m * (u.spread - affine_square(twist, there));
        if (loss) loss[p] += given;
        sums.lost += given;
      });
  return sums;
}

// Mass, momenta and kinetic energy of a range. inside: whether all so far stand on the grid.
template <class G>
void CornerLoops<G>::sum_motion(const Body& body, PointRange range, Totals& totals, bool& inside) const {
  const Columns& points = body.points;
  const MovingColumns<const double> from(points);
  const DomainEdges<dim> edges(points);
  const CellRange all = all_cells();
  const double* const place[] = {points(column::position, 0), points(column::position, 1)};
  for (int p = range.first; p < range.last; ++p) {
    const double m = from.mass[p];
    const Vec x = from.position[p], v = from.velocity[p];
    const Matrix twist = from.affine[p], inertia = weights(place, edges, p, all).inertia();
    const double square = v.squaredNorm(), speed = std::sqrt(square);
    inside = inside && std::isfinite(square) && this->on_grid(points, p);
    totals.mass += m;
    for (int d = 0; d < dim; ++d) totals.momentum[static_cast<std::size_t>(d)] += m * v[d];
    totals.momentum_scale += m * speed;
    if (rotations > 0) totals.angular_scale += m * speed * x.norm();
    totals.energy.kinetic += 0.5 * m * (square + affine_square(twist, inertia));
    add_spin(m, v * x.transpose() + twist * inertia, totals.angular_momentum);
  }
}

template <class G>
Survey CornerLoops<G>::survey(const Body& body, PointRange range) const {
  if (!side_by_side(body)) return Lists::survey(body, range);
  Survey result;
  bool inside = true;
  sum_motion(body, range, result.totals, inside);
  survey_material(body, range, dim, inside, result);
  return result;
}

template <class G>
Totals CornerLoops<G>::survey_motion(const Body& body, PointRange range) const {
  if (!side_by_side(body)) return Lists::survey_motion(body, range);
  Totals totals;
  bool inside = true;
  sum_motion(body, range, totals, inside);
  return totals;
}

}  // namespace plumbline
