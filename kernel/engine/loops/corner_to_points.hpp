// What points with corners take from the nodes, and what the ledger reads off them.
#pragma once

#include <cmath>

#include "kernel/engine/loops/corner_loops.hpp"
#include "kernel/engine/loops/survey.hpp"

namespace plumbline {

template <class G>
[[gnu::always_inline]] inline void CornerLoops<G>::store_strain_rates(const RateColumns& rates, int p, int count,
                                                                      const PackJet& jet, const Pack& radius) {
  const Pack hoop = G::axisymmetric ? jet.value.x / radius : Pack(0.0);
  const Pack gradient[dim][dim] = {{jet.gradient.xx, jet.gradient.xy}, {jet.gradient.yx, jet.gradient.yy}};
  if (rates.full) {
    for (int k = 0; k < dim * dim; ++k) store(rates.at[k] + p, gradient[k / dim][k % dim], count);
    if (G::axisymmetric) store(rates.at[dim * dim] + p, hoop, count);
    return;
  }
  Pack rate[G::strains];
  G::strain(gradient, hoop, rate);  // [York 3.23]
  for (int k = 0; k < G::strains; ++k) store(rates.at[k] + p, rate[k], count);
}

template <class G>
void CornerLoops<G>::gather(const Columns& points, const At& at, const Chunk& chunk,
                            std::span<const Gather> all) const {
  for_bins(points, at, chunk, [&]<int side>(const NodeBlock<side>& block, auto&& for_packs_here) {
    for_packs_here([&](const Parallelograms&, const DomainWeights<side>& weights, int p, int count) {
      for (const Gather& one : all) {
        Pack value = 0.0;
        block.for_nodes(
            [&](int k, std::size_t i) { value += weights.n[k] * one.nodes[i * static_cast<std::size_t>(one.stride)]; });
        store(one.values + p, value, count);
      }
    });
  });
}

template <class G>
double CornerLoops<G>::gather_start(Body& body, const At& at, const Chunk& chunk, const Wanted& wanted) const {
  if (!in_packs(body) || wanted.density || wanted.closing) return Lists::gather_start(body, at, chunk, wanted);
  const MovingColumns<const double> from(body.points);
  const RateColumns rates(body);
  const double* x = at.places(body.points, true).x[0];
  double* loss = body.points.has(column::transfer_loss) ? body.points(column::transfer_loss) : nullptr;
  const double h = this->grid().h();
  Pack total = 0.0;
  for_bins(body.points, at, chunk, [&]<int side>(const NodeBlock<side>& block, auto&& for_packs_here) {
    BlockVelocity<side> strained, start;
    if (wanted.rates) strained = BlockVelocity<side>(block, *wanted.rates.velocity);
    if (wanted.loss) start = BlockVelocity<side>(block, *wanted.loss);
    for_packs_here([&](const Parallelograms& here, const DomainWeights<side>& weights, int p, int count)
                       __attribute__((always_inline)) {
                         if (wanted.rates)
                           store_strain_rates(rates, p, count, weights.jet(strained), radius(load(x + p)));
                         if (!wanted.loss) return;
                         const auto u = weights.moments(start);
                         const PackMatrix inertia = here.inertia(h), taken = u.moment * inertia.inverse();
                         const PackMatrix off = from.affine(p) - taken;
                         const PackVector v = from.velocity(p), slip{v.x - u.value.x, v.y - u.value.y};
                         const Pack apart = slip.square() + affine_square(off, inertia);
                         const Pack spread = max(u.spread - affine_square(taken, inertia), Pack(0.0));
                         const Pack lost = 0.5 * load(from.mass + p) * (apart + spread);  // [EC-APIC 1]
                         if (loss) store(loss + p, lost, count);
                         total += kept(lost, count);
                       });
  });
  return sum(total);
}

template <class G>
MotionSums CornerLoops<G>::gather_motion(Body& body, const At& at, const Chunk& chunk, const Field& field,
                                         const Motion& motion) const {
  if (!in_packs(body) || motion.exchange || motion.beyond || !field.gas.kept.empty())
    return Lists::gather_motion(body, at, chunk, field, motion);
  Columns& points = body.points;
  const MovingColumns<double> to(points);
  const RateColumns rates(body);
  const EdgeColumns edges(points);
  const double* x_of_weights = at.places(points, true).x[0];
  double* loss = points.has(column::transfer_loss) ? points(column::transfer_loss) : nullptr;
  const double dt = motion.drift.value_or(motion.dt), h = this->grid().h();
  const auto* straining = motion.straining ? motion.straining.velocity : nullptr;
  const auto* carrying = motion.carrying == straining ? nullptr : motion.carrying;
  MotionSums sums;
  Pack lost = 0.0, torque = 0.0, moved = 0.0;
  for_bins(points, at, chunk, [&]<int side>(const NodeBlock<side>& block, auto&& for_packs_here) {
    const BlockVelocity<side> end(block, field.end);
    BlockVelocity<side> strained, carried;
    if (straining) strained = BlockVelocity<side>(block, *straining);
    if (carrying) carried = BlockVelocity<side>(block, *carrying);
    for_packs_here([&](const Parallelograms& before, const DomainWeights<side>& weights, int p,
                       int count) __attribute__((always_inline)) {
      const auto u = weights.moments(end);
      PackVector v = u.value;  // what moves them
      if (straining) {
        const auto jet = weights.jet(strained);
        store_strain_rates(rates, p, count, jet, radius(load(x_of_weights + p)));
        if (motion.carrying) v = jet.value;
      }
      if (carrying) v = weights.value(carried);
      const PackMatrix inertia = before.inertia(h), taken = u.moment * inertia.inverse();  // [EC-APIC 5]
      const PackVector& own = motion.drift ? u.value : v;
      const PackVector step{dt * own.x, dt * own.y}, x = to.position(p), moved_to{x.x + step.x, x.y + step.y};
      const PackMask too_far = !(abs(step.x) <= h && abs(step.y) <= h);
      if (sums.too_far < 0 && any_of(too_far && first_lanes(count))) sums.too_far = p;
      store(to.v[0] + p, u.value.x, count);
      store(to.v[1] + p, u.value.y, count);
      store(to.x[0] + p, moved_to.x, count);  // [York 3.21]
      store(to.x[1] + p, moved_to.y, count);
      // With the inertia of the new place the energy of the affine part stays, its spin does not.
      const PackMatrix there = domains(moved_to, edges, p).inertia(h);
      const PackMatrix twist = taken.times(
          Lists::kept_share(affine_square(taken, inertia), affine_square(taken, there)));  // [CPDI 5]
      store(to.c[0] + p, twist.xx, count);
      store(to.c[1] + p, twist.xy, count);
      store(to.c[2] + p, twist.yx, count);
      store(to.c[3] + p, twist.yy, count);
      const Pack m = load(to.mass + p);
      torque += kept(m * spin(u.moment - twist * there), count);
      if (!motion.drift) moved += kept(m * motion.dt * spin(outer(u.value, v)), count);
      const Pack given = kept(0.5 * m * (u.spread - affine_square(twist, there)), count);
      if (loss) store(loss + p, load(loss + p) + given, count);
      lost += given;
    });
  });
  sums.lost = sum(lost);
  if (rotations > 0) {
    sums.torque[about] = sum(torque);
    sums.moved[about] = sum(moved);
  }
  return sums;
}

// Mass, momenta and kinetic energy of a range; whether all of it stands on the grid.
template <class G>
bool CornerLoops<G>::sum_motion(const Body& body, PointRange range, Totals& totals) const {
  const MovingColumns<const double> from(body.points);
  const EdgeColumns edges(body.points);
  PackMask good = first_lanes(lanes);
  Pack mass = 0.0, momentum[dim] = {0.0, 0.0}, scale = 0.0, angular_scale = 0.0, kinetic = 0.0, turn = 0.0;
  for_packs(range.first, range.last, [&](int p, int count) {
    const Pack m = kept(load(from.mass + p), count);
    const PackVector x = from.position(p), v = from.velocity(p);
    const PackMatrix twist = from.affine(p), moment = twist * domains(x, edges, p).inertia(this->grid().h());
    const Pack square = v.square(), speed = sqrt(square);
    good = good && ((on_grid(x) && square < HUGE_VAL) || !first_lanes(count));
    mass += m;
    momentum[0] += m * v.x;
    momentum[1] += m * v.y;
    scale += m * speed;
    angular_scale += m * speed * sqrt(x.square());
    kinetic += 0.5 * m * (square + moment.dot(twist));
    turn += m * (spin(outer(v, x)) + spin(moment));
  });
  totals.mass = sum(mass);
  for (int d = 0; d < dim; ++d) totals.momentum[static_cast<std::size_t>(d)] = sum(momentum[d]);
  totals.momentum_scale = sum(scale);
  totals.energy.kinetic = sum(kinetic);
  if (rotations > 0) {
    totals.angular_scale = sum(angular_scale);
    totals.angular_momentum[about] = sum(turn);
  }
  return all_of(good);
}

template <class G>
Survey CornerLoops<G>::survey(const Body& body, PointRange range) const {
  if (!in_packs(body)) return Lists::survey(body, range);
  Survey result;
  const bool on_grid = sum_motion(body, range, result.totals);
  survey_material(body, range, dim, on_grid, result);
  return result;
}

template <class G>
Totals CornerLoops<G>::survey_motion(const Body& body, PointRange range) const {
  if (!in_packs(body)) return Lists::survey_motion(body, range);
  const MovingColumns<const double> from(body.points);
  const EdgeColumns edges(body.points);
  Pack kinetic = 0.0, turn = 0.0;
  for_packs(range.first, range.last, [&](int p, int count) {
    const PackMatrix twist = from.affine(p),
                     moment = twist * domains(from.position(p), edges, p).inertia(this->grid().h());
    const Pack m = kept(load(from.mass + p), count);
    kinetic += 0.5 * m * moment.dot(twist);
    turn += m * spin(moment);
  });
  Totals totals;
  totals.energy.kinetic = sum(kinetic);
  if (rotations > 0) totals.angular_momentum[about] = sum(turn);
  return totals;
}

}  // namespace plumbline
