// Measures of a flow that one strong shock parts in two: where it stands, what it leaves behind, and what the wall or
// axis that made it did to the first gas.
#pragma once

#include <string>
#include <vector>

#include "cases/catalog/gas/gas_problem.hpp"

namespace plumbline {

// What the exact solution says of the shock at the end; `distance` is from the wall, piston, axis or centre behind it,
// which stands at the coordinate `origin`.
struct ShockFront {
  double origin = 0;
  reference::Bounded distance;        // m
  double density_ahead = 0;           // just ahead of it, kg/m^3
  reference::Bounded density_behind;  // kg/m^3, of the plateau
  reference::Bounded energy_behind;   // J/kg, of the plateau
};

// The place, from outside, at which the density first passes halfway between the two sides. Means over shells of half a
// cell, a straight line between them: good to a small share of a cell. NaN where no shell passes it.
double shock_place(const std::vector<GasSample>& points, double h, double halfway);

// shock_position: distance of the shock from its origin, m.
// plateau_density: the density behind it that is furthest from the exact one, between half the shock's distance and
//   three quarters of it; away from the wall and from the shock's own width.
// wall_heating: largest share by which the internal energy between origin and half the shock's distance is too high.
std::vector<Measure> shock_measures(const std::vector<GasSample>& points, double h, const ShockFront& exact);

// Its gates at one level: within one cell, within 2 %; both.
CaseGate shock_position_gate(const std::string& study, double level, double cell);
CaseGate plateau_gate(const std::string& study, double level, double plateau);
std::vector<CaseGate> shock_gates(const std::string& study, double level, double cell, double plateau);

}  // namespace plumbline
