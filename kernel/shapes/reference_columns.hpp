// The columns of points whose weights are those of the start, see kernel/shapes/lagrangian.cpp.
#pragma once

#include "kernel/points/columns.hpp"

namespace plumbline {
namespace column {

inline const ColumnId position_at_start{"position_at_start", "m"};        // X_p
inline const ColumnId deformation_at_start{"deformation_at_start", "1"};  // F_0 of points that carry F, row by row
inline const ColumnId inverse_deformation{"inverse_deformation", "1"};    // F_0 F^-1 where the step began, row by row

}  // namespace column

// Where the weights of points are taken along d: at the places of the start where they carry these, else where they stand.
inline const double* place_of_weights(const Columns& points, int d) {
  return points(points.has(column::position_at_start) ? column::position_at_start : column::position, d);
}

}  // namespace plumbline
