// Points beyond a wall change places with their mirror images. [EC-APIC walls]
#pragma once

#include <cmath>

#include "kernel/engine/discretisation.hpp"
#include "kernel/rotations.hpp"

namespace plumbline {

template <class Geometry>
class Reflection {
 public:
  using Space = Discretisation<Geometry>;
  static constexpr int dim = Geometry::dim;

  explicit Reflection(const Space& space) : space_(space) {}

  // Of the points of a range; `sums` takes the momenta that the walls give.
  void apply(Columns& points, PointRange range, MotionSums& sums) const {
    const Grid<dim>& grid = space_.grid;
    for (int d = 0; d < dim; ++d) {
      const auto [lowest, highest] = extent(points(column::position, d), range);
      for (int side = 0; side < 2; ++side) {
        if (grid.wall(d, side) == Wall::free) continue;
        const double wall = grid.origin(d) + (side == 0 ? 0 : grid.cells(d) * grid.h());
        if (side == 0 ? lowest >= wall : highest <= wall) continue;
        const double sign = side == 0 ? 1 : -1, beyond = wall - sign * on_side * grid.h();
        const double* x = points(column::position, d);
        for_packs(range.first, range.last, [&](int p, int count) {
          if (none_of(sign * (load(x + p) - beyond) < 0.0 && first_lanes(count))) return;
          for (int k = p; k < p + count; ++k) {
            if (sign * (x[k] - beyond) < 0) reflect(points, k, d, wall, grid.wall(d, side) == Wall::no_slip, sums);
          }
        });
      }
    }
  }

 private:
  // Least and largest of x over the range; where any is not a number, all is in between.
  static std::pair<double, double> extent(const double* x, PointRange range) {
    Pack low = HUGE_VAL, high = -HUGE_VAL;
    for_packs(
        range.first, range.last, [&](int p, int count) __attribute__((always_inline)) {
          const Pack here = count < lanes ? choose(first_lanes(count), load(x + p), x[p]) : load(x + p);
          low = min(low, here);
          high = max(high, here);
        });
    return {hmin(low), hmax(high)};
  }

  void reflect(Columns& points, int p, int d, double wall, bool no_slip, MotionSums& sums) const {
    add_momenta(points, p, -1, sums);
    double& place = points(column::position, d)[p];
    place = 2 * wall - place;
    for (int k = 0; k < dim; ++k) {
      const double sign = no_slip || k == d ? -1 : 1;
      points(column::velocity, k)[p] *= sign;
      for (int e = 0; space_.transfer.affine && e < dim; ++e) {
        points(column::affine, k * dim + e)[p] *= e == d ? -sign : sign;
      }
    }
    add_momenta(points, p, 1, sums);
  }

  // Those of point p, `factor` times.
  void add_momenta(const Columns& points, int p, double factor, MotionSums& sums) const {
    Eigen::Matrix<double, dim, 1> x, v;
    const double m = points(column::mass)[p];
    for (int k = 0; k < dim; ++k) {
      x[k] = points(column::position, k)[p];
      v[k] = points(column::velocity, k)[p];
    }
    Spin<dim> turn = cross<dim>(x, v);
    for (int k = 0; space_.transfer.affine && k < rotation_count<dim>; ++k) {
      const int a = rotation_axis<dim>(k, 0), b = rotation_axis<dim>(k, 1);
      const auto inertia = [&](int e) { return space_.loops->inertia(points, e, p); };
      turn[k] += inertia(a) * points(column::affine, b * dim + a)[p] -
                 inertia(b) * points(column::affine, a * dim + b)[p];
    }
    for (int k = 0; k < dim; ++k) sums.reflected[static_cast<std::size_t>(k)] += factor * m * v[k];
    for (int k = 0; k < Geometry::rotations; ++k) {
      sums.reflected_turn[Space::about + static_cast<std::size_t>(k)] += factor * m * turn[k];
    }
  }

  const Space& space_;
};

}  // namespace plumbline
