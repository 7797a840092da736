// Points that stand still and hold the material about them.
#pragma once

#include "kernel/points/column_names.hpp"

namespace plumbline {

namespace column {
// A body with this column, of any values, holds the nodes of its field: the velocity that the grid has at each of its points is zero
// at the start, the middle and the end of a step, by the impulses that do so with the least change of the nodes' momenta, in the
// sense of their kinetic energy:
//   v_i += sum_k N_ik lambda_k / M_i,  sum_l (sum_i N_ik N_il / M_i) lambda_l = -sum_i N_ik v_i. [Holding 1]
// (Lagrange multipliers at points.) Points less than a cell apart hold more than nodes can do, and those with little mass hold
// nodes that nothing else weighs down. At most one body of a field; with free walls, without pistons and contact, and with
// transfers of which points keep nothing.
inline const ColumnId held{"held", "1"};
}  // namespace column
}  // namespace plumbline
