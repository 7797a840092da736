// Which Courant number is safe for an integrator, a shape and a transfer: the worst that was sampled.
#pragma once

#include <string>

#include "cases/laboratory/bar_patch.hpp"
#include "cases/laboratory/problem.hpp"

namespace plumbline {

struct SafeStep {
  Method method;
  int order = 2;  // of the transfers xpic and fmpm
  int ppc = 1;
  double regular = 0;                 // limit with points at the centres of their shares of a cell, h/c
  double limit = 0, place = 0.5;      // least over the places sampled in a bar without ends, and where
  double edge = 0, edge_depth = 0.5;  // least over the depths of the last point behind a free end
  double worst() const { return limit < edge ? limit : edge; }
};

// Of an elastic bar, positions frozen. 0: no step is stable. `finely`: more places and depths.
SafeStep safe_step_of_bar(const Method& method, int order, const std::map<std::string, double>& parameters, int ppc,
                          bool finely);

// What `cfl=auto` means for a run with these settings: `auto_share` of the least limit that the laboratory finds over the
// places of the points, of `bar` (its free ends, too) for solids and membranes, of `gas` for gases and coupled scenes,
// divided by sqrt(dim), which a point near a corner needs. Throws UsageError where no step is stable.
inline constexpr double auto_share = 0.9;
double safe_courant_number(const Settings& settings, Kind kind, int dim);

}  // namespace plumbline
