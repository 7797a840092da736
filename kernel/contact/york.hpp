// York's contact-release. [York A.1]
#pragma once

#include "kernel/contact/contact.hpp"

namespace plumbline {

// Where bodies approach each other they move and strain in the common field of their centre of mass, and release each in
// their own:
//   9.7   contact if (v1 - v2) . n1 > 0                                   [York 9.7]
//   9.8   contact if (v1 - v_cm) . n1 > 0                                 [York 9.8]
//   9.9   contact unless (v1 - v_cm) . n1 <= 0 and (v2 - v_cm) . n2 <= 0  [York 9.9]
// with the velocities of the start of the step and the outward normals n_i ~ sum_c grad N_i(x_c) chi_c, chi_c = sum_p
// S_c(x_p) over the points of a body and their images behind walls, S quadratic about the cell centre c.  [York 9.10, 9.11]
// In common: a_i = (f1 + f2) / (M1 + M2). [York 9.1, 9.2] Under FLIP, York's transfer, point velocities are never made
// common, only what changes them. Bodies of which each touches another at a node have one velocity there.
enum class YorkCriterion { against_other, against_centre, both };

template <int dim>
class YorkContact final : public Contact<dim> {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Fields = typename Contact<dim>::Fields;
  YorkContact(const Grid<dim>& grid, YorkCriterion criterion) : grid_(grid), criterion_(criterion) {}

  void find(const Scene& scene, const std::vector<std::size_t>& field_of_body, const Fields& fields) override;
  void apply(Fields& fields, double dt, bool decide, const typename Contact<dim>::Visit& visit) override;
  void apply_to_remapped(Fields& fields) override;
  bool changes_start() const override { return true; }

 private:
  // Fields that move in common at a node, and their own velocities.
  struct Node {
    int node;
    std::vector<std::size_t> fields;
    std::vector<Vec> own;
  };
  std::vector<double> colour(const Scene& scene, const std::vector<std::size_t>& field_of_body,
                             std::size_t field) const;
  void mirror(std::vector<double>& colour) const;
  Vec outward_normal(const std::vector<double>& colour, int node) const;
  bool in_contact(const Vec& v1, const Vec& v2, const Vec& centre, const Vec& n1, const Vec& n2) const;

  void join(int node, std::size_t a, std::size_t b);

  Grid<dim> grid_;
  YorkCriterion criterion_;
  std::vector<Node> nodes_;
};

extern template class YorkContact<1>;
extern template class YorkContact<2>;
extern template class YorkContact<3>;

}  // namespace plumbline
