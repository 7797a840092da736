// What the parts of a scheme offer, and what others need of them. Each part says so where it is defined: shapes, transfers
// and materials by declaration, integrators by the stages they call. No part lists others by name.
#pragma once

#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace plumbline {

enum class Trait {
  unfiltered_velocities,  // of a transfer: points keep their velocities and add the grid's change of velocity
  returnable_loss,        // of a transfer: points take velocities that the grid has, so that what they lose is known
  smooth_gradients,       // of a shape: gradients are continuous across the sides of cells
  constant_inertia,       // of a shape: the inertia D_p of the affine transfer is the same wherever a point stands
  returned_loss,          // of an integrator: what the maps took from points is given back as heat
  forward_steps           // of an integrator: no stage goes back in time
};
using Traits = std::set<Trait>;

// "forward-steps", and what is missing where it is not offered, as the end of a sentence.
const std::string& name(Trait trait);
const std::string& absence(Trait trait);

// A trait that one part needs and no other offers.
struct Lack {
  Trait trait;
  std::string needed_by, not_offered_by;  // "integrator leapfrog", "shape linear"
  std::string text() const;               // one sentence, for people
};

// Parts that cannot work together, and why.
struct CannotWork : std::invalid_argument {
  explicit CannotWork(std::vector<Lack> all);
  std::vector<Lack> lacks;
};

}  // namespace plumbline
