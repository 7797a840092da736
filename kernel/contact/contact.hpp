// Contact between velocity fields, node by node, pair by pair of the fields that meet there.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "kernel/choice.hpp"
#include "kernel/scene.hpp"
#include "kernel/velocity_field.hpp"

namespace plumbline {

// What contact made of one field's velocities at one node.
template <int dim>
struct ContactChange {
  using Vec = Eigen::Matrix<double, dim, 1>;
  int node;
  double mass;
  Vec own_start, own_end;  // without contact
  Vec start, end;          // with it
};

template <int dim>
class Contact {
 public:
  using Vec = Eigen::Matrix<double, dim, 1>;
  using Fields = std::vector<VelocityField<dim>>;
  using Visit = std::function<void(const ContactChange<dim>&)>;
  virtual ~Contact() = default;

  // Where bodies could meet, with the points where they stand and masses and `start` of the fields mapped.
  // field_of_body: index into fields.
  virtual void find(const Scene& scene, const std::vector<std::size_t>& field_of_body, const Fields& fields) = 0;

  // Changes start, end and midpoint of the fields where bodies touch, after their momentum was advanced over dt. decide:
  // choose the nodes that are in contact; otherwise the same nodes are again. visit: each field at each of these nodes.
  virtual void apply(Fields& fields, double dt, bool decide, const Visit& visit) = 0;

  // The same nodes of velocities mapped anew. [York 3.24]
  virtual void apply_to_remapped(Fields& fields) = 0;

  // Whether apply() changes `start`.
  virtual bool changes_start() const = 0;
};

// Sets the end velocities of fields at a node from the midpoints that contact has changed, v~ = 2 vm - v, and tells of them.
template <int dim>
void visit_changed(std::vector<VelocityField<dim>>& fields, int node, const std::vector<std::size_t>& of,
                   const typename Contact<dim>::Visit& visit) {
  const auto i = static_cast<std::size_t>(node);
  for (const std::size_t f : of) {
    VelocityField<dim>& field = fields[f];
    const Eigen::Matrix<double, dim, 1> own = field.end[i];
    field.end[i] = 2 * field.midpoint[i] - field.start[i];
    visit({node, field.mass[i], field.start[i], own, field.start[i], field.end[i]});
  }
}

template <int dim>
using MakeContact = std::unique_ptr<Contact<dim>> (*)(const Grid<dim>&, int support);

// A law, which registers itself in its own source file.
struct ContactEntry : Choice {
  static constexpr const char* kind = "contact";
  std::tuple<MakeContact<1>, MakeContact<2>, MakeContact<3>> make;
  bool has_friction = false;  // whether it heeds Scene::friction
  bool by_pairs = false;      // of points, see PairPotential; nothing is made for the nodes
};

// In the order of their names; "none" makes nothing.
const std::vector<ContactEntry>& contacts();

// Null for "none". support: nodes per direction that a point reaches.
// Throws std::invalid_argument for an unknown name.
template <int dim>
std::unique_ptr<Contact<dim>> make_contact(const std::string& name, const Grid<dim>& grid, int support) {
  return std::get<MakeContact<dim>>(named(contacts(), name, ContactEntry::kind).make)(grid, support);
}

// Throws std::invalid_argument unless Scene::friction is a finite number >= 0, and 0 where the law has none.
void check_friction(const Scene& scene);

// Takes one in: RegisterPart.
void add_part(ContactEntry entry);

}  // namespace plumbline
