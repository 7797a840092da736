// The table of largest stable steps of a bar: rows of points per cell and shapes, columns of steps and transfers; points
// regular, and as a rigid lattice at its worst place.
#pragma once

#include <vector>

#include "cases/catalog/stability/trial_case.hpp"

namespace plumbline {

// A trial for each column, full tier; names "table-" and the column's.
std::vector<Trial> table_trials();
// Four gates for each of them.
std::vector<CaseGate> table_gates();

}  // namespace plumbline
