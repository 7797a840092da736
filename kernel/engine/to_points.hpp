// Grid to points, and the booking of what a step did.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "kernel/engine/mechanics.hpp"

namespace plumbline {

// Least and largest of x over the range; where any is not a number, all is in between.
template <class G>
std::pair<double, double> Mechanics<G>::extent(const double* x, PointRange range) {
  Pack low = HUGE_VAL, high = -HUGE_VAL;
  for_packs(
      range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
        const Pack here = count < lanes ? choose(first_lanes(count), load(x + p), x[p]) : load(x + p);
        low = min(low, here);
        high = max(high, here);
      });
  return {hmin(low), hmax(high)};
}

// Points beyond a wall change places with their mirror images. [EC-APIC walls]
template <class G>
void Mechanics<G>::reflect(Body& body, PointRange range, MotionSums& sums) const {
  Columns& points = body.points;
  for (int d = 0; d < dim; ++d) {
    const auto [lowest, highest] = extent(points(column::position, d), range);
    for (int side = 0; side < 2; ++side) {
      if (grid_.wall(d, side) == Wall::free) continue;
      if (side == 0 ? lowest >= grid_.origin(d) : highest <= grid_.origin(d) + grid_.cells(d) * grid_.h()) continue;
      const double sign = side == 0 ? 1 : -1;
      const double wall = grid_.origin(d) + (side == 0 ? 0 : grid_.cells(d) * grid_.h());
      const double beyond = wall - sign * on_side * grid_.h();
      const double* x = points(column::position, d);
      for_packs(range.first, range.last, [&](int p, int count) {
        if (none_of(sign * (load(x + p) - beyond) < 0.0 && first_lanes(count))) return;
        for (int k = p; k < p + count; ++k) {
          if (sign * (x[k] - beyond) < 0) reflect_point(body, k, d, wall, sums);
        }
      });
    }
  }
}

template <class G>
void Mechanics<G>::reflect_point(Body& body, int p, int d, double wall, MotionSums& sums) const {
  Columns& points = body.points;
  const int side = wall > grid_.origin(d) + 0.5 * grid_.h() ? 1 : 0;
  const bool no_slip = grid_.wall(d, side) == Wall::no_slip;
  const double m = points(column::mass)[p];
  Vec x, v;
  Eigen::Matrix<double, dim, dim> c = Eigen::Matrix<double, dim, dim>::Zero();
  const auto momenta = [&](double factor) {
    for (int k = 0; k < dim; ++k) {
      x[k] = points(column::position, k)[p];
      v[k] = points(column::velocity, k)[p];
      for (int e = 0; transfer_.affine && e < dim; ++e) c(k, e) = points(column::affine, k * dim + e)[p];
    }
    Spin<dim> turn = cross<dim>(x, v);
    for (int k = 0; transfer_.affine && k < rotation_count<dim>; ++k) {
      const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
      const auto inertia = [&](int e) { return loops_->inertia(points, e, p); };
      turn[k] += inertia(a) * c(b, a) - inertia(b) * c(a, b);
    }
    for (int k = 0; k < dim; ++k) sums.reflected[static_cast<std::size_t>(k)] += factor * m * v[k];
    for (int k = 0; k < rotations; ++k) {
      sums.reflected_turn[about + static_cast<std::size_t>(k)] += factor * m * turn[k];
    }
  };
  momenta(-1);
  points(column::position, d)[p] = 2 * wall - x[d];
  for (int k = 0; k < dim; ++k) {
    const double sign = no_slip || k == d ? -1 : 1;
    points(column::velocity, k)[p] = sign * v[k];
    for (int e = 0; transfer_.affine && e < dim; ++e)
      points(column::affine, k * dim + e)[p] = (e == d ? -sign : sign) * c(k, e);
  }
  momenta(1);
}

// Without its weights a stage would read and write anywhere.
template <class G>
void Mechanics<G>::want_places(const char* stage) const {
  if (!places_known_)
    throw std::logic_error(std::string(stage) + " wants the points located: locate_points comes first");
}

// Points carry what the maps take only for integrators that were seen to give it back.
template <class G>
void Mechanics<G>::want_losses(const char* stage) const {
  for (const Body& body : scene_.bodies) {
    if (!body.material->takes_heat() || body.points.has(column::transfer_loss)) continue;
    throw std::logic_error(std::string(stage) +
                           " is called first in a later step than those that tell the integrator's traits");
  }
}

template <class G>
void Mechanics<G>::stop_if_too_far(const MotionSums& sums, const Body& body) const {
  if (sums.too_far < 0) return;
  for (int p = sums.too_far; p < body.points.points(); ++p) {
    for (int d = 0; d < dim; ++d) {
      const double v = body.points(column::velocity, d)[p];
      if (std::abs(pending_.dt * v) <= grid_.h() && p + 1 < sums.too_far + lanes) continue;
      throw InadmissibleState("a point moved more than one cell in a step", body.name,
                              body.id[static_cast<std::size_t>(p)], column::velocity.name(), v);
    }
  }
}

template <class G>
void Mechanics<G>::book_motion(const MotionSums& sums, double dt) {
  for (const Field& field : fields_) {
    WallAction<dim> action = walls_.extension_impulse(field, field.end);
    if (transfer_.increments) {
      const WallAction<dim> before = walls_.extension_impulse(field, field.start);
      action.linear -= before.linear;
      action.angular -= before.angular;
    }
    pending_.wall.linear += action.linear;
    pending_.wall.angular += action.angular;
  }
  for (int d = 0; d < dim; ++d) {
    Account& account = ledger_.momentum[static_cast<std::size_t>(d)];
    const double reflected = sums.reflected[static_cast<std::size_t>(d)];
    account.book(Flow::walls, pending_.wall.linear[d] + pending_.map_wall.linear[d] + reflected);
    account.book(Flow::body_force, pending_.body[d]);
    if (contact_) account.book(Flow::contact, pending_.contact.linear[d]);
  }
  for (int k = 0; k < rotations; ++k) {
    const std::size_t axis = about + static_cast<std::size_t>(k);
    Account& account = ledger_.angular_momentum[axis];
    account.book(Flow::walls, pending_.wall.angular[k] + pending_.map_wall.angular[k] + sums.reflected_turn[axis]);
    account.book(Flow::body_force, pending_.body_angular[k]);
    if (contact_) account.book(Flow::contact, pending_.contact.angular[k]);
    account.book(Flow::transfer, pending_.filter_turn[k] - sums.torque[axis]);
    account.book(Flow::integration, sums.moved[axis] + pending_.force_turn[k]);
  }
  ledger_.energy.book(Flow::walls, pending_.wall_work + pending_.map_wall_work);
  ledger_.energy.book(Flow::body_force, pending_.body_work);
  if (contact_) ledger_.energy.book(Flow::contact, pending_.contact.work);
  ledger_.energy.book(Flow::transfer, -pending_.map_loss - sums.lost);
  ledger_.energy.book(Flow::integration, -pending_.stress_power);
  ledger_.viscous += pending_.viscous;
  pistons_.advance(dt);
  moved_ = true;
}

// to = P from: what the nodes have of `from` after it went to the points and back.
template <class G>
void Mechanics<G>::pass_to_points_and_back(std::size_t field_index, const std::vector<Vec>& from,
                                           std::vector<Vec>& to) {
  Field& field = fields_[field_index];
  field.for_touched(grid_, [&](std::size_t i) { field.momentum[i].setZero(); });
  for (std::size_t b = 0; b < located_.size(); ++b) {
    if (located_[b].field != field_index) continue;
    const Columns& points = scene_.bodies[b].points;
    const Weights<dim>& at = located_[b].weights;
    const int n = points.points();
    std::vector<double> seen(static_cast<std::size_t>(dim * n + lanes));
    std::array<typename Loops::Gather, dim> there;
    std::array<typename Loops::Spread, dim> back;
    for (int d = 0; d < dim; ++d) {
      const auto k = static_cast<std::size_t>(d);
      there[k] = {component(from, d), dim, seen.data() + d * n};
      back[k] = {seen.data() + d * n, points(column::mass), component(field.momentum, d), dim};
    }
    for_chunks(at.bins, options_.threads, [&](const Chunk& chunk) { loops_->gather(points, at, chunk, there); });
    for_chunks_writing_nodes(at.bins, options_.threads,
                             [&](const Chunk& chunk) { loops_->spread(points, at, chunk, back); });
  }
  walls_.fold(field, field.momentum);
  solve_velocity(field, to);
}

// w of the transfers xpic and fmpm: the velocity whose smoothing by a map is undone by m terms. Its momentum is that of
// the grid but for what walls take meanwhile.
template <class G>
void Mechanics<G>::filter_velocities() {
  if (transfer_.order == 0) return;
  for (std::size_t f = 0; f < fields_.size(); ++f) {
    Field& field = fields_[f];
    std::vector<Vec> left = transfer_.filters_end ? field.end : field.start, passed(left.size(), Vec::Zero());
    field.filtered = left;
    for (int j = 1; j < transfer_.order; ++j) {
      pass_to_points_and_back(f, left, passed);
      field.for_touched(grid_, [&](std::size_t i) {
        left[i] -= passed[i];
        field.filtered[i] += left[i];  // [XPIC 1] [FMPM 1]
      });
    }
    field.for_touched(grid_, [&](std::size_t i) {
      if (!transfer_.filters_end) field.filtered[i] += field.end[i] - field.start[i];  // [XPIC 1]
    });
    walls_.extend(field, field.filtered);
    field.for_touched(grid_, [&](std::size_t i) {
      const Vec change = field.own_mass[i] * (field.filtered[i] - field.end[i]);
      pending_.wall.linear += change;
      pending_.filter_turn += cross<dim>(grid_.position(static_cast<int>(i)), change);
    });
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
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    Weights<dim>& at = located_[b].weights;
    at.keep(body.points);
    const std::vector<Vec>* carried = carrying == NodalVelocity::end ? nullptr : &nodal(field_of(b), carrying);
    const MotionSums own = sum_over_chunks<MotionSums>(at.bins, options_.threads, [&](const Chunk& chunk) {
      return loops_->gather_motion(body, at, chunk, field_of(b), {.dt = dt, .drift = drift, .carrying = carried});
    });
    stop_if_too_far(own, body);
    sums += own;
  }
  moved_ = true;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    if (!drift) relax_chain(b, sums);
  }
  book_motion(sums, dt);
}

template <class G>
void Mechanics<G>::drift_points(double dt) {
  survey_.reset();
  places_known_ = places_known_ && moved_;  // what has moved before keeps the weights that moved it
  drifted_ += dt;
  MotionSums sums;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    const MotionSums own = sum_over_chunks<MotionSums>(
        located_[b].weights.bins, options_.threads, [&](const Chunk& chunk) {
          MotionSums one;
          for (int d = 0; d < dim; ++d) {
            double* x = body.points(column::position, d);
            const double* v = body.points(column::velocity, d);
            for_packs(
                chunk.first, chunk.last, [&](int p, int count) __attribute__((always_inline)) {
                  const Pack step = dt * load(v + p);
                  if (one.too_far < 0 && any_of(!(abs(step) <= grid_.h()) && first_lanes(count))) one.too_far = p;
                  store(x + p, load(x + p) + step, count);  // [Leapfrog 1]
                });
          }
          reflect(body, {chunk.first, chunk.last}, one);
          return one;
        });
    pending_.dt = dt;
    stop_if_too_far(own, body);
    sums += own;
  }
  for (int d = 0; d < dim; ++d) {
    const auto k = static_cast<std::size_t>(d);
    if (sums.reflected[k] != 0) ledger_.momentum[k].book(Flow::walls, sums.reflected[k]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (sums.reflected_turn[k] != 0) ledger_.angular_momentum[k].book(Flow::walls, sums.reflected_turn[k]);
  }
  moved_ = true;
}

template <class G>
void Mechanics<G>::return_transfer_loss() {
  want_places("return_transfer_loss");
  want_losses("return_transfer_loss");
  survey_.reset();
  hand_loss_over();
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    if (!body.material->takes_heat()) continue;
    take_loss(b);
    const double* loss = body.points(column::transfer_loss);
    const double returned = sum_over_chunks<double>(
        located_[b].weights.bins, options_.threads, [&](const Chunk& chunk) {
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
  const char* stage = drift ? "kick_heat_and_drift_points" : "move_and_heat_points";
  want_places(stage);
  want_losses(stage);
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
  const bool rates_wanted = rate_of_ != NodalVelocity::midpoint, power_wanted = pending_.power;
  Sums all;
  const auto finish = [&](std::size_t b) {
    Body& body = scene_.bodies[b];
    const bool heated = body.material->takes_heat();
    const double* loss = heated ? body.points(column::transfer_loss) : nullptr;
    const Field& field = field_of(b);
    const std::vector<Vec>& midpoint = rates_wanted ? straining_velocity(field_of(b), NodalVelocity::midpoint)
                                                    : field.midpoint;
    const typename Loops::Motion motion{
        .dt = dt, .drift = drift, .straining = rates_wanted ? &midpoint : nullptr, .exchange = exchanges_heat(body)};
    Weights<dim>& at = located_[b].weights;
    if (heated) take_loss(b);
    if (body.chain || hands_over(b)) at.keep(body.points);
    const auto move = [&](const Chunk& chunk) { return loops_->gather_motion(body, at, chunk, field, motion); };
    Sums own;
    if (body.chain) {  // all points of a chain move before any looks where its neighbours stand
      own.motion = sum_over_chunks<MotionSums>(located_[b].weights.bins, options_.threads, move);
      stop_if_too_far(own.motion, body);
      relax_chain(b, own.motion);
    }
    own = own + sum_over_chunks<Sums>(located_[b].weights.bins, options_.threads, [&](const Chunk& chunk) {
            const PointRange range{chunk.first, chunk.last};
            Sums sums;
            if (!body.chain) sums.motion = move(chunk);
            sums.power.power = stress_power(body, range, dt);
            sums.power.viscous = body.material->viscous_heat(body.points, range, context(), dt);
            sums.power.stored = body.material->advance(body.points, range, context(), dt);  // [EC-APIC 6]
            if (loss) {
              body.material->add_heat(body.points, range, loss);
              for (int p = range.first; p < range.last; ++p) sums.returned += loss[p];
            }
            if (body.chain) return sums;
            if (drift) reflect(body, range, sums.motion);
            sums.survey = loops_->survey(body, range);
            return sums;
          });
    if (body.chain) {
      smooth_strain(b, dt);
      own = own + sum_over_chunks<Sums>(located_[b].weights.bins, options_.threads, [&](const Chunk& chunk) {
              Sums sums;
              if (drift) reflect(body, {chunk.first, chunk.last}, sums.motion);
              sums.survey = loops_->survey(body, {chunk.first, chunk.last});
              return sums;
            });
    }
    stop_if_too_far(own.motion, body);
    all += own;
  };
  for (const bool heated : {false, true}) {  // first those whose loss heats the others
    for (std::size_t b = 0; b < located_.size(); ++b) {
      if (scene_.bodies[b].material->takes_heat() == heated) finish(b);
    }
    if (heated) continue;
    hand_loss_over();
  }
  if (power_wanted) {
    pending_.stress_power = all.power.power;
    pending_.viscous = all.power.viscous;
    pending_.power = false;
  }
  book_motion(all.motion, dt);
  ledger_.energy.book(Flow::integration, all.power.power);
  ledger_.energy.book(Flow::constitutive, all.power.stored - all.power.power);
  ledger_.energy.book(Flow::transfer, all.returned);
  rate_of_ = NodalVelocity::current;
  places_known_ = false;  // nobody kept where the points stood: a step ends here
  all.survey.totals.grid_mass = grid_mass_;
  survey_ = all.survey;
}

}  // namespace plumbline
