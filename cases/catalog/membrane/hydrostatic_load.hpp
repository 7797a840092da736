// The pressure of a liquid on one side of a chain of points.
#pragma once

#include "cases/harness/description/drag.hpp"

namespace plumbline {

// A Body::load. The liquid stands to the left of the chain, seen along it, and pushes with p(y) = base - weight y,
// normal to each segment. On a segment of the length l from a to b, n its right normal, p is linear:
//   F_a = (2 p_a + p_b)/6 l n,   F_b = (p_a + 2 p_b)/6 l n.
// base: Pa, pressure at y = 0; weight: N/m^3. The chain is open, in the plane, its points in order. Ends on a wall feel
// their own side alone: the mirror image pushes the rest.
Load hydrostatic_load(double base, double weight);

}  // namespace plumbline
