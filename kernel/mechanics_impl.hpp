// The stages as loops over points and nodes. Included only by the files that instantiate it for a geometry.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "kernel/density/cell_density.hpp"
#include "kernel/inadmissible.hpp"
#include "kernel/mechanics.hpp"
#include "kernel/points/components.hpp"
#include "kernel/stencil.hpp"
#include "kernel/summation.hpp"
#include "kernel/transfers/transfers.hpp"
#include "kernel/velocity_field.hpp"
#include "kernel/walls.hpp"

namespace plumbline {

template <class Geometry, class Shape, class Transfer>
class Mechanics final : public Engine {
 public:
  static constexpr int dim = Geometry::dim;
  using Vec = typename Geometry::Vec;
  using Mat = typename Geometry::Mat;
  using Strain = typename Geometry::Strain;
  // So far beyond a side, in cells, a point still stands on it: on a wall it drifts by the rounding of a sum that is zero.
  static constexpr double on_side = 1e-9;

  Mechanics(Scene& scene, Ledger& ledger, bool keep_loss);

  void locate_points() override;
  void map_mass_and_momentum() override;
  void map_forces() override;
  void advance_momentum(double dt) override;
  void move_points(double dt) override;
  void map_momentum() override;
  void strain_points(double dt, NodalVelocity velocity) override;
  void evaluate_stress(NodalVelocity velocity) override;
  bool reverse_cooling() override;
  void return_transfer_loss() override;
  State state() const override;
  void set_state(const State& state) override;
  State rate() override;

  void initialise() override;
  Totals totals() const override;
  void refresh_density() override;
  void check() const override;
  double step_limit() const override;

 private:
  // What the engine knows of a body beside its columns.
  struct Located {
    std::size_t field;
    std::vector<int> lowest;         // flat index of the lowest node reached, per point
    std::vector<double> local[dim];  // coordinate of the point in its cell, per point
  };
  struct MotionSums {
    double lost = 0, torque = 0, moved = 0;
    MotionSums& operator+=(const MotionSums& o) {
      lost += o.lost;
      torque += o.torque;
      moved += o.moved;
      return *this;
    }
    friend MotionSums operator+(MotionSums a, const MotionSums& b) { return a += b; }
  };
  // Flows of the step under way; the last advance_momentum and map count, and move_points books them.
  struct Pending {
    Vec wall = Vec::Zero(), body = Vec::Zero();
    double wall_angular = 0, body_angular = 0, body_work = 0, stress_power = 0, map_loss = 0, viscous = 0;
    Vec map_wall = Vec::Zero();
    double map_wall_angular = 0, map_torque = 0;
  };
  using Field = VelocityField<dim>;

  Stencil<dim, Shape> stencil(const Located& at, int p) const {
    double local[dim];
    for (int d = 0; d < dim; ++d) local[d] = at.local[d][static_cast<std::size_t>(p)];
    return {at.lowest[static_cast<std::size_t>(p)], grid_.row_length(), local, grid_.h()};
  }
  // D_p at the place x, per direction.
  Vec inertia(const Vec& x) const {
    Vec d2;
    for (int d = 0; d < dim; ++d) {
      const double cells = Shape::fixed_inertia ? 0.0 : grid_.logical(x[d], d);
      d2[d] = Shape::inertia(cells - std::floor(cells)) * grid_.h() * grid_.h();
    }
    return d2;
  }
  // Pointers to the components of a column, taken once per loop.
  template <class Value>
  using Reading = Components<Value, const double>;
  template <class Value>
  using Writing = Components<Value, double>;
  MaterialContext context() const { return {dim, grid_.h(), scene_.density == DensityMethod::continuity}; }
  const std::vector<Vec>& nodal(const Field& field, NodalVelocity which) const;

  void place(Body& body, Located& at);
  bool sort_points(Body& body, Located& at);
  template <bool with_mass>
  void scatter_momentum(const Body& body, const Located& at, Field& field) const;
  void solve_velocity(Field& field, std::vector<Vec>& velocity) const;
  double book_map_loss(Body& body, const Located& at, const Field& field) const;
  void find_strain_rates(NodalVelocity which);
  void add_body_force(Field& field, double dt);
  double stress_power(const Body& body, double dt) const;
  void settle_pending_strain();
  MotionSums gather_motion(Body& body, const Located& at, const Field& field, double dt);
  void book_motion(double dt);
  void evaluate_densities();
  void grid_density(Body& body, const Located& at);
  void map_own_mass(Body& body);
  void touch(const Located& at, Field& field) const;
  template <class Visit>
  void for_state_columns(Visit&& visit) const;
  Totals body_totals(const Body& body) const;

  Scene& scene_;
  Ledger& ledger_;
  Grid<dim> grid_;
  Walls<dim> walls_;
  Vec gravity_;
  std::vector<Field> fields_;
  std::vector<Located> located_;
  std::vector<bool> alone_;             // per field: whether a single body moves with it
  std::vector<double> inverse_volume_;  // 1 / |cell_i|, m^-dim
  struct OwnMass {
    Field field;
    Located at;
  };
  std::optional<OwnMass> own_mass_;  // a body's mass alone, where its points stand now
  Pending pending_;
  NodalVelocity current_ = NodalVelocity::start;
  bool moved_ = true, forces_mapped_ = false, sorting_ = true;
  double grid_mass_ = 0;
  NodalVelocity rate_of_ = NodalVelocity::current;     // velocity the strain_rate columns hold; current: none
  double pending_strain_dt_ = 0, pending_stored_ = 0;  // strained before the forces were known
};

template <class G, class S, class T>
Mechanics<G, S, T>::Mechanics(Scene& scene, Ledger& ledger, bool keep_loss)
    : scene_(scene),
      ledger_(ledger),
      grid_(scene.grid),
      walls_(grid_) {
  for (int d = 0; d < dim; ++d) gravity_[d] = scene.gravity[static_cast<std::size_t>(d)];
  std::vector<std::string> names;
  for (Body& body : scene.bodies) {
    const auto found = std::find(names.begin(), names.end(), body.field);
    const bool first_of_field = found == names.end();
    Located at;
    at.field = static_cast<std::size_t>(found - names.begin());
    if (first_of_field) {
      names.push_back(body.field);
      fields_.emplace_back(grid_);
    }
    alone_.resize(fields_.size(), true);
    if (!first_of_field) alone_[at.field] = false;
    at.lowest.resize(static_cast<std::size_t>(body.points.points()));
    for (auto& local : at.local) local.resize(at.lowest.size());
    located_.push_back(std::move(at));
    if (T::affine) body.points.add(column::affine, dim * dim);
    if (keep_loss && body.material->takes_heat()) body.points.add(column::transfer_loss);
  }
  inverse_volume_.resize(static_cast<std::size_t>(grid_.node_count()));
  for (int i = 0; i < grid_.node_count(); ++i) {
    double volume = 1;
    for (int d = 0; d < dim; ++d) {
      volume *= grid_.h() * walls_.cell_share(d == 0 ? i % grid_.row_length() : i / grid_.row_length(), d);
    }
    inverse_volume_[static_cast<std::size_t>(i)] = 1 / volume;
  }
}

template <class G, class S, class T>
auto Mechanics<G, S, T>::nodal(const Field& field, NodalVelocity which) const -> const std::vector<Vec>& {
  switch (which == NodalVelocity::current ? current_ : which) {
    case NodalVelocity::end:
      return field.end;
    case NodalVelocity::midpoint:
      return field.midpoint;
    case NodalVelocity::remapped:
      return field.remapped;
    default:
      return field.start;
  }
}

// --- locating -------------------------------------------------------------------------------------------------------

template <class G, class S, class T>
void Mechanics<G, S, T>::place(Body& body, Located& at) {
  for (int p = 0; p < body.points.points(); ++p) {
    int node = 0;
    for (int d = dim - 1; d >= 0; --d) {
      const double x = grid_.logical(body.points(column::position, d)[p], d);
      if (!(x >= -on_side && x <= grid_.cells(d) + on_side)) {
        throw InadmissibleState("a point left the grid", body.name, body.id[static_cast<std::size_t>(p)],
                                column::position.name(), body.points(column::position, d)[p]);
      }
      const int anchor = S::anchor(std::clamp(x, 0.0, 1.0 * grid_.cells(d)), grid_.cells(d),
                                   at.local[d][static_cast<std::size_t>(p)]);
      node = node * grid_.row_length() + anchor + S::first + Grid<dim>::ghosts;
    }
    at.lowest[static_cast<std::size_t>(p)] = node;
  }
}

// Sorts points by cell once more than one in sixteen is out of order; ties keep the order in which the scene made the
// points, so the order depends on the points' places alone.
template <class G, class S, class T>
bool Mechanics<G, S, T>::sort_points(Body& body, Located& at) {
  const std::size_t n = at.lowest.size();
  std::size_t inversions = 0;
  for (std::size_t p = 1; p < n; ++p) inversions += at.lowest[p] < at.lowest[p - 1];
  if (body.chain || inversions * 16 <= n) return false;
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const auto ka = static_cast<std::size_t>(a), kb = static_cast<std::size_t>(b);
    return at.lowest[ka] != at.lowest[kb] ? at.lowest[ka] < at.lowest[kb] : body.id[ka] < body.id[kb];
  });
  body.points.reorder(order);
  std::vector<int> ids(n);
  for (std::size_t p = 0; p < n; ++p) ids[p] = body.id[static_cast<std::size_t>(order[p])];
  body.id = std::move(ids);
  return true;
}

// Marks the nodes that the points reach.
template <class G, class S, class T>
void Mechanics<G, S, T>::touch(const Located& at, Field& field) const {
  const int row_length = grid_.row_length();
  for (const int node : at.lowest) {
    const int row = node / row_length, first = node - row * row_length, last = first + S::support;
    for (int j = row; j < row + (dim == 1 ? 1 : S::support); ++j) {
      auto& range = field.touched[static_cast<std::size_t>(j)];
      range = range.first == range.second ? std::pair{first, last}
                                          : std::pair{std::min(range.first, first), std::max(range.second, last)};
    }
  }
}

template <class G, class S, class T>
void Mechanics<G, S, T>::locate_points() {
  for (Field& field : fields_) std::fill(field.touched.begin(), field.touched.end(), std::pair<int, int>{0, 0});
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Located& at = located_[b];
    place(scene_.bodies[b], at);
    if (sorting_ && sort_points(scene_.bodies[b], at)) place(scene_.bodies[b], at);
    touch(at, fields_[at.field]);
  }
  for (Field& field : fields_) walls_.include_mirrors(field.touched);
  pending_ = Pending{};
  moved_ = forces_mapped_ = false;
  rate_of_ = NodalVelocity::current;
  pending_strain_dt_ = pending_stored_ = 0;
}

// --- points to grid -------------------------------------------------------------------------------------------------

template <class G, class S, class T>
template <bool with_mass>
void Mechanics<G, S, T>::scatter_momentum(const Body& body, const Located& at, Field& field) const {
  const double* mass = body.points(column::mass);
  const Reading<Vec> velocity(body.points, column::velocity);
  const Reading<Mat> affine(body.points, column::affine, T::affine);
  for (int p = 0; p < body.points.points(); ++p) {
    const double m = mass[p];
    const Vec v = velocity[p];
    Mat c;
    if constexpr (T::affine) c = affine[p];
    stencil(at, p).for_nodes([&](std::size_t i, double n, const Vec&, const Vec& r, const Vec&) {
      if constexpr (with_mass) field.mass[i] += n * m;
      if constexpr (T::affine) {
        field.momentum[i] += (n * m) * (v + c * r);  // [EC-APIC 1]
      } else {
        field.momentum[i] += (n * m) * v;  // [York 3.16]
      }
    });
  }
}

template <class G, class S, class T>
void Mechanics<G, S, T>::solve_velocity(Field& field, std::vector<Vec>& velocity) const {
  field.for_touched(grid_, [&](std::size_t i) {
    velocity[i] = field.mass[i] > least_mass ? Vec(field.momentum[i] / field.mass[i]) : Vec(Vec::Zero());
  });
  walls_.extend(field, velocity);
}

template <class G, class S, class T>
void Mechanics<G, S, T>::map_mass_and_momentum() {
  grid_mass_ = 0;
  pending_.map_wall.setZero();
  pending_.map_wall_angular = pending_.map_loss = 0;
  for (Field& field : fields_) {
    field.for_touched(grid_, [&](std::size_t i) {
      field.mass[i] = 0;
      field.momentum[i].setZero();
    });
  }
  for (std::size_t b = 0; b < located_.size(); ++b) {
    scatter_momentum<true>(scene_.bodies[b], located_[b], fields_[located_[b].field]);
  }
  for (Field& field : fields_) {
    double mass = 0;
    field.for_touched(grid_, [&](std::size_t i) { mass += field.own_mass[i] = field.mass[i]; });
    grid_mass_ += mass;
    walls_.fold_mass(field);
    const WallAction<dim> action = walls_.fold(field, field.momentum);
    if constexpr (!T::increments) {
      pending_.map_wall += action.linear;
      pending_.map_wall_angular += action.angular;
    }
    solve_velocity(field, field.start);
  }
  if constexpr (!T::increments) {
    for (std::size_t b = 0; b < located_.size(); ++b) {
      pending_.map_loss += book_map_loss(scene_.bodies[b], located_[b], fields_[located_[b].field]);
    }
  }
  current_ = NodalVelocity::start;
}

// sum_p m_p A_p with A_p = sum_i N_ip |v_p + C_p (x_i - x_p) - v_i|^2 / 2. [EC-APIC 1]
template <class G, class S, class T>
double Mechanics<G, S, T>::book_map_loss(Body& body, const Located& at, const Field& field) const {
  const double* mass = body.points(column::mass);
  double* loss = body.points.has(column::transfer_loss) ? body.points(column::transfer_loss) : nullptr;
  const Reading<Vec> velocity(body.points, column::velocity);
  const Reading<Mat> affine(body.points, column::affine, T::affine);
  return block_sum<double>(body.points.points(), [&](int p) {
    const Vec v = velocity[p];
    Mat c = Mat::Zero();
    if constexpr (T::affine) c = affine[p];
    double lost = 0;
    stencil(at, p).for_nodes([&](std::size_t i, double n, const Vec&, const Vec& r, const Vec&) {
      lost += n * (v + c * r - field.start[i]).squaredNorm();
    });
    lost *= 0.5 * mass[p];
    if (loss) loss[p] = lost;
    return lost;
  });
}

template <class G, class S, class T>
void Mechanics<G, S, T>::map_momentum() {
  for (Field& field : fields_) field.for_touched(grid_, [&](std::size_t i) { field.momentum[i].setZero(); });
  for (std::size_t b = 0; b < located_.size(); ++b) {
    scatter_momentum<false>(scene_.bodies[b], located_[b], fields_[located_[b].field]);
  }
  for (Field& field : fields_) {
    walls_.fold(field, field.momentum);
    solve_velocity(field, field.remapped);  // [York 3.24]
  }
  current_ = NodalVelocity::remapped;
  if (rate_of_ == NodalVelocity::remapped) rate_of_ = NodalVelocity::current;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::map_forces() {
  settle_pending_strain();
  for (Field& field : fields_) field.for_touched(grid_, [&](std::size_t i) { field.force[i].setZero(); });
  for (std::size_t b = 0; b < located_.size(); ++b) {
    const Body& body = scene_.bodies[b];
    Field& field = fields_[located_[b].field];
    const double* volume = body.points(column::volume);
    const Reading<Strain> stress(body.points, column::stress);
    for (int p = 0; p < body.points.points(); ++p) {
      const Strain s = volume[p] * stress[p];
      stencil(located_[b], p).for_nodes([&](std::size_t i, double, const Vec& g, const Vec&, const Vec&) {
        field.force[i] -= G::force(s, g);  // [York 3.17] [EC-APIC 4]
      });
    }
  }
  forces_mapped_ = true;
}

// --- the grid -------------------------------------------------------------------------------------------------------

// Body forces fold like all others: what a point puts on a ghost node pulls the mirror node the other way.
template <class G, class S, class T>
void Mechanics<G, S, T>::add_body_force(Field& field, double dt) {
  if (gravity_.isZero(0)) return;
  field.for_touched(grid_, [&](std::size_t i) {
    const Vec f = field.own_mass[i] * gravity_;  // [York 3.18]
    field.force[i] += f;
    pending_.body += dt * f;
    pending_.body_angular += dt * cross<dim>(grid_.position(static_cast<int>(i)), f);
  });
}

template <class G, class S, class T>
void Mechanics<G, S, T>::advance_momentum(double dt) {
  pending_.wall.setZero();
  pending_.body.setZero();
  pending_.wall_angular = pending_.body_angular = pending_.body_work = 0;
  for (Field& field : fields_) {
    add_body_force(field, dt);
    const WallAction<dim> action = walls_.fold(field, field.force);
    pending_.wall += dt * action.linear;
    pending_.wall_angular += dt * action.angular;
    field.for_touched(grid_, [&](std::size_t i) {
      const double m = field.mass[i];
      const Vec dv = m > least_mass ? Vec(dt / m * field.force[i]) : Vec(Vec::Zero());
      field.end[i] = field.start[i] + dv;  // [York 3.19, 3.20]
      field.midpoint[i] = field.start[i] + 0.5 * dv;
    });
    walls_.extend(field, field.end);
    walls_.extend(field, field.midpoint);
    if (gravity_.isZero(0)) continue;
    field.for_touched(
        grid_, [&](std::size_t i) { pending_.body_work += dt * field.own_mass[i] * gravity_.dot(field.midpoint[i]); });
  }
  current_ = NodalVelocity::end;
  rate_of_ = NodalVelocity::current;
  find_strain_rates(NodalVelocity::midpoint);
  pending_.stress_power = pending_.viscous = 0;
  for (const Body& body : scene_.bodies) {
    pending_.stress_power += stress_power(body, dt);
    pending_.viscous += body.material->viscous_heat(body.points, context(), dt);
  }
}

// dt sum_p V_p sigma_p : strain_rate_p
template <class G, class S, class T>
double Mechanics<G, S, T>::stress_power(const Body& body, double dt) const {
  const double* volume = body.points(column::volume);
  const Reading<Strain> stress(body.points, column::stress), rate(body.points, column::strain_rate);
  return block_sum<double>(body.points.points(), [&](int p) { return dt * volume[p] * stress[p].dot(rate[p]); });
}

// --- grid to points -------------------------------------------------------------------------------------------------

template <class G, class S, class T>
auto Mechanics<G, S, T>::gather_motion(Body& body, const Located& at, const Field& field, double dt) -> MotionSums {
  Columns& points = body.points;
  const double* mass = points(column::mass);
  double* loss = points.has(column::transfer_loss) ? points(column::transfer_loss) : nullptr;
  const double h = grid_.h();
  Writing<Vec> velocity(points, column::velocity), position(points, column::position);
  Writing<Mat> affine_part(points, column::affine, T::affine);
  return block_sum<MotionSums>(points.points(), [&](int p) {
    Vec v = Vec::Zero(), a = Vec::Zero();  // sum N v~, sum N (v~ - v)
    Mat c = Mat::Zero();
    double square = 0, torque = 0;
    stencil(at, p).for_nodes([&](std::size_t i, double n, const Vec&, const Vec& r, const Vec& affine) {
      const Vec& end = field.end[i];
      v += n * end;
      if constexpr (T::increments) {
        const Vec change = end - field.start[i];
        a += n * change;
        square += n * change.squaredNorm();
        torque += n * cross<dim>(r, change);
      } else {
        square += n * end.squaredNorm();
        if constexpr (T::affine) c += end * affine.transpose();
        if constexpr (!T::affine || !S::fixed_inertia) torque += n * cross<dim>(r, end);
      }
    });
    Vec v_new = v;
    double kept = v.squaredNorm();
    if constexpr (T::increments) {
      v_new = velocity[p] + a;  // [York 3.22]
      kept = a.squaredNorm();
    }
    const Vec step = dt * v;
    for (int d = 0; d < dim; ++d) {
      if (!(std::abs(step[d]) <= h)) {
        throw InadmissibleState("a point moved more than one cell in a step", body.name,
                                body.id[static_cast<std::size_t>(p)], column::velocity.name(), v[d]);
      }
    }
    velocity.set(p, v_new);
    position.set(p, position[p] + step);  // [York 3.21]
    if constexpr (T::affine) {
      // With the inertia of the new place: where that is another, so are the energy and the spin of the affine part.
      const Vec d2 = inertia(position[p]);
      for (int k = 0; k < dim; ++k) kept += d2[k] * c.col(k).squaredNorm();
      if constexpr (dim == 2 && !S::fixed_inertia) torque -= d2[0] * c(1, 0) - d2[1] * c(0, 1);
      affine_part.set(p, c);
    }
    MotionSums sums;
    sums.lost = 0.5 * mass[p] * (square - kept);  // [EC-APIC 5]
    // Never negative but by rounding, and a cold gas has nothing to pay that with. Only a changing inertia can give.
    if ((!T::affine || S::fixed_inertia) && sums.lost < 0) sums.lost = 0;
    if (loss) loss[p] += sums.lost;
    sums.torque = mass[p] * torque;
    sums.moved = mass[p] * dt * cross<dim>(v, v_new);
    return sums;
  });
}

template <class G, class S, class T>
void Mechanics<G, S, T>::move_points(double dt) {
  MotionSums sums;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    sums += gather_motion(scene_.bodies[b], located_[b], fields_[located_[b].field], dt);
  }
  for (const Field& field : fields_) {
    WallAction<dim> action = walls_.extension_impulse(field, field.end);
    if constexpr (T::increments) {
      const WallAction<dim> before = walls_.extension_impulse(field, field.start);
      action.linear -= before.linear;
      action.angular -= before.angular;
    }
    pending_.wall += action.linear;
    pending_.wall_angular += action.angular;
  }
  for (int d = 0; d < dim; ++d) {
    Account& account = ledger_.momentum[static_cast<std::size_t>(d)];
    account.book(Flow::walls, pending_.wall[d] + pending_.map_wall[d]);
    account.book(Flow::body_force, pending_.body[d]);
  }
  ledger_.angular_momentum.book(Flow::walls, pending_.wall_angular + pending_.map_wall_angular);
  ledger_.angular_momentum.book(Flow::body_force, pending_.body_angular);
  ledger_.angular_momentum.book(Flow::transfer, -sums.torque);
  ledger_.angular_momentum.book(Flow::integration, sums.moved);
  ledger_.energy.book(Flow::body_force, pending_.body_work);
  ledger_.energy.book(Flow::transfer, -pending_.map_loss - sums.lost);
  ledger_.energy.book(Flow::integration, -pending_.stress_power);
  ledger_.viscous += pending_.viscous;
  moved_ = true;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::return_transfer_loss() {
  for (Body& body : scene_.bodies) {
    if (!body.points.has(column::transfer_loss)) continue;
    const double* loss = body.points(column::transfer_loss);
    body.material->add_heat(body.points, loss);
    ledger_.energy.book(Flow::transfer, block_sum<double>(body.points.points(), [&](int p) { return loss[p]; }));
  }
}

// --- strain and stress ----------------------------------------------------------------------------------------------

template <class G, class S, class T>
void Mechanics<G, S, T>::find_strain_rates(NodalVelocity which) {
  if (which == NodalVelocity::current) which = current_;
  if (which == rate_of_) return;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Columns& points = scene_.bodies[b].points;
    const std::vector<Vec>& velocity = nodal(fields_[located_[b].field], which);
    Writing<Strain> rates(points, column::strain_rate);
    for (int p = 0; p < points.points(); ++p) {
      Mat gradient = Mat::Zero();
      stencil(located_[b], p).for_nodes([&](std::size_t i, double, const Vec& g, const Vec&, const Vec&) {
        gradient += velocity[i] * g.transpose();
      });
      rates.set(p, G::strain(gradient));  // [York 3.23]
    }
  }
  rate_of_ = which;
}

// Strain before the forces are known waits: its stress power is booked with the stress that the forces use.
template <class G, class S, class T>
void Mechanics<G, S, T>::strain_points(double dt, NodalVelocity velocity) {
  find_strain_rates(velocity);
  for (Body& body : scene_.bodies) {
    const double power = forces_mapped_ ? stress_power(body, dt) : 0.0;
    const double stored = body.material->advance(body.points, context(), dt);
    if (forces_mapped_) {
      ledger_.energy.book(Flow::integration, power);
      ledger_.energy.book(Flow::constitutive, stored - power);
    } else {
      pending_stored_ += stored;
    }
  }
  if (!forces_mapped_) pending_strain_dt_ += dt;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::settle_pending_strain() {
  if (pending_strain_dt_ == 0) return;
  double power = 0;
  for (const Body& body : scene_.bodies) power += stress_power(body, pending_strain_dt_);
  ledger_.energy.book(Flow::integration, power);
  ledger_.energy.book(Flow::constitutive, pending_stored_ - power);
  pending_strain_dt_ = pending_stored_ = 0;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::evaluate_stress(NodalVelocity velocity) {
  find_strain_rates(velocity);
  evaluate_densities();
  for (Body& body : scene_.bodies) body.material->evaluate_stress(body.points, context());
}

template <class G, class S, class T>
bool Mechanics<G, S, T>::reverse_cooling() {
  find_strain_rates(NodalVelocity::midpoint);
  bool changed = false;
  for (Body& body : scene_.bodies) changed |= body.material->reverse_cooling(body.points, context());
  return changed;
}

// --- density --------------------------------------------------------------------------------------------------------

template <class G, class S, class T>
void Mechanics<G, S, T>::evaluate_densities() {
  if (scene_.density == DensityMethod::continuity) return;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    Body& body = scene_.bodies[b];
    if (!body.material->has_density()) continue;
    if (scene_.density == DensityMethod::grid) {
      grid_density(body, located_[b]);
    } else {
      cell_density<dim>(grid_, body.points, scene_.density == DensityMethod::quadratic);
    }
  }
}

// rho_p = sum_i N_ip M_i / |cell_i|, half cells at walls, from this body's mass where the points stand. [EC-APIC 2]
// The mass that the step mapped serves where it is the body's own and the points have not moved since.
template <class G, class S, class T>
void Mechanics<G, S, T>::grid_density(Body& body, const Located& at) {
  const bool mapped = !moved_ && alone_[at.field];
  if (!mapped && !own_mass_) own_mass_.emplace(OwnMass{Field(grid_), {}});
  Field& field = mapped ? fields_[at.field] : own_mass_->field;
  if (!mapped) map_own_mass(body);
  const Located& here = mapped ? at : own_mass_->at;
  field.for_touched(grid_, [&](std::size_t i) { field.density[i] = field.mass[i] * inverse_volume_[i]; });
  walls_.extend_even(field, field.density);
  double* density = body.points(column::density);
  for (int p = 0; p < body.points.points(); ++p) {
    double rho = 0;
    stencil(here, p).for_nodes(
        [&](std::size_t i, double n, const Vec&, const Vec&, const Vec&) { rho += n * field.density[i]; });
    density[p] = rho;
  }
}

template <class G, class S, class T>
void Mechanics<G, S, T>::map_own_mass(Body& body) {
  Field& field = own_mass_->field;
  Located& at = own_mass_->at;
  at.lowest.resize(static_cast<std::size_t>(body.points.points()));
  for (auto& local : at.local) local.resize(at.lowest.size());
  place(body, at);
  std::fill(field.touched.begin(), field.touched.end(), std::pair<int, int>{0, 0});
  touch(at, field);
  walls_.include_mirrors(field.touched);
  field.for_touched(grid_, [&](std::size_t i) { field.mass[i] = 0; });
  const double* mass = body.points(column::mass);
  for (int p = 0; p < body.points.points(); ++p) {
    stencil(at, p).for_nodes(
        [&](std::size_t i, double n, const Vec&, const Vec&, const Vec&) { field.mass[i] += n * mass[p]; });
  }
  walls_.fold_mass(field);
}

// --- the run's view -------------------------------------------------------------------------------------------------

template <class G, class S, class T>
void Mechanics<G, S, T>::initialise() {
  locate_points();
  map_mass_and_momentum();
  evaluate_densities();
  for (Body& body : scene_.bodies) body.material->evaluate_stress(body.points, context());
}

template <class G, class S, class T>
void Mechanics<G, S, T>::refresh_density() {
  initialise();
}

template <class G, class S, class T>
Totals Mechanics<G, S, T>::body_totals(const Body& body) const {
  struct Sums {
    double mass = 0, kinetic = 0, angular = 0, angular_scale = 0, speed = 0;
    Vec momentum = Vec::Zero();
    Sums& operator+=(const Sums& o) {
      mass += o.mass;
      kinetic += o.kinetic;
      angular += o.angular;
      angular_scale += o.angular_scale;
      speed += o.speed;
      momentum += o.momentum;
      return *this;
    }
    Sums operator+(const Sums& o) const { return Sums(*this) += o; }
  };
  const double* mass = body.points(column::mass);
  const Reading<Vec> velocity(body.points, column::velocity), position(body.points, column::position);
  const Reading<Mat> affine(body.points, column::affine, T::affine);
  const Sums sums = block_sum<Sums>(body.points.points(), [&](int p) {
    const double m = mass[p];
    const Vec v = velocity[p];
    double square = v.squaredNorm(), spin = 0;
    if constexpr (T::affine) {
      const Mat c = affine[p];
      const Vec d2 = inertia(position[p]);
      for (int k = 0; k < dim; ++k) square += d2[k] * c.col(k).squaredNorm();
      if constexpr (dim == 2) spin = d2[0] * c(1, 0) - d2[1] * c(0, 1);
    }
    Sums one;
    one.mass = m;
    one.kinetic = 0.5 * m * square;
    one.momentum = m * v;
    one.speed = m * v.norm();
    if constexpr (dim == 2) {
      const Vec x = position[p];
      one.angular = m * (cross<dim>(x, v) + spin);
      one.angular_scale = x.norm() * one.speed;
    }
    return one;
  });
  Totals totals;
  totals.mass = sums.mass;
  for (int d = 0; d < dim; ++d) {
    totals.momentum[static_cast<std::size_t>(d)] = sums.momentum[d];
    totals.momentum_scale[static_cast<std::size_t>(d)] = sums.speed;
  }
  totals.angular_momentum = sums.angular;
  totals.angular_scale = sums.angular_scale;
  totals.energy.kinetic = sums.kinetic;
  const double stored = body.material->stored_energy(body.points);
  if (body.material->store() == Store::internal) totals.energy.internal = stored;
  if (body.material->store() == Store::elastic) totals.energy.elastic = stored;
  return totals;
}

template <class G, class S, class T>
Totals Mechanics<G, S, T>::totals() const {
  Totals all;
  for (const Body& body : scene_.bodies) {
    const Totals one = body_totals(body);
    all.mass += one.mass;
    for (std::size_t d = 0; d < 2; ++d) {
      all.momentum[d] += one.momentum[d];
      all.momentum_scale[d] += one.momentum_scale[d];
    }
    all.angular_momentum += one.angular_momentum;
    all.angular_scale += one.angular_scale;
    all.energy.kinetic += one.energy.kinetic;
    all.energy.internal += one.energy.internal;
    all.energy.elastic += one.energy.elastic;
  }
  all.grid_mass = grid_mass_;
  return all;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::check() const {
  for (const Body& body : scene_.bodies) {
    const auto stop = [&](int p, const std::string& field, double value, const std::string& reason) {
      throw InadmissibleState(reason, body.name, body.id[static_cast<std::size_t>(p)], field, value);
    };
    for (int d = 0; d < dim; ++d) {
      const double *x = body.points(column::position, d), *v = body.points(column::velocity, d);
      const double low = grid_.line(Grid<dim>::ghosts, d) - on_side * grid_.h();
      const double high = grid_.line(grid_.cells(d) + Grid<dim>::ghosts, d) + on_side * grid_.h();
      for (int p = 0; p < body.points.points(); ++p) {
        if (!std::isfinite(v[p])) stop(p, column::velocity.name(), v[p], "the velocity must be finite");
        if (x[p] >= low && x[p] <= high) continue;
        stop(p, column::position.name(), x[p],
             std::isfinite(x[p]) ? "a point left the grid" : "the position must be finite");
      }
    }
    const Material::Fault fault = body.material->first_fault(body.points);
    if (fault.point >= 0) stop(fault.point, fault.field, fault.value, fault.reason);
  }
}

template <class G, class S, class T>
double Mechanics<G, S, T>::step_limit() const {
  double limit = HUGE_VAL;
  for (const Body& body : scene_.bodies) {
    const StepBounds bounds = body.material->step_bounds(body.points, dim);
    if (bounds.fastest > 0) limit = std::min(limit, grid_.h() / bounds.fastest);
    if (bounds.diffusivity > 0) limit = std::min(limit, grid_.h() * grid_.h() / (2 * dim * bounds.diffusivity));
  }
  return limit;
}

// --- methods of lines -----------------------------------------------------------------------------------------------

template <class G, class S, class T>
template <class Visit>
void Mechanics<G, S, T>::for_state_columns(Visit&& visit) const {
  for (std::size_t b = 0; b < located_.size(); ++b) {
    visit(b, column::position);
    visit(b, column::velocity);
    for (const ColumnId* id : scene_.bodies[b].material->internal_variables(context())) visit(b, *id);
  }
}

template <class G, class S, class T>
State Mechanics<G, S, T>::state() const {
  State state;
  for_state_columns([&](std::size_t b, const ColumnId& id) {
    const auto values = std::as_const(scene_.bodies[b].points).values(id);
    state.values.insert(state.values.end(), values.begin(), values.end());
  });
  return state;
}

template <class G, class S, class T>
void Mechanics<G, S, T>::set_state(const State& state) {
  const Totals before = totals();
  auto next = state.values.begin();
  for_state_columns([&](std::size_t b, const ColumnId& id) {
    const auto values = scene_.bodies[b].points.values(id);
    std::copy_n(next, values.size(), values.begin());
    next += static_cast<std::ptrdiff_t>(values.size());
  });
  const Totals after = totals();
  for (std::size_t d = 0; d < 2; ++d) {
    ledger_.momentum[d].book(Flow::integration, after.momentum[d] - before.momentum[d]);
  }
  ledger_.angular_momentum.book(Flow::integration, after.angular_momentum - before.angular_momentum);
  ledger_.energy.book(Flow::integration, after.energy.total() - before.energy.total());
}

template <class G, class S, class T>
State Mechanics<G, S, T>::rate() {
  if constexpr (!T::increments) {
    throw std::logic_error("rates of change want the transfer flip: other transfers filter velocities once a step");
  }
  sorting_ = false;  // a State names points by their place
  locate_points();
  map_mass_and_momentum();
  evaluate_stress(NodalVelocity::start);
  map_forces();
  advance_momentum(0.0);
  for (Field& field : fields_) {
    field.for_touched(grid_, [&](std::size_t i) {
      field.end[i] = field.mass[i] > least_mass ? Vec(field.force[i] / field.mass[i]) : Vec(Vec::Zero());
    });
    walls_.extend(field, field.end);
  }
  find_strain_rates(NodalVelocity::start);
  State rate;
  for (std::size_t b = 0; b < located_.size(); ++b) {
    const Body& body = scene_.bodies[b];
    const Field& field = fields_[located_[b].field];
    const auto n = static_cast<std::size_t>(body.points.points());
    const std::size_t first = rate.values.size();
    rate.values.resize(first + 2 * dim * n);
    for (std::size_t p = 0; p < n; ++p) {
      Vec v = Vec::Zero(), a = Vec::Zero();
      stencil(located_[b], static_cast<int>(p))
          .for_nodes([&](std::size_t i, double w, const Vec&, const Vec&, const Vec&) {
            v += w * field.start[i];
            a += w * field.end[i];
          });
      for (std::size_t d = 0; d < dim; ++d) {
        rate.values[first + d * n + p] = v[static_cast<int>(d)];
        rate.values[first + (dim + d) * n + p] = a[static_cast<int>(d)];
      }
    }
    const std::vector<double> internal = body.material->rates(body.points, context());
    rate.values.insert(rate.values.end(), internal.begin(), internal.end());
  }
  return rate;
}

}  // namespace plumbline
