// Nodes to points.
#pragma once

#include <algorithm>

#include "kernel/engine/loops/filter.hpp"
#include "kernel/rotations.hpp"

namespace plumbline {

// Strain rates of a pack from the jets of the velocity components [York 3.23], from nodes [Pressure 3], or both [Quadrature 3].
template <class G, class S>
[[gnu::always_inline]] inline void ShapeLoops<G, S>::store_strain_rates(const RateColumns& rates,
                                                                        const PackStencil& weights, const Pack& radius,
                                                                        int p, int count,
                                                                        const BinStraining& by) const {
  const auto of_nodes = [&]() __attribute__((always_inline)) {
    return weights.gather_array([&](int k) { return by.divergence[k]; }).value;
  };
  if (!by.by_velocity) return store(rates.at[0] + p, of_nodes(), count);
  const auto jet = [&](int d) __attribute__((always_inline)) {
    return weights.gather_array([&](int k) { return by.velocity[k][d]; });
  };
  if (rates.measure == StressMeasure::point_force) {
    for (int d = 0; d < dim; ++d) store(rates.at[d] + p, jet(d).value, count);
    return;
  }
  if (rates.measure == StressMeasure::pressure) {  // of each jet only what the divergence takes is computed
    Pack divergence = 0.0;
    for_directions<dim>([&](auto direction) __attribute__((always_inline)) {
      constexpr int d = direction;
      const auto own = jet(d);
      divergence += own.gradient[d];
      if (G::axisymmetric && d == 0) divergence += own.value / radius;
    });
    if (by.by_divergence) divergence += of_nodes();
    store(rates.at[0] + p, divergence, count);
    return;
  }
  Pack gradient[dim][dim], hoop_rate = 0.0;
  for (int d = 0; d < dim; ++d) {
    const auto own = jet(d);
    for (int e = 0; e < dim; ++e) gradient[d][e] = own.gradient[e];
    if constexpr (G::axisymmetric) {
      if (d == 0) hoop_rate = own.value / radius;
    }
  }
  if (rates.measure == StressMeasure::full) {
    for (int d = 0; d < dim; ++d) {
      for (int e = 0; e < dim; ++e) store(rates.at[d * dim + e] + p, gradient[d][e], count);
    }
    if constexpr (G::axisymmetric) store(rates.at[dim * dim] + p, hoop_rate, count);
    return;
  }
  Pack rate[G::strains];
  G::strain(gradient, hoop_rate, rate);
  for (int k = 0; k < G::strains; ++k) store(rates.at[k] + p, rate[k], count);
}

template <class G, class S>
auto ShapeLoops<G, S>::rate_columns(Body& body) -> RateColumns {
  RateColumns rates;
  rates.measure = body.material->measure();
  for (int k = 0; k < stress_components(rates.measure, dim, G::axisymmetric); ++k) {
    rates.at[k] = body.points(column::strain_rate, k);
  }
  return rates;
}

template <class G, class S>
template <bool affine>
double ShapeLoops<G, S>::gather_start(Body& body, const At& at, const Chunk& chunk, const Wanted& wanted) const {
  const Places<dim> places = at.places(body.points, S::boxes);
  const double* mass = body.points(column::mass);
  const double *velocity[dim], *twist[dim][dim] = {};
  for (int d = 0; d < dim; ++d) {
    velocity[d] = body.points(column::velocity, d);
    for (int e = 0; affine && e < dim; ++e) twist[d][e] = body.points(column::affine, d * dim + e);
  }
  double* loss = body.points.has(column::transfer_loss) ? body.points(column::transfer_loss) : nullptr;
  double* volume = body.points(column::volume);
  const RateColumns rates = rate_columns(body);
  double* closing = wanted.closing ? body.points(column::closing) : nullptr;
  const int normals = rates.measure == StressMeasure::pressure ? 1 : G::normals;
  const double counted = affine ? 0.5 : 0.5 * (1 - transfer_.keep);  // [Blend 1]
  Pack total = 0.0;
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    BinVelocity start;
    BinStraining strained;
    BinNumbers rho, closes;
    if (wanted.loss) start = bin_velocity(print, *wanted.loss);
    if (wanted.rates) collect(print, wanted.rates, strained);
    if (wanted.density) collect(print, *wanted.density, rho);
    if (wanted.closing) collect(print, *wanted.closing, closes);
    const auto with_pack = [&](int p, int count) __attribute__((always_inline)) {
      const PackStencil weights = stencil(places, anchor, p);
      if (wanted.rates) store_strain_rates(rates, weights, load(places.x[0] + p), p, count, strained);
      if (wanted.closing) {  // [Limiter 1]
        Pack divergence = load(rates.at[0] + p);
        for (int k = 1; k < normals; ++k) divergence += load(rates.at[k] + p);
        const Pack limited = weights.gather_array([&](int k) { return closes[k]; }).value;
        store(closing + p, min(max(-divergence, Pack(0.0)), limited), count);
      }
      if (wanted.density) {
        const Pack density = weights.gather_array([&](int k) { return rho[k]; }).value;
        store(volume + p, wanted.specific ? load(mass + p) * density : load(mass + p) / density, count);
      }
      if (!wanted.loss) return;
      Pack inertia[dim];
      for (int d = 0; d < dim; ++d) inertia[d] = weights.inertia(d);
      Pack spread = weights.gather_array([&](int k) { return start.square[k]; }).value, apart = 0.0;
      for (int d = 0; d < dim; ++d) {
        const auto u = weights.gather_array([&](int k) { return start.u[k][d]; });
        const Pack off = load(velocity[d] + p) - start.base[d] - u.value;
        apart += off * off;
        spread -= u.value * u.value;
        if constexpr (affine) {
          for (int e = 0; e < dim; ++e) {
            const Pack off_twist = load(twist[d][e] + p) - u.affine[e];
            apart += inertia[e] * off_twist * off_twist;
            spread -= inertia[e] * u.affine[e] * u.affine[e];
          }
        }
      }
      const Pack lost = counted * load(mass + p) * (apart + max(spread, Pack(0.0)));
      if (loss) store(loss + p, lost, count);
      total += kept(lost, count);
    };
    for_packs(first, last, with_pack);
  });
  return sum(total);
}

template <class G, class S>
template <bool affine>
auto ShapeLoops<G, S>::gather_motion(Body& body, const At& at, const Chunk& chunk, const Field& field,
                                     const Motion& motion) const -> MotionSums {
  const double dt = motion.dt;
  const auto drift = motion.drift;
  const Straining straining = motion.straining;
  const auto *carrying = motion.carrying, *beyond = motion.beyond, *faces = FlowingShape<S> ? motion.faces : nullptr;
  Columns& points = body.points;
  const RateColumns rates = rate_columns(body);
  double* energy = motion.exchange ? points(column::energy) : nullptr;
  const Places<dim> places = at.places(points, S::boxes);
  const double* mass = points(column::mass);
  double* loss = points.has(column::transfer_loss) ? points(column::transfer_loss) : nullptr;
  double *velocity[dim], *position[dim], *twist[dim][dim] = {};
  for (int d = 0; d < dim; ++d) {
    velocity[d] = points(column::velocity, d);
    position[d] = points(column::position, d);
    for (int e = 0; affine && e < dim; ++e) twist[d][e] = points(column::affine, d * dim + e);
  }
  MotionSums sums;
  Pack lost = 0.0, torque[3] = {0.0, 0.0, 0.0}, moved[3] = {0.0, 0.0, 0.0};
  const double keep = affine ? 0 : transfer_.keep;
  const bool increments = keep > 0, mixes = increments && keep < 1, filters = !affine && transfer_.order > 0;
  const bool loss_first = loss && keep == 1, at_rate = affine && !field.gas.kept.empty();
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    const BinVelocity end = bin_velocity(print, field.end);
    BinFilter filter;
    if (at_rate) filter = bin_filter(print, field, end);
    BinStraining strained;
    BinVectors shifted, stretched, face, change, carried;
    BinNumbers alpha, heat, change_square;
    double most_exchange = 0;
    if (straining) collect(print, straining, strained);
    if (carrying) collect(print, *carrying, carried);
    if (beyond) collect(print, *beyond, shifted);
    if (faces) {
      collect(print, *faces, face);
      for_stencil_nodes(print, [&](int k, std::size_t i) {
        for (int d = 0; d < dim; ++d) stretched[k][d] = -grid_.h() * (*motion.stretch)[i][d];
      });
    }
    if (energy) {
      for_stencil_nodes(print, [&](int k, std::size_t i) {
        alpha[k] = field.gas.exchange[i];
        heat[k] = field.gas.exchange[i] * field.gas.heat[i];
        most_exchange = std::max(most_exchange, field.gas.exchange[i]);
      });
    }
    if (increments || filters) {
      for_stencil_nodes(print, [&](int k, std::size_t i) {
        change_square[k] = 0.0;
        for (int d = 0; d < dim; ++d) {
          if (increments)
            change[k][d] = field.end[i][d] - field.start[i][d];
          else
            change[k][d] = field.corrected.filtered[i][d] - end.base[d];
          change_square[k] += change[k][d] * change[k][d];
        }
      });
    }
    const auto with_pack = [&](int p, int count) __attribute__((always_inline)) {
      const PackStencil weights = stencil(places, anchor, p);
      if (straining) store_strain_rates(rates, weights, load(places.x[0] + p), p, count, strained);
      if (most_exchange > 0) {
        const Pack share = weights.gather_array([&](int k) { return alpha[k]; }).value, e = load(energy + p);
        store(energy + p, e + (weights.gather_array([&](int k) { return heat[k]; }).value - share * e), count);
      }
      const Pack m = kept(load(mass + p), count);
      Pack v[dim], v_new[dim] = {}, c[dim][dim] = {}, inertia[dim], here[dim];
      for (int d = 0; d < dim; ++d) {
        inertia[d] = weights.inertia(d);
        here[d] = load(position[d] + p);
      }
      Pack square = 0.0, mixed = 0.0;  // of what the grid carries, less what the point keeps of it
      const bool filtered = affine && filter.most > 0;
      if (filtered) {
        for (int d = 0; d < dim; ++d) {
          v_new[d] = load(velocity[d] + p) - end.base[d];
          for (int e = 0; affine && e < dim; ++e) c[d][e] = load(twist[d][e] + p);
        }
        square = take_filtered(filter, weights, inertia, v_new, c);
      } else if (increments) {
        square = keep * weights.gather_array([&](int k) { return change_square[k]; }).value;
        if (mixes) mixed = weights.gather_array([&](int k) { return end.square[k]; }).value;
      } else {
        square = weights.gather_array([&](int k) { return end.square[k]; }).value;
      }
      for (int d = 0; d < dim; ++d) {
        const auto u = weights.gather_array([&](int k) { return end.u[k][d]; });
        v[d] = u.value + end.base[d];
        if (filtered) {
          v_new[d] += end.base[d];
        } else if (increments) {
          const auto a = weights.gather_array([&](int k) { return change[k][d]; });
          v_new[d] = load(velocity[d] + p) + a.value;  // [York 3.22]
          square -= keep * a.value * a.value;
          for (int e = 0; e < dim; ++e) c[d][e] = a.affine[e];
          if (mixes) {  // the loss is that of both, in their shares, and what is between the two [Blend 1]
            const Pack apart = v_new[d] - v[d];
            mixed += keep * apart * apart - u.value * u.value;
            v_new[d] = v[d] + keep * apart;
            for (int e = 0; e < dim; ++e) c[d][e] = keep * a.affine[e] + (1 - keep) * u.affine[e];
          }
        } else if (filters) {
          const auto w = weights.gather_array([&](int k) { return change[k][d]; });
          v_new[d] = w.value + end.base[d];
          square += 2.0 * end.base[d] * (u.value - w.value) - w.value * w.value;
          for (int e = 0; e < dim; ++e) c[d][e] = w.affine[e];
        } else {
          v_new[d] = v[d];
          square -= u.value * u.value;
          for (int e = 0; e < dim; ++e) c[d][e] = u.affine[e];  // [EC-APIC 5]
        }
        if (carrying) v[d] = weights.gather_array([&](int k) { return carried[k][d]; }).value;
      }
      PackMask too_far = first_lanes(0);
      Pack shift[dim];
      for (int d = 0; d < dim; ++d) {
        shift[d] = 0.0;
        if (beyond) shift[d] = dt * weights.gather_array([&](int k) { return shifted[k][d]; }).value;  // [Sharpening 2]
      }
      if constexpr (FlowingShape<S>) {
        if (faces) {
          for_directions<dim>([&](auto direction) __attribute__((always_inline)) {
            constexpr int d = direction;
            const Pack flow = weights.template gather_flow<d>([&](int k) { return stretched[k][d]; },
                                                              [&](int k) { return face[k][d]; });
            shift[d] = dt *
                       (flow -
                        (drift ? v_new[d] : v[d]));  // of what the point keeps of its own nothing moves it [Pressure 4]
          });
        }
      }
      for (int d = 0; d < dim; ++d) {
        const Pack step = shift[d] + (drift ? *drift * v_new[d] : dt * v[d]);
        too_far = too_far || !(abs(step) <= grid_.h());
        store(velocity[d] + p, v_new[d], count);
        here[d] += step;
        store(position[d] + p, here[d], count);  // [York 3.21]
      }
      if (sums.too_far < 0 && any_of(too_far && first_lanes(count))) sums.too_far = p;
      for (int k = 0; k < rotations; ++k) {
        const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
        // N r x u, but for what an affine part keeps of it.
        if constexpr (!affine || !S::fixed_inertia) torque[k] += m * (inertia[a] * c[b][a] - inertia[b] * c[a][b]);
        if (!drift) moved[k] += m * dt * (v[a] * v_new[b] - v[b] * v_new[a]);
        if (beyond || faces) moved[k] += m * (shift[a] * v_new[b] - shift[b] * v_new[a]);
      }
      if constexpr (affine) {
        // With the inertia of the new place: where that is another, so are the energy and the spin of the affine part.
        for (int d = 0; !S::fixed_inertia && d < dim; ++d) {
          const Pack cells = (here[d] - grid_.origin(d)) * per_h_;
          inertia[d] = inertia_at(cells, box(places.half_size[d], p)) * (grid_.h() * grid_.h());
        }
        for (int d = 0; d < dim; ++d) {
          for (int e = 0; e < dim; ++e) {
            square -= inertia[e] * c[d][e] * c[d][e];
            store(twist[d][e] + p, c[d][e], count);
          }
        }
        for (int k = 0; !S::fixed_inertia && k < rotations; ++k) {
          const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
          torque[k] -= m * (inertia[a] * c[b][a] - inertia[b] * c[a][b]);
        }
      }
      if (mixes) square += (1 - keep) * mixed;
      // Never negative but by rounding, and a cold gas has nothing to pay that with. Only a changing inertia can give.
      if (!filtered && !filters && (!affine || S::fixed_inertia)) square = max(square, Pack(0.0));
      Pack given = 0.5 * m * square;  // [EC-APIC 5]
      if (filtered && loss && S::fixed_inertia) given = repaid(given, load(loss + p));
      if (loss) store(loss + p, loss_first ? given : load(loss + p) + given, count);
      lost += given;
    };
    for_packs(first, last, with_pack);
  });
  sums.lost = sum(lost);
  for (int k = 0; k < rotations; ++k) {
    sums.torque[about + static_cast<std::size_t>(k)] = sum(torque[k]);
    sums.moved[about + static_cast<std::size_t>(k)] = sum(moved[k]);
  }
  return sums;
}

}  // namespace plumbline
