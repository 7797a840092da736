// Which Courant number is safe for an integrator, a shape and a transfer: the worst that was sampled.
#pragma once

#include <string>

#include "cases/harness/laboratory/bar_patch.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {

struct SafeStep {
  Method method;
  int order = 2;  // of the transfers xpic and fmpm
  int ppc = 1;
  double regular = 0;                 // limit with points at the centres of their shares of a cell, h/c
  double limit = 0, place = 0.5;      // least over the places sampled in an infinite (periodic) bar, and where
  double edge = 0, edge_depth = 0.5;  // least over the depths of the last point behind a free end
  double worst() const { return limit < edge ? limit : edge; }
};

// Of an elastic bar, positions frozen. 0: no step is stable. `finely`: more places and depths.
SafeStep safe_step_of_bar(const Method& method, int order, const std::map<std::string, double>& parameters, int ppc,
                          bool finely);

}  // namespace plumbline
