#include "kernel/contact/contact.hpp"

#include <stdexcept>

#include "kernel/contact/touching.hpp"
#include "kernel/contact/york.hpp"

namespace plumbline {

template <int dim>
std::unique_ptr<Contact<dim>> make_contact(const std::string& name, const Grid<dim>& grid, int support) {
  if (name == "none") return nullptr;
  if (name == "york-9.7") return std::make_unique<YorkContact<dim>>(grid, YorkCriterion::against_other);
  if (name == "york-9.8") return std::make_unique<YorkContact<dim>>(grid, YorkCriterion::against_centre);
  if (name == "york-9.9") return std::make_unique<YorkContact<dim>>(grid, YorkCriterion::both);
  if (name == "touching") return std::make_unique<TouchingContact<dim>>(grid, support);
  throw std::invalid_argument("no contact " + name);
}

template std::unique_ptr<Contact<1>> make_contact(const std::string&, const Grid<1>&, int);
template std::unique_ptr<Contact<2>> make_contact(const std::string&, const Grid<2>&, int);
template std::unique_ptr<Contact<3>> make_contact(const std::string&, const Grid<3>&, int);

}  // namespace plumbline
