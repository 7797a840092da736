// The points of a gas beside those of FLIP computations that start from the same ones. [York section 4.2]
#pragma once

#include <vector>

#include "cases/catalog/gas/gas_problem.hpp"

namespace plumbline {

// FLIP of the gas of a box from the origin on, a symmetric quarter; call it last, when `fill` and `exact` are set. `step`: of
// both FLIP computations, s; `digit`: half of its last digit over itself: rankings hold for all steps within that. Points of the
// run are followed by their numbers; parts of a split point count together, at their centre of mass.
//
// from_implicit_flip, from_explicit_flip: root of the mass-weighted mean square of the distances to FLIP's points, m: the
//   largest of the step and both ends of its digit, and the least.
// scatter: of such a distance to the ray from the origin through the point's start, m; and that of explicit FLIP,
//   explicit_flip_scatter, the least of the three steps. A flow that is radial has none.
// implicit_flip_pressure, implicit_flip_energy: mass-weighted means of the differences to implicit FLIP, of pressure in the
//   cell where a point stands, of specific internal energy from point to point, over the means of the exact differences across
//   a cell at the run's points.
// implicit_flip_hottest: largest specific internal energy of its points over that at the start.
void compare_with_flip(GasFlow& flow, int cells, double h, double step, double digit);

}  // namespace plumbline
