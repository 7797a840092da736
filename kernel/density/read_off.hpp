// Densities that two maps have smoothed, from points to nodes and back, sharpened before points read them off: twice
//   rho_i <- rho_i - sum_d (F_d(i + 1/2) - F_d(i - 1/2)),  F = s max(0, min(theta |d|, s d-, s d+, theta rho_least)),
// d the difference across the face, s its sign, d- and d+ those across the faces beside it: what a map smooths to leading
// order, limited so that no axis makes an extremum (Boris, Book 1973, doi 10.1016/0021-9991(73)90147-2). rho_least is the
// least of the four densities that the differences are of: within a kernel of a free edge the mapped densities are the
// kernel's, not the gas's, and theta <= 1 / (2 dim) of it leaves every node what it has. Behind a wall stand mirror images,
// beyond a body nothing. Forces of a gas do not see it: they take V_p p_p = (gamma - 1) m_p e_p. [Read-off 1]
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernel/neighbours.hpp"

namespace plumbline {

template <int dim>
class ReadOff {
 public:
  // theta: of the shape, see Sharpening, at most 1 / (2 dim); 0: densities stay as they are.
  ReadOff(const Grid<dim>& grid, double theta) : grid_(grid), theta_(theta) {}

  // Of the touched nodes, ghosts of walls excepted.
  void apply(const VelocityField<dim>& field, std::vector<double>& density, int threads) {
    if (theta_ == 0) return;
    below_.resize(density.size());
    above_.resize(density.size());
    for (int pass = 0; pass < 2; ++pass) {
      before_ = density;
      find_beside(field, threads);
      sharpen(field, density, threads);
    }
  }

 private:
  using Vec = Eigen::Matrix<double, dim, 1>;

  // The densities beside each node.
  void find_beside(const VelocityField<dim>& field, int threads) {
    const double* const before = before_.data();
    Vec *const low = below_.data(), *const high = above_.data();
    for_sides(
        grid_, field, threads, [=](int i, int d, const Side& below, const Side& above) __attribute__((always_inline)) {
          low[i][d] = below.share * before[below.node];
          high[i][d] = above.share * before[above.node];
        });
  }

  void sharpen(const VelocityField<dim>& field, std::vector<double>& density, int threads) const {
    const double *const mass = field.mass.data(), *const before = before_.data(), theta = theta_;
    const Vec *const low = below_.data(), *const high = above_.data();
    double* const after = density.data();
    for_sides(
        grid_, field, threads, [=](int i, int d, const Side& below, const Side& above) __attribute__((always_inline)) {
          // Beside an image stands what stands on the other side of its node.
          const double under = below.sign > 0 ? low[below.node][d] : high[below.node][d];
          const double over = above.sign > 0 ? high[above.node][d] : low[above.node][d];
          const double own = before[i], down = low[i][d], up = high[i][d];
          after[i] -= carries(mass[i]) * (flux(theta, up, own, down, below.share * under) +
                                          flux(theta, down, own, up, above.share * over));
        });
  }

  // F from a node to one beside it, between what is beyond either.
  static double flux(double theta, double before, double own, double other, double beyond) {
    const double change = other - own, sign = change < 0 ? -1.0 : 1.0;
    const double least = std::min(std::min(before, own), std::min(other, beyond));
    const double most = theta * std::min(std::abs(change), least);
    return sign * std::max(0.0, std::min(most, std::min(sign * (own - before), sign * (beyond - other))));
  }

  Grid<dim> grid_;
  double theta_;
  std::vector<double> before_;
  std::vector<Vec> below_, above_;  // the densities beside the nodes, before; zero: no node with mass
};

}  // namespace plumbline
