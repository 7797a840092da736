// Contact where points really touch, by a normal velocity that both bodies share at the midpoint of the step.
#pragma once

#include "kernel/contact/contact.hpp"
#include "kernel/contact/friction.hpp"

namespace plumbline {

// Points p, q of two bodies touch if |x_p - x_q| < (l_p + l_q)/2, l the spacing of a body's points.          [Touching 1]
// A node that carries a touching point of each body is a candidate. Its normal, from the first body to the second, is
// the direction that separates the points around it best: separating_direction().                            [Touching 2]
// It is in contact if the midpoint velocities of the first force pass approach: s = (vm_1 - vm_2) . n > 0. Then, in both
// passes, vm_1 -= M_2/(M_1 + M_2) s n, vm_2 += M_1/(M_1 + M_2) s n, and v~ = 2 vm - v; where three bodies meet, all pairs
// at once.                                                                                                   [Touching 3]
// The impulses J n do no work, since vm . n is common; so with the step `midpoint` contact raises no energy.
// Friction, mu = Scene::friction: along u = vm_1 - vm_2, which has no part along n any more, the first body gives the second
// R = min(|u| M_1 M_2/(M_1 + M_2), mu J) u/|u|, in both passes with the push J >= 0 of the first: the slip ends, or it is
// slowed down by mu J. A step with such limits takes energy and never gives any, as without friction: each pass is an
// M-firmly non-expansive map of what came before it, whatever slips or sticks. The limit of each pass its own would not
// be, and does give energy. What is taken, twice R . u of what is left of u, is booked as work of contact.   [Touching 4]
template <int dim>
class TouchingContact final : public Contact<dim> {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Fields = typename Contact<dim>::Fields;
  // support: nodes per direction that a point reaches.
  TouchingContact(const Grid<dim>& grid, int support) : grid_(grid), support_(support) {}

  void find(const Scene& scene, const std::vector<std::size_t>& field_of_body, const Fields& fields) override;
  void apply(Fields& fields, double dt, bool decide, const typename Contact<dim>::Visit& visit) override;
  void apply_to_remapped(Fields& fields) override;
  bool changes_start() const override { return false; }

 private:
  struct Candidate : RubbingPair<dim> {
    bool active;
  };
  // A point near nodes that two fields share.
  struct Near {
    Vec x;
    double spacing;
    int lowest;  // node
    bool touches;
  };
  std::vector<Near> points_near(const Scene& scene, const std::vector<std::size_t>& field_of_body, std::size_t field,
                                const std::vector<char>& shared) const;
  void find_touching(std::vector<Near>& first, std::vector<Near>& second) const;
  void find_candidates(std::size_t a, std::size_t b, const std::vector<Near>& first, const std::vector<Near>& second);
  using Pairs = std::vector<Candidate*>;
  Eigen::VectorXd pushes(const Fields& fields, const Pairs& pairs, Velocities<dim> of) const;
  Eigen::VectorXd push_apart(Fields& fields, const Pairs& pairs, Velocities<dim> of) const;
  void limit_friction(const Pairs& pairs, const Eigen::VectorXd& push) const;
  void rub_each_other(Fields& fields, const Pairs& pairs, Velocities<dim> of) const;
  template <class Keep, class Work>
  void for_nodes(Keep&& keep, Work&& work);
  int lowest_node(const Vec& x) const;
  template <class Visit>
  void for_support(int lowest, Visit&& visit) const;

  Grid<dim> grid_;
  int support_;
  double friction_ = 0;                // of the scene
  std::vector<Candidate> candidates_;  // by node
};

extern template class TouchingContact<1>;
extern template class TouchingContact<2>;
extern template class TouchingContact<3>;

}  // namespace plumbline
