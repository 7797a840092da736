// Motion, strain and heat at the end of a step in one pass over the points. [EC-APIC 5, 6]
#pragma once

#include "kernel/engine/motion.hpp"

namespace plumbline {

template <class G>
void Motion<G>::strain_and_heat(Body& body, PointRange range, double dt, Sums& sums) const {
  sums.power = power_of(body, range, space_.context, dt);
  sums.power.stored = body.material->advance(body.points, range, space_.context, dt);  // [EC-APIC 6]
  if (body.material->takes_heat()) sums.returned = add_heat(body, range);
}

template <class G>
auto Motion<G>::finish_body(Bodies& at, std::size_t b, const Record& step, double dt, std::optional<double> drift)
    -> Sums {
  Body& body = at.bodies[b];
  Field& field = at.field(b);
  Weights<dim>& places = at.weights[b];
  typename Space::Loops::Motion motion{.dt = dt, .drift = drift, .exchange = exchanges_heat(body, field)};
  if (step.rates_of != NodalVelocity::midpoint) motion.straining = straining(at, b, step);
  carry_sharpened(motion, body, field, field.end);
  if (body.material->takes_heat()) loss_to_gas_.take(body, places, field);
  // Whether its points look where others stand: then all move before any does.
  const bool together = body.chain || body.material->measure() == StressMeasure::point_force || dilatation_.of(body);
  if (together || loss_to_gas_.gives(body, field)) places.keep(body.points);
  const auto move = [&](const Chunk& chunk) { return space_.loops->gather_motion(body, places, chunk, field, motion); };
  const auto pass = [&](auto&& work) {
    return space_.template sum_over_chunks<Sums>(places, [&](const Chunk& chunk) {
      Sums sums;
      work(chunk, PointRange{chunk.first, chunk.last}, sums);
      return sums;
    });
  };
  Sums own;
  if (!together) {
    own = pass([&](const Chunk& chunk, PointRange range, Sums& sums) {
      sums.motion = move(chunk);
      strain_and_heat(body, range, dt, sums);
      look_back(body, range, drift.has_value(), sums);
    });
  } else {
    own.motion = space_.template sum_over_chunks<MotionSums>(places, move);
    stop_if_too_far(own.motion, body, dt);
    chains_.relax(body, places, own.motion);
    if (motion.straining) dilatation_.average_rates(body, places);
    own += pass([&](const Chunk&, PointRange range, Sums& sums) { strain_and_heat(body, range, dt, sums); });
    ledger_.energy.book(Flow::constitutive, chains_.smooth_strain(body, places, dt));
    own += pass([&](const Chunk&, PointRange range, Sums& sums) { look_back(body, range, drift.has_value(), sums); });
  }
  stop_if_too_far(own.motion, body, dt);
  return own;
}

template <class G>
Survey Motion<G>::finish(Bodies& at, Record& step, double dt, std::optional<double> drift) {
  want_losses(at);
  filter_velocities(at, step);
  const bool power_wanted = step.wants_power();
  Sums all;
  for (const bool heated : {false, true}) {  // first those whose loss heats the others
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      if (at.bodies[b].material->takes_heat() == heated) all += finish_body(at, b, step, dt, drift);
    }
    if (!heated) hand_loss_over(at);
  }
  if (power_wanted) step.power = all.power;
  book(at, step, all.motion);
  ledger_.energy.book(Flow::integration, all.power.power);
  ledger_.energy.book(Flow::constitutive, all.power.stored - all.power.power);
  ledger_.energy.book(Flow::transfer, all.returned);
  step.rates_of.reset();
  for (Weights<dim>& places : at.weights) places.drop();  // nobody kept where the points stood: a step ends here
  return all.survey;
}

}  // namespace plumbline
