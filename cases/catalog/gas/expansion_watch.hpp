// Gas that only expands: no point of it may ever be hotter than it was at the start.
#pragma once

#include <functional>
#include <string>

#include "cases/catalog/gas/gas_problem.hpp"

namespace plumbline {

// The edge of the gas at a time, and what the measure of it is called.
struct GasEdge {
  std::string name;
  std::function<reference::Bounded(double time)> at;
};

// Lets the flow's points be watched, and measured at the end: call it last, when `fill` is set. `entropy`: p rho^-gamma
// of the gas at t = 0, the same everywhere.
//
// energy_ratio: largest e_p(t)/e_p(0) of all points after all steps; a point that came by splitting has the e_p(0) of
//   the one it was part of.
// energy_rise: largest e_p(t) - e_p(0) of all points after all steps, over the largest e_p(0). Zero or less where
//   nothing was ever heated.
// entropy.L1: mass-weighted mean of |p rho^-gamma/entropy - 1|.
// The place of the outermost point, against the edge.
void watch_expansion(GasFlow& flow, double entropy, const GasEdge& edge);

// No point's internal energy above its initial value, at one level.
CaseGate no_heating_gate(const std::string& study, double level);

}  // namespace plumbline
