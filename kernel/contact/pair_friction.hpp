// Coulomb friction where points of two bodies press each other.
#pragma once

#include "kernel/contact/contact.hpp"
#include "kernel/contact/friction.hpp"

namespace plumbline {

// Two points of two bodies that press each other.
template <int dim>
struct PressedPair {
  std::size_t a, b;                             // bodies
  Eigen::Matrix<double, dim, 1> middle, force;  // between the points, m; on the second, N
};

// Each pair presses the nodes around its middle that both bodies share, in proportion to their tents and to what mass they have
// between the bodies:
//   f_i = sum_c F_c t_i(x_c) m_i / sum_j t_j(x_c) m_j,  m_i = M_1 M_2/(M_1 + M_2)                       [Pairs 4]
// There friction, mu = Scene::friction, takes what it may over dt, of the midpoint velocities' u across n = f/|f|:
//   R = min(|u| m_i, mu |f_i| dt/2) u/|u|                                                               [Pairs 5]
// from the first body to the second, in both force passes with the forces of the first (see [Touching 4]). So nodes are slowed down
// alike, however little of a body they carry.
template <int dim>
class PairFriction {
 public:
  using Fields = typename Contact<dim>::Fields;
  PairFriction(const Grid<dim>& grid, double coefficient) : grid_(grid), coefficient_(coefficient) {}

  bool none() const { return coefficient_ == 0; }

  // Where bodies rub in this step, of pairs as pressed at its start.
  void find(const std::vector<PressedPair<dim>>& pressed, const std::vector<std::size_t>& field_of_body,
            const Fields& fields, double dt);
  // Changes end and midpoint of the fields there. visit: each field at each of these nodes.
  void apply(Fields& fields, const typename Contact<dim>::Visit& visit);

 private:
  using Vec = Eigen::Matrix<double, dim, 1>;
  Grid<dim> grid_;
  double coefficient_;
  std::vector<RubbingPair<dim>> rubbing_;  // by node
};

extern template class PairFriction<1>;
extern template class PairFriction<2>;
extern template class PairFriction<3>;

}  // namespace plumbline
