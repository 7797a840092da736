// The stability limit of a scene as a Courant number: the smallest limit over what it contains.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/description/auto_courant.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {

// The limit of one problem that occurs in a scene.
struct SceneLimit {
  const StabilityProblem* problem = nullptr;
  Settings settings;
  std::vector<Override> choices = {};  // those that the scene makes
  double limit = 0;      // in the problem's unit; the end of its scan where all of that is stable; 0: no step is stable
  double courant = 0;    // the same as a Courant number of the run
  std::string why = {};  // where no step is stable
};

// Every problem that occurs in the scene, with the choices that it has in common with `run`; the smallest limit first.
// What was found once is kept as long as the process lives.
std::vector<SceneLimit> limits_in(const Scene& scene, const Settings& run);

}  // namespace plumbline
