// The values of cases/regressions.json, as the build put them into the executable.
#pragma once

#include "cases/harness/judge/regressions.hpp"

namespace plumbline {

const Regressions& recorded_values();

}  // namespace plumbline
