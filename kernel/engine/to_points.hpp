// Grid to points, and the booking of what a step did.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "kernel/engine/chunks.hpp"

namespace plumbline {

template <class G, class S, class T>
auto Mechanics<G, S, T>::MotionSums::operator+=(const MotionSums& o) -> MotionSums& {
  lost += o.lost;
  for (std::size_t k = 0; k < 3; ++k) {
    torque[k] += o.torque[k];
    moved[k] += o.moved[k];
    reflected[k] += o.reflected[k];
    reflected_turn[k] += o.reflected_turn[k];
  }
  if (too_far < 0) too_far = o.too_far;
  return *this;
}

// straining: also the strain rates of this nodal velocity. exchange: also e_p += sum_i N_ip alpha_i (E_i - e_p), which
// conserves sum_p m_p e_p node by node, and leaves no energy negative: each becomes a mean of what points have. [Exchange 1]
template <class G, class S, class T>
auto Mechanics<G, S, T>::gather_motion(Body& body, const Located& at, const Chunk& chunk, const Field& field, double dt,
                                       std::optional<double> drift, const std::vector<Vec>* straining, bool exchange,
                                       const std::vector<Vec>* carrying) const -> MotionSums {
  Columns& points = body.points;
  const RateColumns rates = rate_columns(body);
  double* energy = exchange ? points(column::energy) : nullptr;
  const Places places = this->places(body, at);
  const double* mass = points(column::mass);
  double* loss = points.has(column::transfer_loss) ? points(column::transfer_loss) : nullptr;
  double *velocity[dim], *position[dim], *affine[dim][dim] = {};
  for (int d = 0; d < dim; ++d) {
    velocity[d] = points(column::velocity, d);
    position[d] = points(column::position, d);
    for (int e = 0; T::affine && e < dim; ++e) affine[d][e] = points(column::affine, d * dim + e);
  }
  MotionSums sums;
  Pack lost = 0.0, torque[3] = {0.0, 0.0, 0.0}, moved[3] = {0.0, 0.0, 0.0};
  const bool increments = !T::affine && transfer_.increments, filters = !T::affine && transfer_.order > 0;
  const bool loss_first = loss && increments;
  for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
    const BinVelocity end = bin_velocity(print, field.end);
    double strained[nodes][dim], alpha[nodes], heat[nodes], most_exchange = 0;
    for_stencil_nodes(print, [&](int k, std::size_t i) {
      for (int d = 0; straining && d < dim; ++d) strained[k][d] = (*straining)[i][d];
      if (!exchange) return;
      alpha[k] = field.exchange[i];
      heat[k] = alpha[k] * field.heat[i];
      most_exchange = std::max(most_exchange, alpha[k]);
    });
    double change[nodes][dim], change_square[nodes], carried[nodes][dim];
    if (increments || filters || carrying) {
      for_stencil_nodes(print, [&](int k, std::size_t i) {
        change_square[k] = 0;
        for (int d = 0; d < dim; ++d) {
          change[k][d] = increments ? field.end[i][d] - field.start[i][d]
                         : filters  ? field.filtered[i][d] - end.base[d]
                                    : 0;
          change_square[k] += change[k][d] * change[k][d];
          if (carrying) carried[k][d] = (*carrying)[i][d];
        }
      });
    }
    for_packs(first, last, [&](int p, int count) {
      const PackStencil weights = stencil(places, anchor, p);
      if (straining) {
        store_strain_rates(rates, weights, load(places.x[0] + p), p, count,
                           [&](int k, int d) { return strained[k][d]; });
      }
      if (most_exchange > 0) {
        const Pack share = weights.gather_array([&](int k) { return alpha[k]; }).value, e = load(energy + p);
        store(energy + p, e + (weights.gather_array([&](int k) { return heat[k]; }).value - share * e), count);
      }
      const Pack m = kept(load(mass + p), count);
      Pack v[dim], v_new[dim], c[dim][dim], inertia[dim], here[dim];
      for (int d = 0; d < dim; ++d) {
        inertia[d] = weights.inertia(d);
        here[d] = load(position[d] + p);
      }
      Pack square = 0.0;  // of what the grid carries, less what the point keeps of it
      if (increments) {
        square = weights.gather_array([&](int k) { return change_square[k]; }).value;
      } else {
        square = weights.gather_array([&](int k) { return end.square[k]; }).value;
      }
      for (int d = 0; d < dim; ++d) {
        const auto u = weights.gather_array([&](int k) { return end.u[k][d]; });
        v[d] = u.value + end.base[d];
        if (increments) {
          const auto a = weights.gather_array([&](int k) { return change[k][d]; });
          v_new[d] = load(velocity[d] + p) + a.value;  // [York 3.22]
          square -= a.value * a.value;
          for (int e = 0; e < dim; ++e) c[d][e] = a.affine[e];
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
      for (int d = 0; d < dim; ++d) {
        const Pack step = drift ? *drift * v_new[d] : dt * v[d];
        too_far = too_far || !(abs(step) <= grid_.h());
        store(velocity[d] + p, v_new[d], count);
        here[d] += step;
        store(position[d] + p, here[d], count);  // [York 3.21]
      }
      if (sums.too_far < 0 && any_of(too_far && first_lanes(count))) sums.too_far = p;
      for (int k = 0; k < rotations; ++k) {
        const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
        // N r x u, but for what an affine part keeps of it.
        if constexpr (!T::affine || !S::fixed_inertia) torque[k] += m * (inertia[a] * c[b][a] - inertia[b] * c[a][b]);
        if (!drift) moved[k] += m * dt * (v[a] * v_new[b] - v[b] * v_new[a]);
      }
      if constexpr (T::affine) {
        // With the inertia of the new place: where that is another, so are the energy and the spin of the affine part.
        for (int d = 0; !S::fixed_inertia && d < dim; ++d) {
          const Pack cells = (here[d] - grid_.origin(d)) * (1 / grid_.h());
          inertia[d] = inertia_at(cells, box(places, d, p)) * (grid_.h() * grid_.h());
        }
        for (int d = 0; d < dim; ++d) {
          for (int e = 0; e < dim; ++e) {
            square -= inertia[e] * c[d][e] * c[d][e];
            store(affine[d][e] + p, c[d][e], count);
          }
        }
        for (int k = 0; !S::fixed_inertia && k < rotations; ++k) {
          const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
          torque[k] -= m * (inertia[a] * c[b][a] - inertia[b] * c[a][b]);
        }
      }
      // Never negative but by rounding, and a cold gas has nothing to pay that with. Only a changing inertia can give.
      if (!filters && (!T::affine || S::fixed_inertia)) square = max(square, Pack(0.0));
      const Pack given = 0.5 * m * square;  // [EC-APIC 5]
      if (loss) store(loss + p, loss_first ? given : load(loss + p) + given, count);
      lost += given;
    });
  });
  sums.lost = sum(lost);
  const std::size_t about = dim == 2 ? 2 : 0;
  for (int k = 0; k < rotations; ++k) {
    sums.torque[about + static_cast<std::size_t>(k)] = sum(torque[k]);
    sums.moved[about + static_cast<std::size_t>(k)] = sum(moved[k]);
  }
  return sums;
}

// Least and largest of x over the range; where any is not a number, all is in between.
template <class G, class S, class T>
std::pair<double, double> Mechanics<G, S, T>::extent(const double* x, PointRange range) {
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
template <class G, class S, class T>
void Mechanics<G, S, T>::reflect(Body& body, PointRange range, MotionSums& sums) const {
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

template <class G, class S, class T>
void Mechanics<G, S, T>::reflect_point(Body& body, int p, int d, double wall, MotionSums& sums) const {
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
      for (int e = 0; T::affine && e < dim; ++e) c(k, e) = points(column::affine, k * dim + e)[p];
    }
    Spin<dim> turn = cross<dim>(x, v);
    for (int k = 0; T::affine && k < rotation_count<dim>; ++k) {
      const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
      const auto inertia = [&](int e) { return inertia_of(points, e, p); };
      turn[k] += inertia(a) * c(b, a) - inertia(b) * c(a, b);
    }
    const std::size_t about = dim == 2 ? 2 : 0;
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
    for (int e = 0; T::affine && e < dim; ++e)
      points(column::affine, k * dim + e)[p] = (e == d ? -sign : sign) * c(k, e);
  }
  momenta(1);
}

// Weights stay those of where the points stood when they were located.
template <class G, class S, class T>
void Mechanics<G, S, T>::keep_places(Body& body, Located& at) const {
  for (int d = 0; d < dim; ++d) {
    const double* x = body.points(column::position, d);
    at.frozen[static_cast<std::size_t>(d)].assign(x, x + body.points.points() + lanes - 1);
  }
}

// Without its weights a stage would read and write anywhere.
template <class G, class S, class T>
void Mechanics<G, S, T>::want_places(const char* stage) const {
  if (!places_known_)
    throw std::logic_error(std::string(stage) + " wants the points located: locate_points comes first");
}

// Points carry what the maps take only for integrators that were seen to give it back.
template <class G, class S, class T>
void Mechanics<G, S, T>::want_losses(const char* stage) const {
  for (const Body& body : scene_.bodies) {
    if (!body.material->takes_heat() || body.points.has(column::transfer_loss)) continue;
    throw std::logic_error(std::string(stage) +
                           " is called first in a later step than those that tell the integrator's traits");
  }
}

template <class G, class S, class T>
void Mechanics<G, S, T>::stop_if_too_far(const MotionSums& sums, const Body& body) const {
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

template <class G, class S, class T>
void Mechanics<G, S, T>::book_motion(const MotionSums& sums, double dt) {
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
  const std::size_t about = dim == 2 ? 2 : 0;
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
template <class G, class S, class T>
void Mechanics<G, S, T>::pass_to_points_and_back(std::size_t field_index, const std::vector<Vec>& from,
                                                 std::vector<Vec>& to) {
  Field& field = fields_[field_index];
  field.for_touched(grid_, [&](std::size_t i) { field.momentum[i].setZero(); });
  for (std::size_t b = 0; b < located_.size(); ++b) {
    const Located& at = located_[b];
    if (at.field != field_index) continue;
    const Body& body = scene_.bodies[b];
    const Places places = this->places(body, at);
    const double* mass = body.points(column::mass);
    for_chunks_writing_nodes(at, [&](const Chunk& chunk) {
      for_bins(at.bins, chunk, [&](const Print& print, const double(&anchor)[dim], int first, int last) {
        Pack sums[nodes * dim];
        for (Pack& s : sums) s = 0.0;
        for_packs(first, last, [&](int p, int count) {
          const PackStencil weights = stencil(places, anchor, p);
          const Pack m = kept(load(mass + p), count);
          for (int d = 0; d < dim; ++d) {
            const Pack v = weights.gather(print, [&](std::size_t i) { return Pack(from[i][d]); }).value;
            weights.spread(m * v, sums + d, dim);
          }
        });
        add_to_nodes<dim>(print, sums, [&](std::size_t i, const double* total) {
          for (int d = 0; d < dim; ++d) field.momentum[i][d] += total[d];
        });
      });
    });
  }
  walls_.fold(field, field.momentum);
  solve_velocity(field, to);
}

// w of the transfers xpic and fmpm: the velocity whose smoothing by a map is undone by m terms. Its momentum is that of
// the grid but for what walls take meanwhile.
template <class G, class S, class T>
void Mechanics<G, S, T>::filter_velocities() {
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

template <class G, class S, class T>
void Mechanics<G, S, T>::move_points(double dt, NodalVelocity carrying) {
  want_places("move_points");
  gather_all_motion(dt, {}, carrying);
}

template <class G, class S, class T>
void Mechanics<G, S, T>::kick_points(double dt) {
  want_places("kick_points");
  gather_all_motion(dt, 0.0, NodalVelocity::end);
}

template <class G, class S, class T>
void Mechanics<G, S, T>::gather_all_motion(double dt, std::optional<double> drift, NodalVelocity carrying) {
  settle_power();
  settle_loss();
  filter_velocities();
  survey_.reset();
  MotionSums sums;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    keep_places(body, located_[b]);
    const MotionSums own = sum_over_chunks<MotionSums>(located_[b], [&](const Chunk& chunk) {
      const std::vector<Vec>* carried = carrying == NodalVelocity::end ? nullptr : &nodal(field_of(b), carrying);
      return gather_motion(body, located_[b], chunk, field_of(b), dt, drift, nullptr, false, carried);
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

template <class G, class S, class T>
void Mechanics<G, S, T>::drift_points(double dt) {
  survey_.reset();
  places_known_ = places_known_ && moved_;  // what has moved before keeps the weights that moved it
  drifted_ += dt;
  MotionSums sums;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    const MotionSums own = sum_over_chunks<MotionSums>(located_[b], [&](const Chunk& chunk) {
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

template <class G, class S, class T>
void Mechanics<G, S, T>::return_transfer_loss() {
  want_places("return_transfer_loss");
  want_losses("return_transfer_loss");
  survey_.reset();
  hand_loss_over();
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    if (!body.material->takes_heat()) continue;
    take_loss(b);
    const double* loss = body.points(column::transfer_loss);
    const double returned = sum_over_chunks<double>(located_[b], [&](const Chunk& chunk) {
      body.material->add_heat(body.points, {chunk.first, chunk.last}, loss);
      double sum = 0;
      for (int p = chunk.first; p < chunk.last; ++p) sum += loss[p];
      return sum;
    });
    ledger_.energy.book(Flow::transfer, returned);
  }
}

template <class G, class S, class T>
void Mechanics<G, S, T>::move_and_heat_points(double dt) {
  finish_points(dt, {});
}

template <class G, class S, class T>
void Mechanics<G, S, T>::kick_heat_and_drift_points(double dt, double drift) {
  finish_points(dt, drift);
}

template <class G, class S, class T>
void Mechanics<G, S, T>::finish_points(double dt, std::optional<double> drift) {
  const char* stage = drift ? "kick_heat_and_drift_points" : "move_and_heat_points";
  want_places(stage);
  want_losses(stage);
  settle_loss();
  filter_velocities();
  struct Sums {
    MotionSums motion;
    PowerSums power;
    Survey survey;
    double stored = 0, returned = 0;
    Sums& operator+=(const Sums& o) {
      motion += o.motion;
      power += o.power;
      survey += o.survey;
      stored += o.stored;
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
    const bool exchange = exchanges_heat(body);
    if (heated) take_loss(b);
    if (body.chain || hands_over(b)) keep_places(body, located_[b]);
    const auto move = [&](const Chunk& chunk) {
      return gather_motion(body, located_[b], chunk, field, dt, drift, rates_wanted ? &midpoint : nullptr, exchange,
                           nullptr);
    };
    Sums own;
    if (body.chain) {  // all points of a chain move before any looks where its neighbours stand
      own.motion = sum_over_chunks<MotionSums>(located_[b], move);
      stop_if_too_far(own.motion, body);
      moved_ = true;
      relax_chain(b, own.motion);
      moved_ = false;
    }
    own = own + sum_over_chunks<Sums>(located_[b], [&](const Chunk& chunk) {
            const PointRange range{chunk.first, chunk.last};
            Sums sums;
            if (!body.chain) sums.motion = move(chunk);
            sums.power.power = stress_power(body, range, dt);
            sums.power.viscous = body.material->viscous_heat(body.points, range, context(), dt);
            sums.stored = body.material->advance(body.points, range, context(), dt);  // [EC-APIC 6]
            if (loss) {
              body.material->add_heat(body.points, range, loss);
              for (int p = range.first; p < range.last; ++p) sums.returned += loss[p];
            }
            if (body.chain) return sums;
            if (drift) reflect(body, range, sums.motion);
            sums.survey = survey(body, range);
            return sums;
          });
    if (body.chain) {
      moved_ = true;
      smooth_strain(b, dt);
      moved_ = false;
      own = own + sum_over_chunks<Sums>(located_[b], [&](const Chunk& chunk) {
              Sums sums;
              if (drift) reflect(body, {chunk.first, chunk.last}, sums.motion);
              sums.survey = survey(body, {chunk.first, chunk.last});
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
    moved_ = true;
    hand_loss_over();
    moved_ = false;
  }
  if (power_wanted) {
    pending_.stress_power = all.power.power;
    pending_.viscous = all.power.viscous;
    pending_.power = false;
  }
  book_motion(all.motion, dt);
  ledger_.energy.book(Flow::integration, all.power.power);
  ledger_.energy.book(Flow::constitutive, all.stored - all.power.power);
  ledger_.energy.book(Flow::transfer, all.returned);
  rate_of_ = NodalVelocity::current;
  places_known_ = false;  // nobody kept where the points stood: a step ends here
  all.survey.totals.grid_mass = grid_mass_;
  survey_ = all.survey;
}

}  // namespace plumbline
