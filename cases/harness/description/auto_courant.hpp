// What `cfl=auto` means. The laboratory works it out: scene_limit.cpp.
#pragma once

#include "cases/harness/description/settings.hpp"
#include "kernel/scene.hpp"

namespace plumbline {

// `auto_share` of the smallest limit over all problems of the laboratory that occur in the scene. Throws UsageError, which names
// the problem, where no step is stable.
inline constexpr double auto_share = 0.9;
double safe_courant_number(const Scene& scene, const Settings& run);

}  // namespace plumbline
