// Grid to points, and the booking of what a step did.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "kernel/engine/mechanics.hpp"

namespace plumbline {

template <class G>
void Mechanics<G>::stop_if_too_far(const MotionSums& sums, const Body& body, double dt) const {
  if (sums.too_far < 0) return;
  for (int p = sums.too_far; p < body.points.points(); ++p) {
    for (int d = 0; d < dim; ++d) {
      const double v = body.points(column::velocity, d)[p];
      if (std::abs(dt * v) <= space_.grid.h() && p + 1 < sums.too_far + lanes) continue;
      throw InadmissibleState("a point moved more than one cell in a step", body.name,
                              body.id[static_cast<std::size_t>(p)], column::velocity.name(), v);
    }
  }
}

template <class G>
void Mechanics<G>::book_motion(const MotionSums& sums, double dt) {
  if (!step_.advance) step_.advance.emplace();
  for (const Field& field : layout_.fields) momentum_.add_wall_impulse(field, step_.advance->wall);
  step_.book(ledger_, sums, momentum_.has_contact());
  momentum_.pass_time(dt);
}

template <class G>
void Mechanics<G>::filter_velocities() {
  if (filter_.none()) return;
  if (!step_.advance) step_.advance.emplace();
  for (std::size_t f = 0; f < layout_.fields.size(); ++f) {
    typename VelocityFilter<G>::Group group;
    for (std::size_t b = 0; b < bodies(); ++b) {
      if (layout_.field_of_body[b] == f) group.emplace_back(&scene_.bodies[b].points, &layout_.weights[b]);
    }
    filter_.apply(group, layout_.fields[f], step_.advance->wall.linear, step_.filter_turn);
  }
}

template <class G>
void Mechanics<G>::move_points(double dt, NodalVelocity carrying) {
  want_places("move_points");
  gather_all_motion(dt, {}, carrying);
}

template <class G>
void Mechanics<G>::kick_points(double dt) {
  want_places("kick_points");
  gather_all_motion(dt, 0.0, NodalVelocity::end);
}

template <class G>
void Mechanics<G>::gather_all_motion(double dt, std::optional<double> drift, NodalVelocity carrying) {
  settle_power();
  settle_loss();
  filter_velocities();
  survey_.reset();
  MotionSums sums;
  for (std::size_t b = 0; b < bodies(); ++b) {
    Body& body = scene_.bodies[b];
    Weights<dim>& at = layout_.weights[b];
    Field& field = field_of(b);
    at.keep(body.points);
    const typename Loops::Motion motion{.dt = dt,
                                        .drift = drift,
                                        .carrying = carrying == NodalVelocity::end ? nullptr : &nodal(field, carrying),
                                        .exchange = exchanges_heat(body)};
    const MotionSums own = space_.template sum_over_chunks<MotionSums>(
        at, [&](const Chunk& chunk) { return space_.loops->gather_motion(body, at, chunk, field, motion); });
    stop_if_too_far(own, body, dt);
    sums += own;
  }
  for (std::size_t b = 0; b < bodies(); ++b) {
    if (!drift) chains_.relax(scene_.bodies[b], layout_.weights[b], sums);
  }
  book_motion(sums, dt);
}

template <class G>
void Mechanics<G>::drift_points(double dt) {
  survey_.reset();
  for (Weights<dim>& at : layout_.weights) at.positions_changed();
  drifted_ += dt;
  MotionSums sums;
  for (std::size_t b = 0; b < bodies(); ++b) {
    Body& body = scene_.bodies[b];
    const MotionSums own = space_.template sum_over_chunks<MotionSums>(layout_.weights[b], [&](const Chunk& chunk) {
      MotionSums one;
      for (int d = 0; d < dim; ++d) {
        double* x = body.points(column::position, d);
        const double* v = body.points(column::velocity, d);
        for_packs(
            chunk.first, chunk.last, [&](int p, int count) __attribute__((always_inline)) {
              const Pack step = dt * load(v + p);
              if (one.too_far < 0 && any_of(!(abs(step) <= space_.grid.h()) && first_lanes(count))) one.too_far = p;
              store(x + p, load(x + p) + step, count);  // [Leapfrog 1]
            });
      }
      reflection_.apply(body.points, {chunk.first, chunk.last}, one);
      return one;
    });
    stop_if_too_far(own, body, dt);
    sums += own;
  }
  for (int d = 0; d < dim; ++d) {
    const auto k = static_cast<std::size_t>(d);
    if (sums.reflected[k] != 0) ledger_.momentum[k].book(Flow::walls, sums.reflected[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (sums.reflected_turn[k] != 0) ledger_.angular_momentum[k].book(Flow::walls, sums.reflected_turn[k]);
  }
}

template <class G>
void Mechanics<G>::hand_loss_over() {
  for (Field& field : layout_.fields) loss_to_gas_.clear(field);
  for (std::size_t b = 0; b < bodies(); ++b) loss_to_gas_.give(scene_.bodies[b], layout_.weights[b], field_of(b));
  for (Field& field : layout_.fields) loss_to_gas_.divide(field);
}

template <class G>
void Mechanics<G>::return_transfer_loss() {
  want_places("return_transfer_loss");
  want_losses("return_transfer_loss");
  survey_.reset();
  hand_loss_over();
  for (std::size_t b = 0; b < bodies(); ++b) {
    Body& body = scene_.bodies[b];
    if (!body.material->takes_heat()) continue;
    loss_to_gas_.take(body, layout_.weights[b], field_of(b));
    const double* loss = body.points(column::transfer_loss);
    const double returned = space_.template sum_over_chunks<double>(layout_.weights[b], [&](const Chunk& chunk) {
      body.material->add_heat(body.points, {chunk.first, chunk.last}, loss);
      double sum = 0;
      for (int p = chunk.first; p < chunk.last; ++p) sum += loss[p];
      return sum;
    });
    ledger_.energy.book(Flow::transfer, returned);
  }
}

template <class G>
void Mechanics<G>::move_and_heat_points(double dt) {
  finish_points(dt, {});
}

template <class G>
void Mechanics<G>::kick_heat_and_drift_points(double dt, double drift) {
  finish_points(dt, drift);
}

template <class G>
void Mechanics<G>::finish_points(double dt, std::optional<double> drift) {
  want_places(drift ? "kick_points" : "move_points");
  want_losses("return_transfer_loss");
  settle_loss();
  filter_velocities();
  struct Sums {
    MotionSums motion;
    PowerSums power;
    Survey survey;
    double returned = 0;
    Sums& operator+=(const Sums& o) {
      motion += o.motion;
      power += o.power;
      survey += o.survey;
      returned += o.returned;
      return *this;
    }
    Sums operator+(const Sums& o) const { return Sums(*this) += o; }
  };
  const bool rates_wanted = rate_of_ != NodalVelocity::midpoint, power_wanted = step_.wants_power();
  Sums all;
  const auto finish = [&](std::size_t b) {
    Body& body = scene_.bodies[b];
    const bool heated = body.material->takes_heat();
    // Whether its points look where others stand: then all move before any does.
    const bool together = body.chain || body.material->measure() == StressMeasure::point_force;
    const double* loss = heated ? body.points(column::transfer_loss) : nullptr;
    Field& field = field_of(b);
    const std::vector<Vec>& midpoint = rates_wanted ? momentum_.straining_velocity(field, field.midpoint)
                                                    : field.midpoint;
    const typename Loops::Motion motion{
        .dt = dt, .drift = drift, .straining = rates_wanted ? &midpoint : nullptr, .exchange = exchanges_heat(body)};
    Weights<dim>& at = layout_.weights[b];
    if (heated) loss_to_gas_.take(body, at, field);
    if (together || loss_to_gas_.gives(body, field)) at.keep(body.points);
    const auto move = [&](const Chunk& chunk) { return space_.loops->gather_motion(body, at, chunk, field, motion); };
    Sums own;
    if (together) {
      own.motion = space_.template sum_over_chunks<MotionSums>(layout_.weights[b], move);
      stop_if_too_far(own.motion, body, dt);
      chains_.relax(body, at, own.motion);
    }
    own = own + space_.template sum_over_chunks<Sums>(layout_.weights[b], [&](const Chunk& chunk) {
      const PointRange range{chunk.first, chunk.last};
      Sums sums;
      if (!together) sums.motion = move(chunk);
      sums.power.power = stress_power(body, range, dt);
      sums.power.viscous = body.material->viscous_heat(body.points, range, context(), dt);
      sums.power.stored = body.material->advance(body.points, range, context(), dt);  // [EC-APIC 6]
      if (loss) {
        body.material->add_heat(body.points, range, loss);
        for (int p = range.first; p < range.last; ++p) sums.returned += loss[p];
      }
      if (together) return sums;
      if (drift) reflection_.apply(body.points, range, sums.motion);
      sums.survey = space_.loops->survey(body, range);
      return sums;
    });
    if (together) {
      ledger_.energy.book(Flow::constitutive, chains_.smooth_strain(body, at, dt));
      own = own + space_.template sum_over_chunks<Sums>(layout_.weights[b], [&](const Chunk& chunk) {
        Sums sums;
        if (drift) reflection_.apply(body.points, {chunk.first, chunk.last}, sums.motion);
        sums.survey = space_.loops->survey(body, {chunk.first, chunk.last});
        return sums;
      });
    }
    stop_if_too_far(own.motion, body, dt);
    all += own;
  };
  for (const bool heated : {false, true}) {  // first those whose loss heats the others
    for (std::size_t b = 0; b < bodies(); ++b) {
      if (scene_.bodies[b].material->takes_heat() == heated) finish(b);
    }
    if (heated) continue;
    hand_loss_over();
  }
  if (power_wanted) step_.power = all.power;
  book_motion(all.motion, dt);
  ledger_.energy.book(Flow::integration, all.power.power);
  ledger_.energy.book(Flow::constitutive, all.power.stored - all.power.power);
  ledger_.energy.book(Flow::transfer, all.returned);
  rate_of_.reset();
  for (Weights<dim>& at : layout_.weights) at.drop();  // nobody kept where the points stood: a step ends here
  all.survey.totals.grid_mass = grid_mass_;
  survey_ = all.survey;
}

}  // namespace plumbline
