// Gates on runs of which no study of the case says what they must give: choices of the user's own.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/judge/gates.hpp"

namespace plumbline {

// Beside the generic gates: errors below three times what was to be computed, a step that some method could take and, where a
// final state is judged that is far from the start, one that is nearer to it than the start.
std::vector<CaseGate> undeclared_gates(const StudyResult& study);

}  // namespace plumbline
