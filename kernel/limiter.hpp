// What of a flow on the nodes is linear along an axis, psi, and what depends on it. How fast it closes beyond what is linear in
// it, which a limited artificial viscosity acts on:
//   K_i = sum_d (1 - psi_d) max(0, -g_d),  g_d = (u_d(i+1) - u_d(i-1)) / 2h,
//   psi_d = max(0, min(1, (r+ + r-) / 2, 2 r+, 2 r-)),  r+- = g_d(i +- 1) / g_d(i), i +- 1 the neighbours along d,
// zero where the flow is linear (van Leer's limiter, 1977, doi 10.1016/0021-9991(77)90095-X). Behind a wall stand mirror
// images; where a neighbour has no mass nothing is known to be linear. [Limiter 1]
// And how much of the sharpening stays along d where a gas expands, between all of it and the share a:
//   t_d = 1 - (1 - a) max(0, 1 - 2 (1 - x) psi_d) min(1, 32 x) max(0, min(1, |r| - 1)) where g_d > 0, elsewhere 1,
//   x = |rho(i+1) - rho(i-1)| / (rho(i+1) + rho(i-1)),
//   r = min(1, 8 rho(i+1) / rho(i)) r+ + min(1, 8 rho(i-1) / rho(i)) r-,                                     [Limiter 2]
// g_d the mean of the slopes on either side by rho(j) / (rho(i) + rho(j)): the velocity of a node that carries next to nothing
// does not count. Sharpening overshoots at kinks of a velocity, and so heats gas ahead of an expansion and in its middle. Small
// waves, which change densities little, keep all of it to first order: they are sharpened as if there were no limit. At a kink
// slopes turn from none to that of the expansion, and r is 2 or more; a slope that stands out from those beside it is the
// noise of points that change cells, unless those are as steep the other way.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/neighbours.hpp"

namespace plumbline {

template <int dim>
class Limiter {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  explicit Limiter(const Grid<dim>& grid) : grid_(grid) {}

  // closing = K of the velocity u, on the touched nodes with mass, ghosts of walls excepted; slopes: scratch, of the nodes.
  void apply(const VelocityField<dim>& field, const std::vector<Vec>& u, std::vector<Vec>& slopes,
             std::vector<double>& closing, int threads) const {
    find_slopes(
        field, u, slopes, [](int, int) { return 1.0; }, threads);
    const Vec* const slope = slopes.data();
    double* const all = closing.data();
    for_sides(
        grid_, field, threads, [=](int i, int d, const Side& below, const Side& above) __attribute__((always_inline)) {
          const double closes = (1 - linear_share(slope, i, d, below, above)) * std::max(0.0, -slope[i][d]);
          const double so_far = all[i];
          all[i] = closes + (d == 0 ? 0.0 : so_far);
        });
  }

  // kept = t of the velocity u, a = least; inverse_volumes: of the nodes' cells, see PointLoops; on the same nodes.
  void find_kept(const VelocityField<dim>& field, const std::vector<double>& inverse_volumes, double least,
                 const std::vector<Vec>& u, std::vector<Vec>& slopes, std::vector<Vec>& kept, int threads) const {
    const double *const mass = field.mass_of_gas().data(), *const inverse_volume = inverse_volumes.data();
    const auto density = [=](int node) { return mass[node] * inverse_volume[node]; };
    const auto share = [=](int i, int j) {
      const double other = density(j);
      return ratio(other, density(i) + other);
    };
    find_slopes(field, u, slopes, share, threads);
    const Vec* const slope = slopes.data();
    Vec* const all = kept.data();
    const double limited = 1 - least;
    for_sides(
        grid_, field, threads, [=](int i, int d, const Side& below, const Side& above) __attribute__((always_inline)) {
          const double low = below.share * density(below.node), high = above.share * density(above.node);
          const double uneven = ratio(std::abs(high - low), low + high);
          const double bent = std::max(0.0, 1 - 2 * (1 - uneven) * linear_share(slope, i, d, below, above));
          const auto known = [=](double there) { return std::min(1.0, ratio(most_lighter * there, density(i))); };
          const double own = slope[i][d],
                       beside = std::abs(known(low) * slope[below.node][d] + known(high) * slope[above.node][d]);
          const double shared = own > 0 ? std::max(0.0, std::min(1.0, ratio(beside - own, own))) : 0.0;
          all[i][d] = 1 - limited * bent * shared * std::min(1.0, change_that_counts * uneven);
        });
  }

 private:
  static constexpr double change_that_counts = 32, most_lighter = 8;

  // g of each direction; from one side where the other has no neighbour. weight(i, j): of what the neighbour j says of the
  // slope at i, not negative.
  template <class Weight>
  void find_slopes(const VelocityField<dim>& field, const std::vector<Vec>& u, std::vector<Vec>& slopes,
                   Weight&& weight, int threads) const {
    const Vec* const value = u.data();
    Vec* const slope = slopes.data();
    const double h = grid_.h();
    for_sides(
        grid_, field, threads, [=](int i, int d, const Side& below, const Side& above) __attribute__((always_inline)) {
          const double low = below.share * weight(i, below.node), high = above.share * weight(i, above.node);
          const double sum = low * (value[i][d] - below.sign * value[below.node][d]) +
                             high * (above.sign * value[above.node][d] - value[i][d]);
          slope[i][d] = ratio(sum, (low + high) * h);
        });
  }

  // psi of direction d; of no slope: zero. Terms times own^2, so that one division does for all.
  static double linear_share(const Vec* slope, int i, int d, const Side& below, const Side& above) {
    const double own = slope[i][d], low = below.share * slope[below.node][d], high = above.share * slope[above.node][d];
    const double least = std::min(std::min(own * own, 2 * own * low), 2 * own * high);
    return ratio(std::max(0.0, std::min(least, 0.5 * own * (low + high))), own * own);
  }

  Grid<dim> grid_;
};

}  // namespace plumbline
