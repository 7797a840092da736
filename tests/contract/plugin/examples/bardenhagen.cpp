// A contact law outside the repository. Where two bodies share a node and approach, they exchange normal momentum, as in a perfectly
// inelastic impact: J = (v_a - v_b) . n M_a M_b / (M_a + M_b), v_a <- v_a - J n / M_a, v_b <- v_b + J n / M_b, with the velocities
// of the end of the step and the normal n ~ grad M_b - grad M_a. They slide freely and part freely.
#include <utility>
#include <vector>

#include "kernel/contact/contact.hpp"
#include "kernel/contact/shared_nodes.hpp"
#include "kernel/register_part.hpp"

namespace {

using namespace plumbline;

template <int dim>
class Bardenhagen final : public Contact<dim> {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Fields = typename Contact<dim>::Fields;
  explicit Bardenhagen(const Grid<dim>& grid) : grid_(grid) {}

  void find(const Scene&, const std::vector<std::size_t>&, const Fields& fields) override {
    shared_.clear();
    for (std::size_t a = 0; a < fields.size(); ++a) {
      for (std::size_t b = a + 1; b < fields.size(); ++b) {
        for_shared_nodes(grid_, fields[a], fields[b], [&](int node) {
          const Vec apart = mass_gradient(fields[b], node) - mass_gradient(fields[a], node);
          const Vec normal = along_walls<dim>(grid_, node, apart).stableNormalized();
          if (!normal.isZero(0)) shared_.push_back({a, b, node, normal, false});
        });
      }
    }
  }

  void apply(Fields& fields, double, bool decide, const typename Contact<dim>::Visit& visit) override {
    for (Pair& at : shared_) {
      VelocityField<dim>&a = fields[at.a], &b = fields[at.b];
      const auto i = static_cast<std::size_t>(at.node);
      if (decide) at.touching = (a.end[i] - b.end[i]).dot(at.normal) > 0;
      if (!at.touching) continue;
      const Vec end_a = a.end[i], end_b = b.end[i];
      exchange(at, a.mass[i], b.mass[i], a.end[i], b.end[i]);
      for (const auto& [field, before] : {std::pair{&a, end_a}, std::pair{&b, end_b}}) {
        const Vec start = field->start[i];
        field->midpoint[i] = 0.5 * (start + field->end[i]);
        visit({at.node, field->mass[i], start, before, start, field->end[i]});
      }
    }
  }

  void apply_to_remapped(Fields& fields) override {
    for (const Pair& at : shared_) {
      const auto i = static_cast<std::size_t>(at.node);
      VelocityField<dim>&a = fields[at.a], &b = fields[at.b];
      if (at.touching) exchange(at, a.mass[i], b.mass[i], a.remapped[i], b.remapped[i]);
    }
  }

  bool changes_start() const override { return false; }

 private:
  struct Pair {
    std::size_t a, b;
    int node;
    Vec normal;  // from a to b
    bool touching;
  };

  static void exchange(const Pair& at, double mass_a, double mass_b, Vec& a, Vec& b) {
    const Vec impulse = (a - b).dot(at.normal) * mass_a * mass_b / (mass_a + mass_b) * at.normal;
    a -= impulse / mass_a;
    b += impulse / mass_b;
  }

  // By differences between neighbours, kg a cell; at the grid's edge there is none.
  Vec mass_gradient(const VelocityField<dim>& field, int node) const {
    Vec gradient = Vec::Zero();
    for (int d = 0; d < dim; ++d) {
      const int index = grid_.index(node, d), stride = grid_.stride(d);
      if (index == 0 || index == grid_.nodes(d) - 1) continue;
      gradient[d] = mass_at(field, node + stride) - mass_at(field, node - stride);
    }
    return gradient;
  }
  // Nodes that no point of the field reaches in this step hold what they held in an earlier one.
  double mass_at(const VelocityField<dim>& field, int node) const {
    const int row = node / grid_.row_length(), place = node % grid_.row_length();
    const auto [first, last] = field.touched[static_cast<std::size_t>(row)];
    return place >= first && place < last ? field.mass[static_cast<std::size_t>(node)] : 0.0;
  }

  Grid<dim> grid_;
  std::vector<Pair> shared_;
};

template <int dim>
std::unique_ptr<Contact<dim>> make(const Grid<dim>& grid, int) {
  return std::make_unique<Bardenhagen<dim>>(grid);
}

const RegisterPart entry(ContactEntry{{"bardenhagen", "inelastic exchange of normal momentum on shared nodes",
                                       "Bardenhagen, Brackbill, Sulsky 2000, doi 10.1016/S0045-7825(99)00338-2"},
                                      {make<1>, make<2>, make<3>}});

}  // namespace
