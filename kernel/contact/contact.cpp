#include "kernel/contact/contact.hpp"

#include <stdexcept>
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

const RegisterPart entry(ContactEntry{{"none", "velocity fields pass through each other", "-"},
                                      {nothing<1>, nothing<2>, nothing<3>}});

}  // namespace

const std::vector<ContactEntry>& contacts() { return registered(); }

void add_part(ContactEntry entry) {
  if (!std::apply([](auto... make) { return (make && ...); }, entry.make))
    throw std::logic_error("contact " + entry.name + " cannot be made in one of the dimensions");
  add_named(registered(), std::move(entry), ContactEntry::kind);
}

}  // namespace plumbline
