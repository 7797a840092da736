// Densities that belong to cells: every point of a cell gets the cell's. [York 4.5, 4.6]
#pragma once

#include "kernel/grid.hpp"
#include "kernel/points/columns.hpp"

namespace plumbline {

// Sets the density column from where the points stand.
//   quadratic = false   rho_c = sum_p m_p / V_c over the points of the cell          [York 4.5]
//   quadratic = true    rho_c = sum_p m_p S2_c(x_p) / V_c, mirrored at walls          [York 4.6]
template <int dim>
void cell_density(const Grid<dim>& grid, Columns& points, bool quadratic);

extern template void cell_density<1>(const Grid<1>&, Columns&, bool);
extern template void cell_density<2>(const Grid<2>&, Columns&, bool);
extern template void cell_density<3>(const Grid<3>&, Columns&, bool);

}  // namespace plumbline
