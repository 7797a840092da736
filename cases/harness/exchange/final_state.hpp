// Points of another program as a simulation of the case at its end, for the case's own measures.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cases/harness/exchange/exchange.hpp"
#include "cases/harness/run/judged_at_end.hpp"

namespace plumbline {

// Why a case cannot be judged by a final state alone; empty if it can.
std::string why_not_scored(const Case& entry, const Settings& settings);

// The points of a body as they are handed in, in the body's own columns; `points` of each.
struct HandedIn {
  int points = 0;
  Columns columns;
};

// The scene of the problem at `time` with these points in place of its own, body by body; the problem's settings name
// integrator and step. Nothing is worked out anew: what the columns hold is what measures see.
std::unique_ptr<Simulation> simulation_of(const Problem& problem, const Settings& settings,
                                          const std::vector<HandedIn>& bodies, double time);

// Measures of some of the start's points: names and units alone mean something.
std::vector<Measure> measures_to_be_judged(const Problem& problem, const Settings& settings);

}  // namespace plumbline
