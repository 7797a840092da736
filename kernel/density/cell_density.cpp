#include "kernel/density/cell_density.hpp"

#include <algorithm>

#include "kernel/shapes/quadratic.hpp"

namespace plumbline {
namespace {

// Cells with one layer beyond each side, as the "nodes" of quadratic shapes about cell centres.
template <int dim>
struct CellGrid {
  explicit CellGrid(const Grid<dim>& g) : grid(g) {
    stride[0] = 1;
    for (int d = 0; d < dim; ++d) {
      count[d] = grid.cells(d) + 2;
      stride[d + 1] = stride[d] * count[d];
    }
    mass.assign(static_cast<std::size_t>(stride[dim]), 0.0);
  }
  int index(int cell, int d) const { return cell / stride[d] % count[d]; }

  // Mass that quadratic weights put beyond a wall belongs to the mirror cell, the one inside the wall.
  void fold_walls() {
    for (int d = 0; d < dim; ++d) {
      for (int cell = 0; cell < stride[dim]; ++cell) {
        const int side = index(cell, d) == 0 ? 0 : 1;
        if (side == 1 && index(cell, d) != count[d] - 1) continue;
        if (grid.wall(d, side) == Wall::free) continue;
        mass[static_cast<std::size_t>(cell + (side == 0 ? stride[d] : -stride[d]))] +=
            mass[static_cast<std::size_t>(cell)];
      }
    }
  }

  // |cell|, m^dim; axisymmetric per radian, m^3.
  double volume(int cell) const {
    double v = 1;
    for (int d = 0; d < dim; ++d) v *= grid.h();
    return grid.axisymmetric() ? v * (grid.origin(0) + (index(cell, 0) - 0.5) * grid.h()) : v;
  }

  const Grid<dim>& grid;
  int count[dim], stride[dim + 1];
  std::vector<double> mass;
};

template <int dim>
int own_cell(const CellGrid<dim>& cells, const double (&x)[dim]) {
  int cell = 0;
  for (int d = 0; d < dim; ++d) {
    cell += (std::clamp(static_cast<int>(x[d]), 0, cells.grid.cells(d) - 1) + 1) * cells.stride[d];
  }
  return cell;
}

// Along d and all directions above it: to `cell` and the neighbours that quadratic weights reach.
template <int dim, int d>
void add_along(CellGrid<dim>& cells, const int (&centre)[dim], const double (&weights)[dim][3], double m, int cell) {
  for (int k = 0; k < 3; ++k) {
    // For a point on a side the third cell lies beyond the layer; its weight is zero.
    const int at = centre[d] + k - 1;
    if (at < 0 || at >= cells.count[d]) continue;
    const double share = m * weights[d][k];
    const int here = cell + at * cells.stride[d];
    if constexpr (d + 1 == dim) {
      cells.mass[static_cast<std::size_t>(here)] += share;
    } else {
      add_along<dim, d + 1>(cells, centre, weights, share, here);
    }
  }
}

template <int dim>
void add_quadratic(CellGrid<dim>& cells, const double (&x)[dim], double m) {
  double weights[dim][3], local = 0;
  int centre[dim];
  for (int d = 0; d < dim; ++d) {
    centre[d] = Quadratic::anchor(x[d] - 0.5, cells.grid.cells(d), local) + 1;
    Quadratic::weights(local, weights[d]);
  }
  add_along<dim, 0>(cells, centre, weights, m, 0);
}

}  // namespace

template <int dim>
void cell_density(const Grid<dim>& grid, Columns& points, bool quadratic) {
  CellGrid<dim> cells(grid);
  const double* mass = points(column::mass);
  double* density = points(column::density);
  const double* position[dim];
  for (int d = 0; d < dim; ++d) position[d] = points(column::position, d);
  double x[dim];
  const auto logical = [&](int p) {
    for (int d = 0; d < dim; ++d) x[d] = grid.logical(position[d][p], d);
  };
  for (int p = 0; p < points.points(); ++p) {
    logical(p);
    if (quadratic) {
      add_quadratic<dim>(cells, x, mass[p]);
    } else {
      cells.mass[static_cast<std::size_t>(own_cell<dim>(cells, x))] += mass[p];
    }
  }
  if (quadratic) cells.fold_walls();
  for (int p = 0; p < points.points(); ++p) {
    logical(p);
    const int cell = own_cell<dim>(cells, x);
    density[p] = cells.mass[static_cast<std::size_t>(cell)] / cells.volume(cell);  // [York 4.5, 4.6]
  }
}

template void cell_density<1>(const Grid<1>&, Columns&, bool);
template void cell_density<2>(const Grid<2>&, Columns&, bool);
template void cell_density<3>(const Grid<3>&, Columns&, bool);

}  // namespace plumbline
