// Strain rates, densities, stresses and their power.
#pragma once

#include <algorithm>

#include "kernel/engine/mechanics.hpp"

namespace plumbline {

template <class G>
void Mechanics<G>::find_all_strain_rates(NodalVelocity which) {
  if (which == NodalVelocity::current) which = current_;
  if (which == rate_of_) return;
  for (std::size_t b = 0; b < bodies(); ++b) {
    const std::vector<Vec>& velocity = momentum_.straining_velocity(field_of(b), nodal(field_of(b), which));
    const Weights<dim>& at = layout_.weights[b];
    space_.for_chunks(
        at, [&](const Chunk& chunk) { space_.loops->gather_start(scene_.bodies[b], at, chunk, {.rates = &velocity}); });
  }
  rate_of_ = which;
}

// dt sum_p V_p sigma_p : strain_rate_p
template <class G>
double Mechanics<G>::stress_power(const Body& body, PointRange range, double dt) const {
  const double* volume = body.points(column::volume);
  const int components = stress_components(body.material->measure(), dim, G::axisymmetric);
  Pack power = 0.0;
  const double *stress[most_components], *rate[most_components];
  for (int k = 0; k < components; ++k) {
    stress[k] = body.points(column::stress, k);
    rate[k] = body.points(column::strain_rate, k);
  }
  for_packs(range.first, range.last, [&](int p, int count) {
    Pack dot = load(stress[0] + p) * load(rate[0] + p);
    for (int k = 1; k < components; ++k) dot += load(stress[k] + p) * load(rate[k] + p);
    power += kept(dt * load(volume + p) * dot, count);
  });
  return sum(power);
}

// The stress power of the forces that advance_momentum used, with the midpoint velocity: before anything changes either.
template <class G>
void Mechanics<G>::settle_power() {
  if (!step_.wants_power()) return;
  find_all_strain_rates(NodalVelocity::midpoint);
  PowerSums sums;
  for (std::size_t b = 0; b < bodies(); ++b) {
    const Body& body = scene_.bodies[b];
    sums += space_.template sum_over_chunks<PowerSums>(layout_.weights[b], [&](const Chunk& chunk) {
      const PointRange range{chunk.first, chunk.last};
      return PowerSums{stress_power(body, range, step_.advance->dt),
                       body.material->viscous_heat(body.points, range, context(), step_.advance->dt)};
    });
  }
  step_.power = sums;
}

// Strain before the forces are known waits: its stress power is booked with the stress that the forces use.
template <class G>
void Mechanics<G>::strain_points(double dt, NodalVelocity velocity) {
  want_places("strain_points");
  settle_power();
  find_all_strain_rates(velocity);
  survey_.reset();
  PowerSums sums;
  for (std::size_t b = 0; b < bodies(); ++b) {
    Body& body = scene_.bodies[b];
    sums += space_.template sum_over_chunks<PowerSums>(layout_.weights[b], [&](const Chunk& chunk) {
      const PointRange range{chunk.first, chunk.last};
      const double power = forces_ ? stress_power(body, range, dt) : 0.0;
      return PowerSums{.power = power, .stored = body.material->advance(body.points, range, context(), dt)};
    });
  }
  for (std::size_t b = 0; b < bodies(); ++b) {
    ledger_.energy.book(Flow::constitutive, chains_.smooth_strain(scene_.bodies[b], layout_.weights[b], dt));
  }
  if (forces_) {
    ledger_.energy.book(Flow::integration, sums.power);
    ledger_.energy.book(Flow::constitutive, sums.stored - sums.power);
  } else {
    strained_.stored += sums.stored;
    strained_.dt += dt;
  }
}

template <class G>
void Mechanics<G>::settle_pending_strain() {
  if (strained_.dt == 0) return;
  double power = 0;
  for (std::size_t b = 0; b < bodies(); ++b) {
    power += space_.template sum_over_chunks<double>(layout_.weights[b], [&](const Chunk& chunk) {
      return stress_power(scene_.bodies[b], {chunk.first, chunk.last}, strained_.dt);
    });
  }
  ledger_.energy.book(Flow::integration, power);
  ledger_.energy.book(Flow::constitutive, strained_.stored - power);
  strained_ = {};
}

// Densities by the scene's method, then stresses, and_forces: then the forces, before the points have moved. Point forces
// are those of places, which may have drifted.
template <class G>
void Mechanics<G>::evaluate_stress_ahead(NodalVelocity velocity, double ahead, bool and_forces) {
  want_places(ahead == 0 ? "evaluate_stress" : "predict_stress");
  settle_power();
  survey_.reset();
  load_ahead_ = ahead;
  if (velocity == NodalVelocity::current) velocity = current_;
  StartSums all;
  for (std::size_t b = 0; b < bodies(); ++b) {
    Body& body = scene_.bodies[b];
    Field& field = field_of(b);
    const Weights<dim>& at = layout_.weights[b];
    const bool of_places = body.material->measure() == StressMeasure::point_force;
    const MaterialContext then = context(of_places && ahead != 0 ? ahead - drifted_ : ahead);
    const auto source = densities_.find(scene_, body, at, field, layout_.own_mass[b], placing_);
    typename Loops::Wanted wanted;
    if (!step_.map_loss) wanted.loss = &field.start;
    if (velocity != rate_of_) wanted.rates = &momentum_.straining_velocity(field, nodal(field, velocity));
    if (!source.elsewhere) wanted.density = source.nodes;
    wanted.specific = source.specific;
    if (of_places && wanted.rates) {  // the velocities of all points before any looks at others'
      space_.for_chunks(
          at, [&](const Chunk& chunk) { space_.loops->gather_start(body, at, chunk, {.rates = wanted.rates}); });
      wanted.rates = nullptr;
    }
    const auto evaluate = [&](const Chunk& chunk) {
      const double lost = wanted.none() ? 0.0 : space_.loops->gather_start(body, at, chunk, wanted);
      if (!source.elsewhere) body.material->evaluate_stress(body.points, {chunk.first, chunk.last}, then);
      return lost;
    };
    if (and_forces) {
      const auto with_forces = [&](const Chunk& chunk) {
        const double lost = evaluate(chunk);
        return StartSums{lost, map_forces(b, chunk)};
      };
      all += space_.template sum_over_chunks_writing_nodes<StartSums>(at, with_forces);
      add_stress_turn(b);
      map_load(b);
    } else {
      all.lost += space_.template sum_over_chunks<double>(at, evaluate);
    }
    if (!source.elsewhere) continue;
    space_.for_chunks(*source.elsewhere, [&](const Chunk& chunk) {
      space_.loops->gather_start(body, *source.elsewhere, chunk,
                                 {.density = source.nodes, .specific = source.specific});
      body.material->evaluate_stress(body.points, {chunk.first, chunk.last}, then);
    });
  }
  if (and_forces) forces_->hoop = all.hoop_force;
  if (!step_.map_loss) step_.map_loss = all.lost;
  rate_of_ = velocity;
}

template <class G>
void Mechanics<G>::evaluate_stress(NodalVelocity velocity) {
  evaluate_stress_ahead(velocity, 0, false);
}

template <class G>
void Mechanics<G>::predict_stress(double ahead, NodalVelocity velocity) {
  evaluate_stress_ahead(velocity, ahead, false);  // [Leapfrog 2]
}

template <class G>
void Mechanics<G>::predict_stress_and_map_forces(double ahead) {
  if (std::any_of(layout_.weights.begin(), layout_.weights.end(), [](const auto& at) { return at.kept(); })) {
    predict_stress(ahead, NodalVelocity::start);
    return map_forces();
  }
  settle_pending_strain();
  clear_forces();
  evaluate_stress_ahead(NodalVelocity::start, ahead, true);
}

template <class G>
bool Mechanics<G>::reverse_cooling() {
  want_places("reverse_cooling");
  find_all_strain_rates(NodalVelocity::midpoint);
  int changed = 0;
  for (std::size_t b = 0; b < bodies(); ++b) {
    Body& body = scene_.bodies[b];
    changed += space_.template sum_over_chunks<int>(layout_.weights[b], [&](const Chunk& chunk) {
      return body.material->reverse_cooling(body.points, {chunk.first, chunk.last}, context()) ? 1 : 0;
    });
  }
  return changed > 0;
}

}  // namespace plumbline
