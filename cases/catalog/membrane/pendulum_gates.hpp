// What the swing of the pendulum is judged by.
#pragma once

#include <vector>

#include "cases/harness/judge/gates.hpp"

namespace plumbline {

std::vector<CaseGate> pendulum_gates();

}  // namespace plumbline
