// What a run will cost, from its scene and one step.
#pragma once

#include "cases/harness/description/case.hpp"

namespace plumbline {

struct RunEstimate {
  long points = 0;
  double cells = 0;    // of the grid
  double steps = 0;    // to the end, all as long as the first
  double bytes = 0;    // points and grid
  double seconds = 0;  // one slow core, the problem's preparation included
};

// Builds the scene, unprepared, and takes one step of it. Throws InadmissibleState if that step does.
RunEstimate estimate_run(const Case& entry, const Settings& settings);

}  // namespace plumbline
