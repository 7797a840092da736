// The columns of domains with corners, see kernel/shapes/cpdi.hpp.
#pragma once

#include "kernel/points/column_names.hpp"

namespace plumbline::column {

inline const ColumnId half_edges{"half_edges", "m"};                    // r_k of the point's domain, one after another
inline const ColumnId half_edges_at_start{"half_edges_at_start", "m"};  // of the undeformed domain

}  // namespace plumbline::column
