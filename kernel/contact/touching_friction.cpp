// Friction where points touch.
#include <algorithm>

#include "kernel/contact/shared_nodes.hpp"
#include "kernel/contact/touching.hpp"

namespace plumbline {
namespace {

// Sweeps over the pairs of a node, and the share of the largest impulse below which a change is rounding.
constexpr int most_sweeps = 200;
constexpr double settled_friction = 1e-14;

template <int dim>
Eigen::Matrix<double, dim, 1> limited(const Eigen::Matrix<double, dim, 1>& impulse, double limit) {
  const double size = impulse.norm();
  return size > limit ? Eigen::Matrix<double, dim, 1>(limit / size * impulse) : impulse;
}

}  // namespace

template <int dim>
void TouchingContact<dim>::limit_friction(const Pairs& pairs, const Eigen::VectorXd& push) const {
  for (std::size_t r = 0; r < pairs.size(); ++r) {
    pairs[r]->most_held = friction_ * std::max(0.0, push[static_cast<Eigen::Index>(r)]);
  }
}

// Between bodies that have been pushed apart. Of several pairs at a node each in turn, and normals again, until
// nothing changes: least kinetic energy of the nodes' motion beside the work of the friction that slips, a convex problem
// with one answer. [Touching 4]
template <int dim>
void TouchingContact<dim>::rub(Fields& fields, const Pairs& pairs, const Velocities& of) const {
  std::vector<Vec> given(pairs.size(), Vec::Zero());
  for (int sweep = 0; sweep < (pairs.size() == 1 ? 1 : most_sweeps); ++sweep) {
    double changed = 0, largest = 0;
    for (std::size_t r = 0; r < pairs.size(); ++r) {
      const Candidate& c = *pairs[r];
      const auto i = static_cast<std::size_t>(c.node);
      const double ma = fields[c.a].mass[i], mb = fields[c.b].mass[i];
      const Vec jump = (fields[c.a].*of)[i] - (fields[c.b].*of)[i];
      const Vec slip = along_walls<dim>(grid_, c.node, jump - jump.dot(c.normal) * c.normal);
      const Vec impulse = limited<dim>(given[r] + ma * mb / (ma + mb) * slip, c.most_held);
      exchange(fields, c, of, impulse - given[r]);
      changed = std::max(changed, (impulse - given[r]).norm());
      largest = std::max(largest, impulse.norm());
      given[r] = impulse;
    }
    if (pairs.size() > 1) push_apart(fields, pairs, of);
    if (changed <= settled_friction * largest) break;
  }
}

template void TouchingContact<1>::limit_friction(const Pairs&, const Eigen::VectorXd&) const;
template void TouchingContact<1>::rub(Fields&, const Pairs&, const Velocities&) const;
template void TouchingContact<2>::limit_friction(const Pairs&, const Eigen::VectorXd&) const;
template void TouchingContact<2>::rub(Fields&, const Pairs&, const Velocities&) const;
template void TouchingContact<3>::limit_friction(const Pairs&, const Eigen::VectorXd&) const;
template void TouchingContact<3>::rub(Fields&, const Pairs&, const Velocities&) const;

}  // namespace plumbline
