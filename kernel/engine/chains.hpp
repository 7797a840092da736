// What points of a chain do beside moving with the grid. Between its nodes a grid sees neither all motions of the points
// among each other nor all strains that they carry, and no force stops what it does not see.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "kernel/engine/discretisation.hpp"
#include "kernel/rotations.hpp"

namespace plumbline {

template <class Geometry>
class Chains {
 public:
  using Space = Discretisation<Geometry>;
  static constexpr int dim = Geometry::dim;
  using Field = typename Space::Field;
  using Vec = typename Space::Vec;

  // theta of the relaxation, kappa of the smoothing; 0: none.
  Chains(const Space& space, double theta, double kappa) : space_(space), theta_(theta), kappa_(kappa) {}

  // Each step points of a chain go
  //   dx_p = theta tau (F_p / m_p - sum_i N_ip A_i),  A_i = sum_p F_p N_ip / sum_p m_p N_ip,  tau = 1 / w^2 of the fastest,
  // towards the rest of that part of their forces, which releases elastic energy: under m the map to the nodes and back is
  // symmetric with eigenvalues from 0 to 1. Centre of mass and momentum stay; points on walls stay on them. `sums` takes
  // the angular momentum of the shifts. [Coupling 2]
  void relax(Body& body, const Weights<dim>& at, MotionSums& sums) {
    if (!body.chain || !(theta_ > 0)) return;
    const double tau = theta_ * body.material->point_forces(body.points, force_);
    if (!(tau > 0)) return;
    const int n = body.points.points();
    force_.resize(static_cast<std::size_t>(dim * n + lanes));
    smooth_.resize(static_cast<std::size_t>(dim * n + lanes));
    Field& field = alone(at);
    std::vector<Vec>&force = field.held(field.force), &seen = field.held(field.end);  // sum_p F_p N_ip; A_i
    field.for_touched(space_.grid, [&](std::size_t i) { force[i].setZero(); });
    const double* mass = body.points(column::mass);
    std::array<typename Space::Loops::Spread, 1 + dim> to_nodes{{{mass, nullptr, field.mass.data(), 1}}};
    std::array<typename Space::Loops::Gather, dim> to_points;
    for (int d = 0; d < dim; ++d) {
      const auto k = static_cast<std::size_t>(d);
      to_nodes[1 + k] = {force_.data() + d * n, nullptr, component(force, d), dim};
      to_points[k] = {component(seen, d), dim, smooth_.data() + d * n};
    }
    space_.spread(body.points, at, to_nodes);
    space_.walls.fold_mass(field);
    space_.walls.fold(field, force);
    space_.divide_by_mass(field, force, seen);
    space_.gather(body.points, at, to_points);
    for (int p = 0; p < n; ++p) {
      double step[dim];
      for (int d = 0; d < dim; ++d) {
        const auto k = static_cast<std::size_t>(d * n + p);
        step[d] = tau * (force_[k] / mass[p] - smooth_[k]);
      }
      shift(body.points, p, step, sums);
    }
  }

  // Strains that points carry go
  //   eps_p += min(1, kappa dt c / h) (sum_i N_ip eps_i - eps_p),  eps_i = sum_p m_p eps_p N_ip / sum_p m_p N_ip.
  // Returns the energy that this stores, J. [Coupling 3]
  double smooth_strain(Body& body, const Weights<dim>& at, double dt) {
    if (!body.chain || !(kappa_ > 0) || body.material->measure() == StressMeasure::point_force) return 0;
    Field& field = alone(at);
    std::vector<double>& seen = field.held(field.gas.heat);  // sum_p m_p eps_p N_ip, then eps_i
    field.for_touched(space_.grid, [&](std::size_t i) { seen[i] = 0; });
    const double *mass = body.points(column::mass), *strain = body.points(column::strain);
    const typename Space::Loops::Spread to_nodes[] = {{mass, nullptr, field.mass.data(), 1},
                                                      {strain, mass, seen.data(), 1}};
    space_.spread(body.points, at, to_nodes);
    space_.walls.fold_mass(field);
    space_.divide_sums(field, field.mass, seen);
    const StepBounds bounds = body.material->step_bounds(body.points, all_points(body.points), dim);
    const double share = std::min(1.0, kappa_ * dt * bounds.fastest / space_.grid.h());
    smooth_.assign(static_cast<std::size_t>(body.points.points() + lanes), 0.0);
    const typename Space::Loops::Gather to_points[] = {{seen.data(), 1, smooth_.data()}};
    space_.gather(body.points, at, to_points);
    for (int p = 0; p < body.points.points(); ++p) {
      double& next = smooth_[static_cast<std::size_t>(p)];
      next = strain[p] + share * (next - strain[p]);  // [Coupling 3]
    }
    return body.material->set_strain(body.points, smooth_);
  }

 private:
  // Nodal arrays of one body alone, its nodes touched.
  Field& alone(const Weights<dim>& at) {
    if (!field_) field_.emplace(space_.grid, Field::Holding::mass);
    space_.touch_alone(at, *field_);
    return *field_;
  }

  // Moves point p by what of `step` the walls that it stands on allow.
  void shift(Columns& points, int p, double (&step)[dim], MotionSums& sums) const {
    const Grid<dim>& grid = space_.grid;
    for (int d = 0; d < dim; ++d) {
      const double cells = grid.logical(points(column::position, d)[p], d);
      for (int side = 0; side < 2; ++side) {
        if (grid.wall(d, side) == Wall::free || std::abs(cells - side * grid.cells(d)) > on_side) continue;
        for (int e = 0; e < dim; ++e) {
          if (e == d || grid.wall(d, side) == Wall::no_slip) step[e] = 0;
        }
      }
    }
    const auto velocity = [&](int d) { return points(column::velocity, d)[p]; };
    for (int d = 0; d < dim; ++d) points(column::position, d)[p] += step[d];  // [Coupling 2]
    for (int k = 0; k < Geometry::rotations; ++k) {
      const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
      sums.moved[Space::about + static_cast<std::size_t>(k)] += points(column::mass)[p] *
                                                                (step[a] * velocity(b) - step[b] * velocity(a));
    }
  }

  const Space& space_;
  double theta_, kappa_;
  std::optional<Field> field_;
  std::vector<double> force_, smooth_;  // component by component
};

}  // namespace plumbline
