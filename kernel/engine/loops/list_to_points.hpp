// Nodes to points, along lists.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "kernel/engine/loops/list_loops.hpp"
#include "kernel/rotations.hpp"

namespace plumbline {

template <class G>
template <class Value>
double ListLoops<G>::mean(Entries entries, Value&& f) {
  double sum = 0;
  for (const auto& [node, n, gradient] : entries) sum += n * f(static_cast<std::size_t>(node));
  return sum;
}

template <class G>
std::size_t ListLoops<G>::heaviest(Entries entries) {
  const auto found = std::max_element(entries.begin(), entries.end(),
                                      [](const auto& a, const auto& b) { return a.value < b.value; });
  return static_cast<std::size_t>(found->node);
}

template <class G>
template <class Value>
auto ListLoops<G>::jet(const Reach& at, int p, const Vec& base, Value&& f) const -> Jet {
  Jet sums;
  for (const auto& [node, n, gradient] : at.of(p)) {
    const Vec value = f(static_cast<std::size_t>(node)) - base;
    sums.value += n * value;
    sums.gradient += value * gradient.transpose();
    sums.moment += n * value * arm(at, p, node).transpose();
  }
  return sums;
}

template <class G>
auto ListLoops<G>::inertia_of(const Reach& at, int p) const -> Matrix {
  Matrix sum = Matrix::Zero();
  for (const auto& [node, n, gradient] : at.of(p)) sum += n * arm(at, p, node) * arm(at, p, node).transpose();
  return sum;
}

template <class G>
void ListLoops<G>::add_turn(double m, const Matrix& s, Turn& turn) {
  for (int k = 0; k < rotations; ++k) {
    const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
    turn[about + static_cast<std::size_t>(k)] += m * (s(b, a) - s(a, b));
  }
}

template <class G>
void ListLoops<G>::gather(const Columns& points, const At& at, const Chunk& chunk, std::span<const Gather> all) const {
  const Reach reached = reach(points, at.places(points, traits_.boxes), {chunk.first, chunk.last});
  for (int p = chunk.first; p < chunk.last; ++p) {
    for (const Gather& one : all) {
      const auto stride = static_cast<std::size_t>(one.stride);
      one.values[p] = mean(reached.of(p), [&](std::size_t i) { return one.nodes[i * stride]; });
    }
  }
}

template <class G>
void ListLoops<G>::store_strain_rates(Body& body, const Reach& at, int p, const Straining& by) const {
  Columns& points = body.points;
  if (by.divergence) {
    points(column::strain_rate)[p] = mean(at.of(p),
                                          [&](std::size_t i) { return (*by.divergence)[i]; });  // [Pressure 3]
    return;
  }
  const StressMeasure measure = body.material->measure();
  const Jet found = jet(at, p, Vec::Zero(), [&](std::size_t i) { return (*by.velocity)[i]; });
  const double hoop_rate = G::axisymmetric ? found.value[0] / at.place(p)[0] : 0;
  const auto put = [&](int k, double value) { points(column::strain_rate, k)[p] = value; };
  if (measure == StressMeasure::point_force) {
    for (int d = 0; d < dim; ++d) put(d, found.value[d]);
  } else if (measure == StressMeasure::pressure) {
    put(0, found.gradient.trace() + hoop_rate);
  } else if (measure == StressMeasure::full) {
    for (int k = 0; k < dim * dim; ++k) put(k, found.gradient(k / dim, k % dim));
    if (G::axisymmetric) put(dim * dim, hoop_rate);
  } else {
    double gradient[dim][dim], rate[G::strains];
    for (int k = 0; k < dim * dim; ++k) gradient[k / dim][k % dim] = found.gradient(k / dim, k % dim);
    G::strain(gradient, hoop_rate, rate);  // [York 3.23]
    for (int k = 0; k < G::strains; ++k) put(k, rate[k]);
  }
}

template <class G>
double ListLoops<G>::gather_start(Body& body, const At& at, const Chunk& chunk, const Wanted& wanted) const {
  Columns& points = body.points;
  const Reach reached = reach(points, at.places(points, traits_.boxes), {chunk.first, chunk.last});
  double total = 0;
  for (int p = chunk.first; p < chunk.last; ++p) {
    const double m = points(column::mass)[p];
    if (wanted.rates) store_strain_rates(body, reached, p, wanted.rates);
    if (wanted.closing) {  // [Limiter 1]
      double divergence = 0;
      const bool pressure = body.material->measure() == StressMeasure::pressure;
      for (int k = 0; k < (pressure ? 1 : G::normals); ++k) divergence += points(column::strain_rate, k)[p];
      const double limited = mean(reached.of(p), [&](std::size_t i) { return (*wanted.closing)[i]; });
      points(column::closing)[p] = std::min(std::max(0.0, -divergence), limited);
    }
    if (wanted.density) {
      const double density = mean(reached.of(p), [&](std::size_t i) { return (*wanted.density)[i]; });
      points(column::volume)[p] = wanted.specific ? m * density : m / density;  // [EC-APIC 2] [Coupling 4]
    }
    if (!wanted.loss) continue;
    const auto start = [&](std::size_t i) { return (*wanted.loss)[i]; };
    const Vec base = start(heaviest(reached.of(p)));
    const Jet u = jet(reached, p, base, start);
    double spread = mean(reached.of(p), [&](std::size_t i) { return (start(i) - base).squaredNorm(); });
    Vec off = -base - u.value;
    for (int d = 0; d < dim; ++d) off[d] += points(column::velocity, d)[p];
    spread -= u.value.squaredNorm();
    double apart = off.squaredNorm();
    if (transfer_.affine) {
      const Matrix inertia = inertia_of(reached, p), taken = u.moment * inertia.inverse();
      Matrix twist;
      for (int k = 0; k < dim * dim; ++k)
        twist(k / dim, k % dim) = points(column::affine, k)[p] - taken(k / dim, k % dim);
      apart += (twist * inertia * twist.transpose()).trace();
      spread -= (taken * inertia * taken.transpose()).trace();
    }
    const double lost = 0.5 * (1 - transfer_.keep) * m * (apart + spread);  // [EC-APIC 1] [Blend 1]
    if (points.has(column::transfer_loss)) points(column::transfer_loss)[p] = lost;
    total += lost;
  }
  return total;
}

// What a point takes from the grid's velocities.
template <class G>
struct ListLoops<G>::Taken {
  Vec grid, velocity;  // of the grid where it stands; its own from now on
  Matrix moment;       // sum N f (x_i - x_p)^T of the velocity it takes
  Matrix twist;        // C_p
  double square;       // twice what the grid carries and the point does not keep, per mass, but for an affine part's
};

// With w_i = v~_i + (1 - alpha_i) (y_p(x_i) - v_i) in place of v~_i. [Filter 1]
template <class G>
void ListLoops<G>::filter(const Body& body, const Reach& at, int p, const Field& field, const Vec& base,
                          Taken& taken) const {
  Vec v = -base;
  Matrix c;
  for (int d = 0; d < dim; ++d) v[d] += body.points(column::velocity, d)[p];
  for (int k = 0; k < dim * dim; ++k) c(k / dim, k % dim) = body.points(column::affine, k)[p];
  Vec velocity = Vec::Zero();
  taken.moment.setZero();
  taken.square = 0;
  for (const auto& [node, n, gradient] : at.of(p)) {
    const auto i = static_cast<std::size_t>(node);
    const Vec r = arm(at, p, node), end = field.end[i] - base;
    const Vec more = field.gas.kept[i] * (v + c * r - (field.start[i] - base));
    velocity += n * (end + more);
    taken.moment += n * (end + more) * r.transpose();
    taken.square += n * (end.squaredNorm() + 2 * more.dot(end));
  }
  taken.square -= velocity.squaredNorm();
  taken.velocity = velocity + base;
}

template <class G>
auto ListLoops<G>::take(const Body& body, const Reach& at, int p, const Field& field) const -> Taken {
  const Entries entries = at.of(p);
  const double keep = transfer_.keep;
  const Vec base = field.end[heaviest(entries)];
  const auto relative = [&](std::size_t i) -> Vec { return field.end[i] - base; };
  const auto change = [&](std::size_t i) -> Vec { return field.end[i] - field.start[i]; };
  const Jet u = jet(at, p, Vec::Zero(), relative);
  const double carried = mean(entries, [&](std::size_t i) { return relative(i).squaredNorm(); });
  Taken taken{u.value + base, u.value + base, u.moment, Matrix::Zero(), carried - u.value.squaredNorm()};
  if (transfer_.order > 0) {
    const Jet w = jet(at, p, base, [&](std::size_t i) { return field.corrected.filtered[i]; });
    taken.velocity = w.value + base;
    taken.moment = w.moment;
    taken.square = carried + 2 * base.dot(u.value - w.value) - w.value.squaredNorm();
  }
  if (transfer_.affine && !field.gas.kept.empty()) filter(body, at, p, field, base, taken);
  if (transfer_.affine) taken.twist = taken.moment * inertia_of(at, p).inverse();  // [EC-APIC 5]
  if (keep == 0) return taken;
  const Jet a = jet(at, p, Vec::Zero(), change);
  Vec kept;  // [York 3.22]
  for (int d = 0; d < dim; ++d) kept[d] = body.points(column::velocity, d)[p] + a.value[d];
  const Vec apart = kept - taken.velocity;
  const double of_change = mean(entries, [&](std::size_t i) { return change(i).squaredNorm(); });
  taken.velocity += keep * apart;  // [Blend 1]
  taken.moment = keep * a.moment + (1 - keep) * taken.moment;
  taken.square = keep * (of_change - a.value.squaredNorm()) + (1 - keep) * (taken.square + keep * apart.squaredNorm());
  return taken;
}

// Stores C_p with the inertia of the new place: where that is another, so are the energy and the spin of the affine part.
template <class G>
void ListLoops<G>::settle_affine(Body& body, const Reach& here, const Reach& there, int p, Taken& taken,
                                 MotionSums& sums) const {
  const Matrix inertia = inertia_of(there, p);
  const auto square = [&](const Matrix& d) { return (taken.twist * d * taken.twist.transpose()).trace(); };
  if (shape_->keeps_affine_energy() && is_solid(body)) {
    taken.twist *= kept_share(square(inertia_of(here, p)), square(inertia));
  }
  taken.square -= square(inertia);
  add_turn(-body.points(column::mass)[p], taken.twist * inertia, sums.torque);
  for (int k = 0; k < dim * dim; ++k) body.points(column::affine, k)[p] = taken.twist(k / dim, k % dim);
}

template <class G>
void ListLoops<G>::exchange_heat(Body& body, const Reach& at, int p, const Field& field) {
  double& energy = body.points(column::energy)[p];
  energy += mean(at.of(p),
                 [&](std::size_t i) { return field.gas.exchange[i] * (field.gas.heat[i] - energy); });  // [Exchange 1]
}

template <class G>
MotionSums ListLoops<G>::gather_motion(Body& body, const At& at, const Chunk& chunk, const Field& field,
                                       const Motion& motion) const {
  Columns& points = body.points;
  const PointRange range{chunk.first, chunk.last};
  const Reach reached = reach(points, at.places(points, traits_.boxes), range);
  const bool at_start = points.has(column::position_at_start);
  std::vector<Taken> all;
  MotionSums sums;
  for (int p = range.first; p < range.last; ++p) {
    Vec before, away = Vec::Zero();  // of the place that its weights belong to
    for (int d = 0; d < dim; ++d) {
      before[d] = points(column::velocity, d)[p];
      if (at_start) away[d] = points(column::position, d)[p] - points(column::position_at_start, d)[p];
    }
    if (motion.straining) store_strain_rates(body, reached, p, motion.straining);
    if (motion.exchange) exchange_heat(body, reached, p, field);
    const Taken taken = take(body, reached, p, field);
    Vec carrying = taken.grid;
    if (motion.carrying)
      carrying = jet(reached, p, Vec::Zero(), [&](std::size_t i) { return (*motion.carrying)[i]; }).value;
    Vec shift = Vec::Zero();  // [Sharpening 2]
    if (motion.beyond)
      shift = motion.dt * jet(reached, p, Vec::Zero(), [&](std::size_t i) { return (*motion.beyond)[i]; }).value;
    const Vec step = shift + (motion.drift ? Vec(*motion.drift * taken.velocity) : Vec(motion.dt * carrying));
    if (sums.too_far < 0 && !(step.cwiseAbs().maxCoeff() <= grid_.h())) sums.too_far = p;
    for (int d = 0; d < dim; ++d) {
      points(column::velocity, d)[p] = taken.velocity[d];
      points(column::position, d)[p] += step[d];  // [York 3.21]
    }
    const double m = points(column::mass)[p];
    add_turn(m, taken.moment, sums.torque);
    if (at_start) add_turn(m, (before - taken.velocity) * away.transpose(), sums.torque);  // [Lagrangian 3]
    if (!motion.drift) add_turn(m * motion.dt, taken.velocity * carrying.transpose(), sums.moved);
    add_turn(m, taken.velocity * shift.transpose(), sums.moved);
    all.push_back(taken);
  }
  const Reach there = transfer_.affine ? reach(points, range) : Reach{};
  double* loss = points.has(column::transfer_loss) ? points(column::transfer_loss) : nullptr;
  for (int p = range.first; p < range.last; ++p) {
    Taken& taken = all[static_cast<std::size_t>(p - range.first)];
    if (transfer_.affine) settle_affine(body, reached, there, p, taken, sums);
    const double given = 0.5 * points(column::mass)[p] * taken.square;  // [EC-APIC 5]
    if (loss) loss[p] = transfer_.keep == 1 ? given : loss[p] + given;
    sums.lost += given;
  }
  return sums;
}

}  // namespace plumbline
