// Points for a cylinder or sphere of gas at rest whose state depends on the radius.
#pragma once

#include "cases/catalog/gas/radial.hpp"

namespace plumbline {

struct GasBall {
  RadialGeometry geometry;
  double radius = 0.38;                                  // m
  std::function<reference::GasState(double r)> initial;  // density > 0 for r < radius; at rest
  bool uniform = true;                                   // of one density
  std::function<double(double r)> spacing = {};          // of points, m, > 0 for r > 0; overrides the rule's layout
};

// The body; `ppc` points a cell along each direction.
//   equal volume, or one density   a square lattice; of a lattice cell across the edge only the part inside, and
//                                  less than a quarter goes to the next cell inwards. So all points have one volume
//                                  but those at the edge.
//   equal mass                     concentric shells, each cut into sectors about as wide as it is thick, points spread
//                                  so that each has the mass of one at the centre; where that would leave less than
//                                  twice `least` a cell along a direction, and than `ppc`, that many, and lighter
//                                  ones: with half of them the edge of a gas in vacuum is nearly twice as far off.
//   `spacing` given                the same shells with this distance of points, whatever masses come out
// In a slice of rings: intervals along the radius as fill_gas() has them. Rings are per radian: with equal spacing
// their masses go with the distance from the axis, in all layouts.
// A point stands at the centre of mass of its part and has its mass and internal energy; so sums over the points are
// the integrals over the gas.
Body fill_ball(std::shared_ptr<const IdealGas> gas, const GasBall& ball, const PointRule& rule, const GridSpec& grid);

}  // namespace plumbline
