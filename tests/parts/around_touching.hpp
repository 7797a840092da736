// Contact where points touch, for wrong laws that differ from it in what they make of velocities.
#pragma once

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "kernel/contact/contact.hpp"
#include "kernel/register_part.hpp"
#include "tests/parts/wrong_source.hpp"

namespace plumbline::wrong {

// A derived law changes fields after the right one did, and tells of every node that differs from before.
template <int dim>
class AroundTouching : public Contact<dim> {
 public:
  using typename Contact<dim>::Vec, typename Contact<dim>::Fields, typename Contact<dim>::Visit;

  AroundTouching(const Grid<dim>& grid, int support) : right_(make_contact<dim>("touching", grid, support)) {}

  void find(const Scene& scene, const std::vector<std::size_t>& field_of_body, const Fields& fields) override {
    right_->find(scene, field_of_body, fields);
  }
  void apply(Fields& fields, double dt, bool decide, const Visit& visit) override {
    const Fields before = fields;
    right_->apply(fields, dt, decide, [](const ContactChange<dim>&) {});
    alter(before, fields);
    for (std::size_t i = 0; i < fields[0].mass.size(); ++i) {
      for (std::size_t f = 0; f < fields.size(); ++f) {
        if (fields[f].end[i] == before[f].end[i]) continue;
        fields[f].midpoint[i] = 0.5 * (fields[f].start[i] + fields[f].end[i]);
        if (tells()) {
          visit({static_cast<int>(i), fields[f].mass[i], before[f].start[i], before[f].end[i], fields[f].start[i],
                 fields[f].end[i]});
        }
      }
    }
  }
  void apply_to_remapped(Fields& fields) override { right_->apply_to_remapped(fields); }
  bool changes_start() const override { return false; }

 private:
  // The ends of `fields`, which were those of `before` without contact.
  virtual void alter(const Fields& before, Fields& fields) const = 0;
  virtual bool tells() const { return true; }

  std::unique_ptr<Contact<dim>> right_;
};

template <template <int> class Law, int dim>
std::unique_ptr<Contact<dim>> make_law(const Grid<dim>& grid, int support) {
  return std::make_unique<Law<dim>>(grid, support);
}

// Law<dim> is derived from AroundTouching<dim>.
template <template <int> class Law>
ContactEntry law(const std::string& name, const std::string& defect) {
  return {{name, defect, here}, {make_law<Law, 1>, make_law<Law, 2>, make_law<Law, 3>}};
}

}  // namespace plumbline::wrong
