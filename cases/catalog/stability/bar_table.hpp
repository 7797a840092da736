// The table of largest stable steps of a bar: rows of points per cell and shapes, columns of steps and transfers; points
// regular, and as a rigid lattice at its worst place.
#pragma once

#include <string>
#include <vector>

#include "cases/catalog/stability/trial_case.hpp"

namespace plumbline {

struct TableColumn {
  std::string name, integrator, transfer;
  int order = 2;  // of xpic and fmpm
};
const std::vector<TableColumn>& table_columns();

// One column: `predict` at the regular places and at 12 more, against reference/mpm_amplification.hpp at the same places and
// against the table that was made beforehand. Measures:
//   regular.departure      largest relative one from the reference, regular places
//   worst.departure        the same of the worst of the 12 places
//   table.departure        largest relative one of the reference from the older table, regular places
//   table.worst_departure  the same at the worst places of all, where the table has them
// Profile: a row each.
Findings table_column(const TableColumn& column);

// A trial for each column, full tier; names "table-" and the column's.
std::vector<Trial> table_trials();
// Four gates for each of them.
std::vector<CaseGate> table_gates();

}  // namespace plumbline
