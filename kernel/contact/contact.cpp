#include "kernel/contact/contact.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "kernel/register_part.hpp"

namespace plumbline {
namespace {

std::vector<ContactEntry>& registered() {
  static std::vector<ContactEntry> all;
  return all;
}

template <int dim>
std::unique_ptr<Contact<dim>> nothing(const Grid<dim>&, int) {
  return nullptr;
}

const RegisterPart contact_entry(ContactEntry{{"none", "velocity fields pass through each other", "-"},
                                              {nothing<1>, nothing<2>, nothing<3>}});

}  // namespace

const std::vector<ContactEntry>& contacts() { return registered(); }

void check_friction(const Scene& scene) {
  const std::string given = "friction = " + std::to_string(scene.friction);
  if (!(scene.friction >= 0 && std::isfinite(scene.friction)))
    throw std::invalid_argument(given + ": a finite coefficient >= 0 is wanted");
  if (scene.friction > 0 && !named(contacts(), scene.contact, ContactEntry::kind).has_friction)
    throw std::invalid_argument(given + ": the contact law " + scene.contact + " has no friction, it must be 0");
}

void add_part(ContactEntry law) {
  if (!std::apply([](auto... make) { return (make && ...); }, law.make))
    throw std::logic_error("contact " + law.name + " cannot be made in one of the dimensions");
  add_named(registered(), std::move(law), ContactEntry::kind);
}

}  // namespace plumbline
