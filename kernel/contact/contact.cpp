#include "kernel/contact/contact.hpp"

#include <utility>

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

const RegisterContact entry{
    {{"none", "velocity fields pass through each other", "-"}, {nothing<1>, nothing<2>, nothing<3>}}};

}  // namespace

const std::vector<ContactEntry>& contacts() { return registered(); }

RegisterContact::RegisterContact(ContactEntry entry) { add_named(registered(), std::move(entry), "contact"); }

}  // namespace plumbline
