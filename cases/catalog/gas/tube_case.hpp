// A shock tube as a case: what differs between tubes is a table of physics.
#pragma once

#include <string>

#include "cases/catalog/gas/shock_tube.hpp"

namespace plumbline {

// What differs between tubes, beside what NAME.md says of each.
struct Tube {
  std::string name;
  ShockTube tube;
  double order = 0.8;  // that the fitted order of density.L1 must reach
  bool cold = false;   // a gas with next to no energy: what maps take from points must be returned
  std::vector<double> levels = {100, 200, 400, 800, 1600};  // of the full tier
  std::string order_reason =
      "shock and contact allow 1; 0.8, as of every shock tube here, leaves a fifth for coarse meshes";
};
Case tube_case(const Tube& about);

}  // namespace plumbline
