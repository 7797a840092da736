// Gates on runs of which no study of the case says what they must give: choices of the user's own.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/gates.hpp"

namespace plumbline {

// Beside the generic gates: errors below three times what was to be computed, and a step that some method could take.
std::vector<CaseGate> undeclared_gates(const std::string& study);

}  // namespace plumbline
