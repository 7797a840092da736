// Coulomb friction between two fields at a node.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "kernel/contact/shared_nodes.hpp"

namespace plumbline {

// Fields that press each other at a node.
template <int dim>
struct RubbingPair {
  int node;
  std::size_t a, b;                      // fields
  Eigen::Matrix<double, dim, 1> normal;  // from a to b
  double most_held;                      // of friction's impulse, kg m/s
};

template <int dim>
using Velocities = std::vector<Eigen::Matrix<double, dim, 1>> VelocityField<dim>::*;

// From the first body of a pair to the second.
template <int dim>
void exchange(std::vector<VelocityField<dim>>& fields, const RubbingPair<dim>& pair, Velocities<dim> of,
              const Eigen::Matrix<double, dim, 1>& impulse) {
  const auto i = static_cast<std::size_t>(pair.node);
  (fields[pair.a].*of)[i] -= impulse / fields[pair.a].mass[i];
  (fields[pair.b].*of)[i] += impulse / fields[pair.b].mass[i];
}

// Sweeps over the pairs of a node, and the share of the largest impulse below which a change is rounding.
inline constexpr int most_sweeps = 200;
inline constexpr double settled_friction = 1e-14;

// Ends the slip of the pairs of a node, or slows it by as much as each pair holds: R = min(|u| M_a M_b/(M_a + M_b), most_held) u/|u|
// of their slip u. Of several each in turn, with `between` after each sweep, until nothing changes: least kinetic energy of the nodes'
// motion beside the work of the friction that slips, a convex problem with one answer.
template <int dim, class Pair, class Between>
void rub(const Grid<dim>& grid, std::vector<VelocityField<dim>>& fields, std::span<Pair* const> pairs,
         Velocities<dim> of, Between&& between) {
  using Vec = Eigen::Matrix<double, dim, 1>;
  std::vector<Vec> given(pairs.size(), Vec::Zero());
  for (int sweep = 0; sweep < (pairs.size() == 1 ? 1 : most_sweeps); ++sweep) {
    double changed = 0, largest = 0;
    for (std::size_t r = 0; r < pairs.size(); ++r) {
      const RubbingPair<dim>& c = *pairs[r];
      const auto i = static_cast<std::size_t>(c.node);
      const double ma = fields[c.a].mass[i], mb = fields[c.b].mass[i];
      const Vec jump = (fields[c.a].*of)[i] - (fields[c.b].*of)[i];
      const Vec slip = along_walls<dim>(grid, c.node, jump - jump.dot(c.normal) * c.normal);
      Vec impulse = given[r] + ma * mb / (ma + mb) * slip;
      if (const double size = impulse.norm(); size > c.most_held) impulse *= c.most_held / size;
      exchange<dim>(fields, c, of, impulse - given[r]);
      changed = std::max(changed, (impulse - given[r]).norm());
      largest = std::max(largest, impulse.norm());
      given[r] = impulse;
    }
    if (pairs.size() > 1) between();
    if (changed <= settled_friction * largest) break;
  }
}

}  // namespace plumbline
