// Bodies whose points hold the nodes about them at rest. [Holding 1]
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel/engine/layout.hpp"
#include "kernel/engine/step_record.hpp"
#include "kernel/held_points.hpp"

namespace plumbline {

template <class Geometry>
class Holding {
 public:
  static constexpr int dim = Geometry::dim;
  using Space = Discretisation<Geometry>;
  using Vec = typename Space::Vec;
  using Field = typename Space::Field;
  using Bodies = Layout<dim>;
  using Record = StepRecord<dim, Geometry::rotations>;

  // Throws std::invalid_argument for scenes whose parts do not work with held points.
  Holding(const Space& space, const Scene& scene) : space_(space) {
    for (const Body& body : scene.bodies) {
      if (!body.points.has(column::held)) continue;
      const auto refuse = [&](const std::string& why) {
        throw std::invalid_argument("body " + body.name + " holds the nodes about it: " + why);
      };
      if (space.transfer.keep > 0 || space.transfer.order > 0)
        refuse("points do not take the velocity of held nodes with the transfer " + scene.transfer);
      if (!scene.pistons.empty() || scene.contact != "none") refuse("that works without pistons and contact");
      for (const auto& walls : scene.grid.walls) {
        if (walls[0] != Wall::free || walls[1] != Wall::free) refuse("that works on grids whose walls are free");
      }
      const auto held_too = [&](const Body& other) {
        return &other != &body && other.field == body.field && other.points.has(column::held);
      };
      if (std::any_of(scene.bodies.begin(), scene.bodies.end(), held_too))
        refuse("no other body of the same field may");
    }
  }

  // The velocities of the start, once they are mapped.
  void hold_start(Bodies& at, Record& step) {
    for_held(at, [&](const Body& body, const Weights<dim>& places, Field& field) {
      if (!solve(body.points, places, field, field.start)) return;
      change(
          field, step.map_wall,
          [&](std::size_t i, const Vec& change) {
            field.start[i] += change;
            return field.start[i];
          },
          step.map_wall_work);
    });
  }
  // Those of the end and the middle, once they are advanced.
  void hold_advanced(Bodies& at, AdvanceRecord<dim>& record) {
    for_held(at, [&](const Body& body, const Weights<dim>& places, Field& field) {
      if (!solve(body.points, places, field, field.end)) return;
      change(
          field, record.wall,
          [&](std::size_t i, const Vec& change) {
            field.end[i] += change;
            field.midpoint[i] += 0.5 * change;
            return field.midpoint[i];
          },
          record.wall_work);
    });
  }
  // Those mapped anew, which points do not keep.
  void hold_remapped(Bodies& at) {
    for_held(at, [&](const Body& body, const Weights<dim>& places, Field& field) {
      if (!solve(body.points, places, field, field.remapped)) return;
      WallAction<dim> not_kept;
      double none = 0;
      change(
          field, not_kept, [&](std::size_t i, const Vec& change) { return field.remapped[i] += change; }, none);
    });
  }

 private:
  template <class Visit>
  void for_held(Bodies& at, Visit&& visit) const {
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      if (at.bodies[b].points.points() == 0 || !at.bodies[b].points.has(column::held)) continue;
      visit(at.bodies[b], at.weights[b], at.field(b));
    }
  }

  // moved(node, change of its velocity) changes it and returns with which velocity the impulse works.
  template <class Moved>
  void change(Field& field, WallAction<dim>& action, Moved&& moved, double& work) const {
    field.for_touched(space_.grid, [&](std::size_t i) {
      if (!(field.mass[i] > least_mass)) return;
      const Vec impulse = impulses_[i];
      work += impulse.dot(moved(i, Vec(impulse / field.mass[i])));
      action.linear += impulse;
      action.angular += cross<dim>(space_.grid.position(static_cast<int>(i)), impulse);
    });
  }

  // All components of all points one after another, with room for the last pack.
  using Values = std::vector<double>;
  Values values_of(const Columns& points) const {
    return Values(static_cast<std::size_t>(dim * points.points() + lanes));
  }
  static double dot(const Values& a, const Values& b, int points) {
    double sum = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(dim * points); ++k) sum += a[k] * b[k];
    return sum;
  }
  void interpolate(const Columns& points, const Weights<dim>& at, const std::vector<Vec>& nodes, Values& to) const {
    std::array<typename Space::Loops::Gather, dim> all;
    for (int d = 0; d < dim; ++d)
      all[static_cast<std::size_t>(d)] = {component(nodes, d), dim, to.data() + d * points.points()};
    space_.gather(points, at, all);
  }
  // impulses_i = sum_k N_ik lambda_k.
  void spread(const Columns& points, const Weights<dim>& at, const Field& field, const Values& lambda) {
    field.held(impulses_);
    field.for_touched(space_.grid, [&](std::size_t i) { impulses_[i].setZero(); });
    std::array<typename Space::Loops::Spread, dim> all;
    for (int d = 0; d < dim; ++d) {
      all[static_cast<std::size_t>(d)] = {lambda.data() + d * points.points(), nullptr, component(impulses_, d), dim};
    }
    space_.spread(points, at, all);
  }

  // The impulses that hold a nodal velocity, by conjugate gradients; false: it is held.
  bool solve(const Columns& points, const Weights<dim>& at, const Field& field, const std::vector<Vec>& velocity) {
    constexpr double enough = 1e-13, too_much = 1e-8;  // of the velocity at the points: of rounding, and of no solution
    const int n = points.points(), most = 100 + 10 * n;
    Values lambda = values_of(points), left = lambda, along = lambda, seen = lambda;
    interpolate(points, at, velocity, left);
    for (double& value : left) value = -value;
    along = left;
    const double first = dot(left, left, n);
    if (first == 0) return false;
    double square = first;
    for (int k = 0; k < most && square > enough * enough * first; ++k) {
      spread(points, at, field, along);
      space_.divide_by_mass(field, impulses_, field.held(changes_));
      interpolate(points, at, changes_, seen);
      const double step = square / dot(along, seen, n);
      for (std::size_t j = 0; j < lambda.size(); ++j) {
        lambda[j] += step * along[j];
        left[j] -= step * seen[j];
      }
      const double before = square;
      square = dot(left, left, n);
      for (std::size_t j = 0; j < along.size(); ++j) along[j] = left[j] + square / before * along[j];
    }
    if (!(square <= too_much * too_much * first)) {
      throw std::invalid_argument("held points: no impulses were found that hold the nodes, of the velocity " +
                                  std::to_string(std::sqrt(square / first)) + " is left");
    }
    spread(points, at, field, lambda);
    return true;
  }

  const Space& space_;
  std::vector<Vec> impulses_, changes_;  // of nodes
};

}  // namespace plumbline
