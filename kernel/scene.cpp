#include "kernel/scene.hpp"

#include <algorithm>
#include <stdexcept>

namespace plumbline {

const std::vector<Choice>& shapes() {
  static const std::vector<Choice> all{{"linear", "tent functions", "York 1997, A.3.1"},
                                       {"quadratic",
                                        "quadratic B-splines on the nodes",
                                        "York 1997, A.3.2; Steffen et al. 2008, doi 10.1002/nme.2360",
                                        {Trait::smooth_gradients, Trait::constant_inertia}},
                                       {"cubic",
                                        "cubic B-splines on the nodes",
                                        "Steffen et al. 2008, doi 10.1002/nme.2360",
                                        {Trait::smooth_gradients, Trait::constant_inertia}},
                                       {"gimp",
                                        "tents averaged over boxes that stay",
                                        "Bardenhagen, Kober 2004, doi 10.3970/cmes.2004.005.477",
                                        {Trait::smooth_gradients}},
                                       {"contiguous-gimp",
                                        "tents averaged over boxes that deform with the points",
                                        "Wallstedt, Guilkey 2008, doi 10.1016/j.jcp.2008.07.019",
                                        {Trait::smooth_gradients}}};
  return all;
}

const std::vector<Choice>& transfers() {
  static const std::vector<Choice> all{
      {"pic", "points take the grid's velocity", "Harlow 1964", {Trait::returnable_loss}, {Trait::forward_steps}},
      {"flip",
       "points take the grid's velocity change",
       "York 1997, (3.22); Brackbill, Ruppel 1986, doi 10.1016/0021-9991(86)90211-1",
       {Trait::unfiltered_velocities}},
      {"apic",
       "points take the grid's velocity and its affine part",
       "Jiang et al. 2015, doi 10.1145/2766996",
       {Trait::returnable_loss},
       {Trait::forward_steps}},
      {"xpic",
       "points take the grid's acceleration and lose only what m passes to the grid and back do not restore",
       "Hammerquist, Nairn 2017, doi 10.1016/j.cma.2017.01.035",
       {},
       {Trait::forward_steps}},
      {"fmpm",
       "points take the grid's velocity through m terms of the full mass matrix's inverse",
       "Nairn, Hammerquist 2021, doi 10.1016/j.cma.2021.113667",
       {},
       {Trait::forward_steps}}};
  return all;
}

const std::vector<Choice>& densities() {
  static const std::vector<Choice> all{{"cell", "mass of the cell over its volume", "York 1997, (4.5)"},
                                       {"quadratic", "quadratic weights about the cell centre", "York 1997, (4.6)"},
                                       {"continuity", "continuity equation at the point", "York 1997, (4.7)"},
                                       {"grid", "nodal mass over nodal volume, interpolated", "kernel/README.md"}};
  return all;
}

const std::vector<Choice>& contacts() {
  static const std::vector<Choice> all{
      {"none", "velocity fields pass through each other", "-"},
      {"york-9.7", "common motion where body 1 moves into body 2, along the normal of body 1", "York 1997, (9.7)"},
      {"york-9.8", "the same, seen from the centre of mass", "York 1997, (9.8)"},
      {"york-9.9", "the same, release only if both bodies agree", "York 1997, (9.9)"},
      {"touching", "normal impulses where points touch and approach", "kernel/README.md"}};
  return all;
}

bool shape_offers(const std::string& shape, Trait trait) {
  return std::any_of(shapes().begin(), shapes().end(),
                     [&](const Choice& c) { return c.name == shape && c.offers.count(trait) > 0; });
}

DensityMethod density_method(const std::string& name) {
  for (std::size_t k = 0; k < densities().size(); ++k) {
    if (densities()[k].name == name) return static_cast<DensityMethod>(k);
  }
  throw std::out_of_range("no density method " + name);
}

}  // namespace plumbline
