// Two bars end to end; units c = h = rho = 1.
#pragma once

#include "cases/harness/laboratory/patch.hpp"

namespace plumbline {

struct ContactPatch {
  static constexpr int cells = 8;           // of each bar
  static constexpr double pressure = 1e-2;  // minus the strain of bars that touch
  static constexpr double distance = 0.1;   // of bars that do not, in spacings of points
  int ppc = 2;
  double interface = 0.5;  // where they meet in their cell, [0, 1)
  bool touching = true;
  double approach = 0;  // velocity of each bar towards the other; then there is no pressure

  // Bodies "left" and "right"; contact and velocity fields are still to be chosen.
  Patch make() const;
};

}  // namespace plumbline
