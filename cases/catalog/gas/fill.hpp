// Points for a gas that is given by functions of position: by mass or by volume, in every geometry.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "cases/catalog/gas/intervals.hpp"
#include "kernel/grid_spec.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/points/body.hpp"

namespace plumbline {

using Position = std::array<double, 3>;  // m; entries beyond the dimension are zero

struct GasAt {
  double density = 0;   // kg/m^3, > 0
  Position velocity{};  // m/s
  double pressure = 0;  // Pa, >= 0
};

// A box of gas at t = 0, stratified: its density varies along `axis` alone; velocity and pressure may vary everywhere.
struct GasBox {
  Position low{}, high{};     // m; axisymmetric: entry 0 is the radius, >= 0
  int axis = 0;               // 0 ... dim - 1
  std::vector<double> jumps;  // places along the axis where the state jumps, ascending; it is smooth between them
  std::function<GasAt(const Position&)> state;
};

// How many points. Along the axis `ppc` a cell, and `lines` lines of points a cell in each other direction.
//   equal volume   `ppc` everywhere
//   equal mass     `ppc` in the densest gas, elsewhere in proportion to the density, but never below `least` a cell:
//                  a cell without points has no gas. Points of the thinner gas are then lighter, none is heavier.
// Where cells are rings, masses and volumes go with the radius beside: points of one mass would leave the axis empty.
struct PointRule {
  bool equal_mass = true;
  double ppc = 8;    // >= 1
  int lines = 1;     // >= 1
  double least = 1;  // > 0
};

// The intervals of the points along the axis, for cells of size h (m).
std::vector<Interval> point_intervals(const GasBox& box, const PointRule& rule, double h);

// The body. A point stands at the centre of mass of its interval along the axis, on its line; it has the mass, momentum
// and internal energy of that interval, and as volume the interval's. So sums over points are the integrals of a gas
// whose state depends on the axis alone, and the same intervals stand on every line: a plane or solid run of such a gas
// is the run on a line, line by line. Axisymmetric: per radian, all integrals with the weight r.
// Throws std::invalid_argument for an empty box or a radius below zero.
Body fill_gas(std::shared_ptr<const IdealGas> gas, const GasBox& box, const PointRule& rule, const GridSpec& grid);

}  // namespace plumbline
