// Strain rates of the points, their strains, and the power of stresses.
#pragma once

#include "kernel/engine/chains.hpp"
#include "kernel/engine/layout.hpp"
#include "kernel/engine/mean_dilatation.hpp"
#include "kernel/engine/step_record.hpp"

namespace plumbline {

// dt sum_p V_p sigma_p : strain_rate_p, J.
inline double stress_power(const Columns& points, PointRange range, double dt) {
  constexpr int most_components = 10;  // of stress, whatever the material and the geometry
  const double* volume = points(column::volume);
  const int components = points.components(column::stress);
  Pack power = 0.0;
  const double *stress[most_components], *rate[most_components];
  for (int k = 0; k < components; ++k) {
    stress[k] = points(column::stress, k);
    rate[k] = points(column::strain_rate, k);
  }
  for_packs(range.first, range.last, [&](int p, int count) {
    Pack dot = load(stress[0] + p) * load(rate[0] + p);
    for (int k = 1; k < components; ++k) dot += load(stress[k] + p) * load(rate[k] + p);
    power += kept(dt * load(volume + p) * dot, count);
  });
  return sum(power);
}

// What a range of points does over dt by the strain rates and stresses that it holds.
inline PowerSums power_of(const Body& body, PointRange range, const MaterialContext& context, double dt) {
  return {stress_power(body.points, range, dt), body.material->viscous_heat(body.points, range, context, dt)};
}

template <class Geometry>
class Strain {
 public:
  using Space = Discretisation<Geometry>;
  static constexpr int dim = Geometry::dim;
  using Record = StepRecord<dim, Geometry::rotations>;
  using Bodies = Layout<dim>;

  // smoothing: kappa of strains that chains carry.
  Strain(const Space& space, double smoothing, Ledger& ledger)
      : space_(space),
        dilatation_(space),
        chains_(space, 0, smoothing),
        ledger_(ledger) {}

  // The points hold the strain rates of a nodal velocity [York 3.23]. What the map lost is summed in the same pass, if it is not
  // known yet: until points move, their velocities are those that were mapped.
  void find_rates(Bodies& at, Record& step, NodalVelocity which) const {
    which = step.resolved(which);
    if (which == step.rates_of) return;
    double lost = 0;
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      auto& field = at.field(b);
      const auto& velocity = space_.straining_velocity(field, at.velocity(field, which));
      const typename Space::Loops::Wanted wanted{.loss = step.map_loss ? nullptr : &field.start,
                                                 .rates = space_.straining(at.bodies[b], at.weights[b], field, velocity,
                                                                           step.forces && at.corrected(space_, b)),
                                                 .closing = space_.closing(at.bodies[b], field, velocity)};
      lost += space_.template sum_over_chunks<double>(at.weights[b], [&](const Chunk& chunk) {
        return space_.loops->gather_start(at.bodies[b], at.weights[b], chunk, wanted);
      });
      dilatation_.average_rates(at.bodies[b], at.weights[b]);
    }
    if (!step.map_loss) step.map_loss = lost;
    step.rates_of = which;
  }

  // Sums the power of the forces that the last advance used, with the midpoint velocity, if it is not known yet: before
  // anything changes stresses or strains.
  void settle_power(Bodies& at, Record& step) const {
    if (!step.wants_power()) return;
    find_rates(at, step, NodalVelocity::midpoint);
    const double dt = step.advance->dt;
    step.power = sum_over_points(
        at, [&](Body& body, PointRange range) { return power_of(body, range, space_.context, dt); });
  }

  // Strains all points over dt. What they store before the forces are known waits for settle_early().
  void advance(Bodies& at, Record& step, double dt, NodalVelocity velocity) {
    find_rates(at, step, velocity);
    const PowerSums sums = sum_over_points(at, [&](Body& body, PointRange range) {
      const double power = step.forces ? stress_power(body.points, range, dt) : 0.0;
      return PowerSums{.power = power, .stored = body.material->advance(body.points, range, space_.context, dt)};
    });
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      ledger_.energy.book(Flow::constitutive, chains_.smooth_strain(at.bodies[b], at.weights[b], dt));
    }
    if (step.forces) return book(sums.power, sums.stored);
    step.early.stored += sums.stored;
    step.early.dt += dt;
  }

  // Books what was strained before the forces, with the stresses that these will use.
  void settle_early(Bodies& at, Record& step) const {
    if (step.early.dt == 0) return;
    const PowerSums sums = sum_over_points(
        at, [&](Body& body, PointRange range) { return PowerSums{stress_power(body.points, range, step.early.dt)}; });
    book(sums.power, step.early.stored);
    step.early = {};
  }

  // [EC-APIC viscous heat]
  bool reverse_cooling(Bodies& at, Record& step) const {
    find_rates(at, step, NodalVelocity::midpoint);
    int changed = 0;
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      Body& body = at.bodies[b];
      changed += space_.template sum_over_chunks<int>(at.weights[b], [&](const Chunk& chunk) {
        return body.material->reverse_cooling(body.points, {chunk.first, chunk.last}, space_.context) ? 1 : 0;
      });
    }
    return changed > 0;
  }

 private:
  template <class Work>
  PowerSums sum_over_points(Bodies& at, Work&& work) const {
    PowerSums sums;
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      sums += space_.template sum_over_chunks<PowerSums>(at.weights[b], [&](const Chunk& chunk) {
        return work(at.bodies[b], PointRange{chunk.first, chunk.last});
      });
    }
    return sums;
  }
  void book(double power, double stored) const {
    ledger_.energy.book(Flow::integration, power);
    ledger_.energy.book(Flow::constitutive, stored - power);
  }

  const Space& space_;
  MeanDilatation<Geometry> dilatation_;
  Chains<Geometry> chains_;
  Ledger& ledger_;
};

}  // namespace plumbline
