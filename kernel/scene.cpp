#include "kernel/scene.hpp"

#include <stdexcept>

namespace plumbline {

const std::vector<Choice>& densities() {
  static const std::vector<Choice> all{
      {"cell", "mass of the cell over its volume", "York 1997, (4.5)"},
      {"quadratic", "quadratic weights about the cell centre", "York 1997, (4.6)"},
      {"continuity", "continuity equation at the point", "York 1997, (4.7)"},
      {"grid", "nodal mass over nodal volume, interpolated", "reports/docs/theory/step.md"}};
  return all;
}

DensityMethod density_method(const std::string& name) {
  for (std::size_t k = 0; k < densities().size(); ++k) {
    if (densities()[k].name == name) return static_cast<DensityMethod>(k);
  }
  throw std::out_of_range("no density method " + name);
}

}  // namespace plumbline
