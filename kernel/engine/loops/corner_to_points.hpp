// What points with corners take from the nodes, and what the ledger reads off them.
#pragma once

#include <cmath>

#include "kernel/engine/loops/corner_loops.hpp"
#include "kernel/engine/loops/survey.hpp"

namespace plumbline {

template <class G>
[[gnu::always_inline]] inline void CornerLoops<G>::store_strain_rates(const RateColumns& rates, int p,
                                                                      const CornerWeights::Jet& jet, double radius) {
  const double hoop = G::axisymmetric ? jet.value.x / radius : 0;
  const double gradient[dim][dim] = {{jet.gradient.xx, jet.gradient.xy}, {jet.gradient.yx, jet.gradient.yy}};
  if (rates.full) {
    for (int k = 0; k < dim * dim; ++k) rates.at[k][p] = gradient[k / dim][k % dim];
    if (G::axisymmetric) rates.at[dim * dim][p] = hoop;
    return;
  }
  double rate[G::strains];
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
  const double* strained = wanted.rates ? wanted.rates.velocity->front().data() : nullptr;
  double* loss = body.points.has(column::transfer_loss) ? body.points(column::transfer_loss) : nullptr;
  double total = 0;
  for_points(
      body.points, at, chunk, [&](int p, const CornerWeights& weights) __attribute__((always_inline)) {
        if (strained) store_strain_rates(rates, p, weights.jet(strained), domains_.radius(radius[p]));
        if (!start) return;
        const CornerWeights::Moments u = weights.moments(start);
        const Square inertia = weights.inertia(), taken = u.moment * inertia.inverse(), off = from.affine(p) - taken;
        const Two v = from.velocity(p), slip{v.x - u.value.x, v.y - u.value.y};
        const double apart = slip.square() + affine_square(off, inertia);
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
  const MovingColumns<double> to(points);
  const RateColumns rates(body);
  const EdgeColumns edges(points);
  const double* const x[] = {to.x[0], to.x[1]};
  const double* radius = at.places(points, true).x[0];
  const double* straining = motion.straining ? motion.straining.velocity->front().data() : nullptr;
  const double* carrying = motion.carrying ? motion.carrying->front().data() : nullptr;
  const double* end = field.end.front().data();
  double* loss = points.has(column::transfer_loss) ? points(column::transfer_loss) : nullptr;
  const double dt = motion.drift.value_or(motion.dt), h = this->grid().h();
  MotionSums sums;
  for_points(
      points, at, chunk, [&](int p, const CornerWeights& weights) __attribute__((always_inline)) {
        const CornerWeights::Moments u = weights.moments(end);
        Two carried = u.value;
        if (straining) {
          const CornerWeights::Jet jet = weights.jet(straining);
          store_strain_rates(rates, p, jet, domains_.radius(radius[p]));
          if (carrying == straining) carried = jet.value;
        }
        if (carrying && carrying != straining) carried = weights.value(carrying);
        const Square here = weights.inertia(), taken = u.moment * here.inverse();  // [EC-APIC 5]
        const Two own = motion.drift ? u.value : carried, step{dt * own.x, dt * own.y};
        if (sums.too_far < 0 && !(std::abs(step.x) <= h && std::abs(step.y) <= h)) sums.too_far = p;
        const double m = to.mass[p];
        to.v[0][p] = u.value.x;
        to.v[1][p] = u.value.y;
        to.x[0][p] += step.x;  // [York 3.21]
        to.x[1][p] += step.y;
        // With the inertia of the new place the energy of the affine part stays, its spin does not.
        const Square there = inertia_of(x, edges, p);
        const double share = Lists::kept_share(affine_square(taken, here), affine_square(taken, there));  // [CPDI 5]
        const Square twist = taken.times(share);
        to.c[0][p] = twist.xx;
        to.c[1][p] = twist.xy;
        to.c[2][p] = twist.yx;
        to.c[3][p] = twist.yy;
        add_spin(m, u.moment - twist * there, sums.torque);
        if (!motion.drift) add_spin(m * motion.dt, outer(u.value, carried), sums.moved);
        const double given = 0.5 * m * (u.spread - affine_square(twist, there));
        if (loss) loss[p] += given;
        sums.lost += given;
      });
  return sums;
}

// Mass, momenta and kinetic energy of a range. inside: whether all so far stand on the grid.
template <class G>
void CornerLoops<G>::sum_motion(const Body& body, PointRange range, Totals& totals, bool& inside) const {
  const MovingColumns<const double> from(body.points);
  const EdgeColumns edges(body.points);
  for (int p = range.first; p < range.last; ++p) {
    const double m = from.mass[p];
    const Two x{from.x[0][p], from.x[1][p]}, v = from.velocity(p);
    const Square twist = from.affine(p), inertia = inertia_of(from.x, edges, p);
    const double square = v.square(), speed = std::sqrt(square);
    inside = inside && std::isfinite(square) && on_grid(from.x, p);
    totals.mass += m;
    totals.momentum[0] += m * v.x;
    totals.momentum[1] += m * v.y;
    totals.momentum_scale += m * speed;
    if (rotations > 0) totals.angular_scale += m * speed * std::sqrt(x.square());
    totals.energy.kinetic += 0.5 * m * (square + affine_square(twist, inertia));
    add_spin(m, outer(v, x), totals.angular_momentum);
    add_spin(m, twist * inertia, totals.angular_momentum);
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
  const MovingColumns<const double> from(body.points);
  const EdgeColumns edges(body.points);
  Totals totals;
  for (int p = range.first; p < range.last; ++p) {
    const Square twist = from.affine(p), moment = twist * inertia_of(from.x, edges, p);
    totals.energy.kinetic += 0.5 * from.mass[p] * moment.dot(twist);
    add_spin(from.mass[p], moment, totals.angular_momentum);
  }
  return totals;
}

}  // namespace plumbline
