// Forces of contact between points on the nodes.
#pragma once

#include <array>

#include "kernel/contact/pair_potential.hpp"
#include "kernel/engine/layout.hpp"
#include "kernel/engine/step_record.hpp"

namespace plumbline {

template <class Geometry>
class PairForces {
 public:
  static constexpr int dim = Geometry::dim;
  static constexpr int rotations = Geometry::rotations;
  using Space = Discretisation<Geometry>;
  using Bodies = Layout<dim>;

  // Throws std::invalid_argument where bodies cannot meet so: check_pairs().
  PairForces(const Space& space, const Scene& scene)
      : space_(space),
        acts_(meets_by_pairs(scene)),
        rubs_(acts_ && scene.friction > 0) {
    check_pairs(scene);
  }

  void add_columns(Body& body) const {
    if (!acts_) return;
    body.points.add(column::contact_force, dim);
    body.points.add(column::contact_velocity, dim);
  }

  // Pairs and their forces, with the points where they were located.
  void find(Bodies& at) {
    if (!acts_) return;
    pairs_.find(at.bodies);
    pairs_.press(at.bodies, 0);
  }

  // The forces of where points stand, or in the middle of a way of twice `ahead`, s, with a nodal velocity. [Pairs 3]
  void press(Bodies& at, double ahead, NodalVelocity velocity) {
    if (pairs_.none()) return;
    if (ahead > 0) gather(at, velocity);
    pairs_.press(at.bodies, 2 * ahead);
  }

  // Adds the torque about where weights are taken, none if points stand there, and what presses where that rubs.
  void map(Bodies& at, MappedForces<dim>& forces) const {
    if (rubs_) forces.pressed = pairs_.pressed(at.bodies);
    for_involved(at, [&](Body& body, const Weights<dim>& places, auto& field) {
      std::array<typename Space::Loops::Spread, dim> spread;
      for (int d = 0; d < dim; ++d) {
        spread[static_cast<std::size_t>(d)] = {body.points(column::contact_force, d), nullptr,
                                               component(field.force, d), dim};
      }
      space_.spread(body.points, places, spread);
      const Places<dim> located = places.places(body.points, false);
      for (int k = 0; k < rotations; ++k) {
        const int d = rotation_axis<dim>(k, 0), e = rotation_axis<dim>(k, 1);
        const double *low = body.points(column::contact_force, d), *high = body.points(column::contact_force, e);
        for (int p = 0; p < body.points.points(); ++p)
          forces.turn[k] += located.x[d][p] * high[p] - located.x[e][p] * low[p];
      }
    });
  }

  // Of the forces as they are at a nodal velocity, W.
  double power(Bodies& at, NodalVelocity velocity) const {
    if (pairs_.none()) return 0;
    gather(at, velocity);
    double sum = 0;
    for_involved(at, [&](Body& body, const Weights<dim>&, auto&) {
      const auto force = body.points.values(column::contact_force), v = body.points.values(column::contact_velocity);
      for (std::size_t k = 0; k < force.size(); ++k) sum += force[k] * v[k];
    });
    return sum;
  }

 private:
  template <class Work>
  void for_involved(Bodies& at, Work&& work) const {
    if (pairs_.none()) return;
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      if (pairs_.of(b)) work(at.bodies[b], at.weights[b], at.field(b));
    }
  }

  void gather(Bodies& at, NodalVelocity velocity) const {
    for_involved(at, [&](Body& body, const Weights<dim>& places, auto& field) {
      const auto& nodes = at.velocity(field, velocity);
      std::array<typename Space::Loops::Gather, dim> all;
      for (int d = 0; d < dim; ++d) {
        all[static_cast<std::size_t>(d)] = {component(nodes, d), dim, body.points(column::contact_velocity, d)};
      }
      space_.gather(body.points, places, all);
    });
  }

  const Space& space_;
  bool acts_, rubs_;
  PairPotential<dim> pairs_;
};

}  // namespace plumbline
