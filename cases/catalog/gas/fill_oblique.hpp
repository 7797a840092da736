// Points for a plane gas that is stratified along a line oblique to the grid.
#pragma once

#include "cases/catalog/gas/fill.hpp"
#include "reference/gas.hpp"

namespace plumbline {

// The gas along n = (cos angle, sin angle): x = centre + s n + t (-sin angle, cos angle).
struct ObliqueGas {
  double angle = 0;                                      // rad
  Position centre{};                                     // where s = t = 0, m
  std::vector<double> jumps;                             // of the state, in s
  std::function<reference::GasState(double s)> initial;  // velocity: along n
};

// The body: rows of points along n, intervals and lines across as fill_gas() has them for a box that is turned with the
// gas, of which all points inside the grid are taken. So between its ends a row is the run on a line, whatever the
// angle; at the grid's sides the gas is short of, or over, its mass by up to half a point a row.
Body fill_oblique(std::shared_ptr<const IdealGas> gas, const ObliqueGas& oblique, const PointRule& rule,
                  const GridSpec& grid);

}  // namespace plumbline
