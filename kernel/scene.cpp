#include "kernel/scene.hpp"

#include <stdexcept>

namespace plumbline {

const std::vector<Choice>& shapes() {
  static const std::vector<Choice> all{
      {"linear", "tent functions", "York 1997, A.3.1"},
      {"quadratic", "quadratic B-splines on the nodes", "York 1997, A.3.2; Steffen et al. 2008, doi 10.1002/nme.2360"},
      {"cubic", "cubic B-splines on the nodes", "Steffen et al. 2008, doi 10.1002/nme.2360"}};
  return all;
}

const std::vector<Choice>& transfers() {
  static const std::vector<Choice> all{
      {"pic", "points take the grid's velocity", "Harlow 1964"},
      {"flip", "points take the grid's velocity change",
       "York 1997, (3.22); Brackbill, Ruppel 1986, doi 10.1016/0021-9991(86)90211-1"},
      {"apic", "points take the grid's velocity and its affine part", "Jiang et al. 2015, doi 10.1145/2766996"}};
  return all;
}

const std::vector<Choice>& densities() {
  static const std::vector<Choice> all{{"cell", "mass of the cell over its volume", "York 1997, (4.5)"},
                                       {"quadratic", "quadratic weights about the cell centre", "York 1997, (4.6)"},
                                       {"continuity", "continuity equation at the point", "York 1997, (4.7)"},
                                       {"grid", "nodal mass over nodal volume, interpolated", "kernel/README.md"}};
  return all;
}

DensityMethod density_method(const std::string& name) {
  for (std::size_t k = 0; k < densities().size(); ++k) {
    if (densities()[k].name == name) return static_cast<DensityMethod>(k);
  }
  throw std::out_of_range("no density method " + name);
}

}  // namespace plumbline
