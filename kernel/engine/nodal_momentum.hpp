// The momentum equation on the nodes, with walls, pistons, contact, sharpening and body forces.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "kernel/contact/contact.hpp"
#include "kernel/engine/discretisation.hpp"
#include "kernel/engine/step_record.hpp"
#include "kernel/heat_exchange.hpp"
#include "kernel/pistons.hpp"

namespace plumbline {

template <class Geometry>
class NodalMomentum {
 public:
  using Space = Discretisation<Geometry>;
  static constexpr int dim = Geometry::dim;
  using Vec = typename Space::Vec;
  using Field = typename Space::Field;

  // field_of_body: index of its field for each body of the scene, which must outlive this.
  NodalMomentum(const Space& space, const Scene& scene, std::vector<std::size_t> field_of_body)
      : space_(space),
        scene_(scene),
        field_of_body_(std::move(field_of_body)),
        pistons_(scene),
        contact_(make_contact<dim>(scene.contact, space.grid, space.shape.support)),
        friction_(space.grid, scene.friction) {
    check_friction(scene);
    for (int d = 0; d < dim; ++d) gravity_[d] = scene.gravity[static_cast<std::size_t>(d)];
    loaded_ = !gravity_.isZero(0);
    for (const Body& body : scene.bodies) loaded_ = loaded_ || body.load;
  }

  bool contact_changes_start() const { return contact_ && contact_->changes_start(); }
  // Pistons stand where they do `time` s after the start.
  void set_time(double time) { pistons_.set_time(time); }
  void pass_time(double dt) { pistons_.advance(dt); }

  void clear_map(Field& field) const {
    for_touched(field, [&](std::size_t i) {
      field.mass[i] = 0;
      field.momentum[i].setZero();
    });
  }

  // Velocities of the start from the momenta that all bodies of a field have mapped; returns the mass on its nodes.
  template <int rotations>
  double start(Field& field, StepRecord<dim, rotations>& record) const {
    double mass = 0;
    field.for_touched(space_.grid, [&](std::size_t i) { mass += field.unfolded.mass[i] = field.mass[i]; });
    if (space_.filters_at_rate(scene_)) {
      std::vector<Vec>& mapped = field.held(field.unfolded.momentum);
      for_touched(field, [&](std::size_t i) { mapped[i] = field.momentum[i]; });
    }
    space_.walls.fold_mass(field);
    WallAction<dim> action = space_.walls.fold(field, field.momentum);
    space_.divide_by_mass(field, field.momentum, field.start);
    record.map_wall_work += drive(field, field.start, action, 0);
    const double taken = 1 - space_.transfer.keep;  // of the velocities that the walls have changed
    record.map_wall.linear += taken * action.linear;
    record.map_wall.angular += taken * action.angular;
    space_.limit_sharpening(field, field.start);
    return mass;
  }

  // Velocities from momenta that were mapped anew. [York 3.24]
  void start_again(std::vector<Field>& fields) const {
    for (Field& field : fields) {
      space_.walls.fold(field, field.momentum);
      space_.divide_by_mass(field, field.momentum, field.held(field.remapped));
    }
    if (contact_) contact_->apply_to_remapped(fields);
    for (Field& field : fields) {
      space_.walls.extend(field, field.remapped);
      WallAction<dim> not_kept;
      drive(field, field.remapped, not_kept, 0);
    }
  }

  // v~_i = v_i + dt f_i / M_i. decide: choose the nodes that are in contact; otherwise those of the last call are again.
  AdvanceRecord<dim> advance(std::vector<Field>& fields, const MappedForces<dim>& forces, double dt, bool decide) {
    AdvanceRecord<dim> record;
    record.dt = dt;
    record.turn = dt * forces.turn;
    for (Field& field : fields) {
      add_body_force(field, dt, record);
      if (!field.gas.pressure.empty()) {
        space_.walls.fold_even(field, field.gas.pressure);
        record_walls(space_.pressure.add_forces(field, space_.inverse_volumes, space_.threads), dt, record);
      }
      record_walls(space_.walls.fold(field, field.force), dt, record);
      advance_alone(field, dt, record);
    }
    if (contact_ || !friction_.none()) touch(fields, forces.pressed, dt, decide, record.contact);
    for (Field& field : fields) {
      space_.walls.extend(field, field.end);
      space_.walls.extend(field, field.midpoint);
      record.wall_work += drive(field, field.end, record.wall, dt);
      drive_midpoint(field, dt);
      if (!field.gas.exchange.empty()) solve_shares(field, dt);
      if (!loaded_) continue;
      const std::vector<Vec>& straining = space_.straining_velocity(field, field.midpoint);
      field.for_touched(space_.grid,
                        [&](std::size_t i) { record.body.work += dt * field.body_force[i].dot(straining[i]); });
    }
    record.wall.linear[0] += dt * forces.hoop;
    record.wall.linear += dt * forces.clamp;
    return record;
  }

  // f_i / M_i of the forces as they are, in field.end.
  void find_acceleration(Field& field) const { space_.divide_by_mass(field, field.force, field.end); }

 private:
  template <class Visit>
  void for_touched(Field& field, Visit&& visit) const {
    field.for_touched(space_.grid, visit, space_.threads);
  }

  static void record_walls(const WallAction<dim>& action, double dt, AdvanceRecord<dim>& record) {
    record.wall.linear += dt * action.linear;
    record.wall.angular += dt * action.angular;
  }

  // What pistons do to nodal velocities, of dt from now; returns their work, J.
  double drive(const Field& field, std::vector<Vec>& velocity, WallAction<dim>& action, double dt) const {
    if (pistons_.none()) return 0;
    const double work = pistons_.drive(space_.grid, field, velocity, action, dt);
    space_.walls.extend(field, velocity);
    return work;
  }
  void drive_midpoint(Field& field, double dt) const {
    if (pistons_.none()) return;
    pistons_.drive_midpoint(space_.grid, field, field.midpoint, dt);
    space_.walls.extend(field, field.midpoint);
  }

  // Body forces fold like all others: what a point puts on a ghost node pulls the mirror node the other way.
  void add_body_force(Field& field, double dt, AdvanceRecord<dim>& record) const {
    if (!loaded_) return;
    std::vector<Vec>& loads = field.held(field.body_force);
    field.for_touched(space_.grid, [&](std::size_t i) {
      const Vec f = loads[i] + field.unfolded.mass[i] * gravity_;  // [York 3.18]
      loads[i] = f;
      field.force[i] += f;
      record.body.linear += dt * f;
      record.body.angular += dt * cross<dim>(space_.grid.position(static_cast<int>(i)), f);
    });
  }

  // Without contact.
  void advance_alone(Field& field, double dt, AdvanceRecord<dim>& record) const {
    for_touched(field, [&](std::size_t i) {
      const double m = field.mass[i];
      field.end[i] = m > least_mass ? Vec(field.force[i] / m) : Vec(Vec::Zero());  // [York 3.19]
    });
    if (!space_.sharpening.none()) {
      const SharpeningAction<dim> added = space_.sharpening.apply_to_accelerations(field, field.end, field.midpoint,
                                                                                   space_.threads);  // [Sharpening 1]
      record.wall.linear += dt * added.walls.linear;
      record.wall.angular += dt * added.walls.angular;
      record.turn += dt * added.turn;
    }
    const std::vector<Vec>& acceleration = space_.sharpening.none() ? field.end : field.midpoint;
    for_touched(field, [&](std::size_t i) {
      const Vec dv = dt * acceleration[i];
      field.end[i] = field.start[i] + dv;  // [York 3.20]
      field.midpoint[i] = field.start[i] + 0.5 * dv;
    });
  }

  // Contact between velocity fields. Its work is what the nodes' kinetic energy changes by beyond the work of the other
  // forces, as points will take it: what they keep from the velocity each field had. [Blend 1]
  void touch(std::vector<Field>& fields, const std::vector<PressedPair<dim>>& pressed, double dt, bool decide,
             Exchange<dim>& record) {
    const double keep = space_.transfer.keep, take = 1 - keep;
    const typename Contact<dim>::Visit book = [&](const ContactChange<dim>& c) {
      const Vec impulse = c.mass * (c.end - c.start) - c.mass * (c.own_end - c.own_start);
      const Vec kick = c.end - c.start, gained = c.end - c.own_start, mean = 0.5 * (c.end + c.start);
      const double kept = kick.dot(c.own_start + 0.5 * kick), taken = gained.dot(0.5 * (c.end + c.own_start));
      record.work += c.mass * (keep * kept + take * taken) - c.mass * (c.own_end - c.own_start).dot(mean);
      const Vec given = keep * impulse + take * c.mass * (c.end - c.own_end);
      record.linear += given;
      record.angular += cross<dim>(space_.grid.position(c.node), given);
    };
    if (decide) friction_.find(pressed, field_of_body_, fields, dt);
    friction_.apply(fields, book);
    if (!contact_) return;
    if (decide) contact_->find(scene_, field_of_body_, fields);
    contact_->apply(fields, dt, decide, book);
    if (!contact_->changes_start()) return;
    for (Field& field : fields) space_.walls.extend(field, field.start);
  }

  // With means over the mass of gas: E_i = sum_p m_p e_p N_ip / M_i, D_i = sum_p m_p N_ip max(0, -div v) / M_i and
  // c_i = sum_p m_p c_p N_ip / M_i; alpha_i = min(1, kappa_i dt D_i) of heat [Exchange 1], and of velocities
  // alpha_i = min(1, dt (k_f c_i / h + b_f D_i)) [Filter 1]; 1 where pistons set a velocity, and where membranes share the
  // node: what their points keep of their own motion strains them, and nothing stops it.
  void solve_shares(Field& field, double dt) const {
    const bool filters = !field.gas.kept.empty();
    const FilterRate& rate = scene_.filter;
    for (std::vector<double>* sums : {&field.gas.heat, &field.gas.exchange, &field.gas.kept}) {
      if (!sums->empty()) space_.walls.fold_even(field, *sums);
    }
    const std::vector<double>& mass = field.mass_of_gas();
    for_touched(field, [&](std::size_t i) {
      const double share = mass[i] > least_mass ? 1 / mass[i] : 0.0;
      field.gas.heat[i] *= share;
      const double closing = field.gas.exchange[i] * share;
      field.gas.exchange[i] = scene_.heat_exchange * dt * closing;
      if (!filters) return;
      const double taken = dt * (rate.sound * field.gas.kept[i] * share / space_.grid.h() + rate.compression * closing);
      const bool gas_alone = share > 0 && mass[i] >= field.mass[i];
      field.gas.kept[i] = gas_alone ? 1 - std::min(1.0, taken) : 0.0;
    });
    for_touched_beside(space_.grid, field, space_.threads, [&](int i, const RowNeighbours<dim>& beside) {
      double& share = field.gas.exchange[static_cast<std::size_t>(i)];
      if (share != 0) share = std::min(1.0, share * exchange_share(beside, field.gas.heat, i));
    });
    if (filters) {
      pistons_.for_driven(space_.grid, field, [&](std::size_t i, const Piston&) { field.gas.kept[i] = 0; });
    }
    for (std::vector<double>* values : {&field.gas.heat, &field.gas.exchange, &field.gas.kept}) {
      if (!values->empty()) space_.walls.extend_even(field, *values);
    }
  }

  const Space& space_;
  const Scene& scene_;
  std::vector<std::size_t> field_of_body_;
  Pistons<dim> pistons_;
  std::unique_ptr<Contact<dim>> contact_;  // at nodes; null: none
  PairFriction<dim> friction_;             // where points press
  Vec gravity_;
  bool loaded_;  // whether any point feels a body force
};

}  // namespace plumbline
