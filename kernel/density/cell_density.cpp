#include "kernel/density/cell_density.hpp"

#include <algorithm>

#include "kernel/shapes/quadratic.hpp"

namespace plumbline {
namespace {

// Cells with one layer beyond each side, as the "nodes" of quadratic shapes about cell centres.
template <int dim>
struct CellGrid {
  explicit CellGrid(const Grid<dim>& g) : grid(g) {
    for (int d = 0; d < dim; ++d) count[d] = grid.cells(d) + 2;
    mass.assign(static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(dim == 1 ? 1 : count[dim - 1]), 0.0);
  }
  double& at(int i, int j) {
    return mass[static_cast<std::size_t>(j) * static_cast<std::size_t>(count[0]) + static_cast<std::size_t>(i)];
  }
  int rows() const { return dim == 1 ? 1 : count[dim - 1]; }

  // Mass that quadratic weights put beyond a wall belongs to the mirror cell, the one inside the wall.
  void fold_walls() {
    for (int j = 0; j < rows(); ++j) {
      if (grid.wall(0, 0) != Wall::free) at(1, j) += at(0, j);
      if (grid.wall(0, 1) != Wall::free) at(count[0] - 2, j) += at(count[0] - 1, j);
    }
    if constexpr (dim == 2) {
      for (int i = 0; i < count[0]; ++i) {
        if (grid.wall(1, 0) != Wall::free) at(i, 1) += at(i, 0);
        if (grid.wall(1, 1) != Wall::free) at(i, count[1] - 2) += at(i, count[1] - 1);
      }
    }
  }

  const Grid<dim>& grid;
  int count[dim];
  std::vector<double> mass;
};

int cell_of(double x, int cells) { return std::clamp(static_cast<int>(x), 0, cells - 1) + 1; }

template <int dim>
void add_quadratic(CellGrid<dim>& cells, const double (&x)[dim], double m) {
  double w[2][3] = {{0, 1, 0}, {0, 1, 0}}, local = 0;
  int centre[2] = {0, 0};
  for (int d = 0; d < dim; ++d) {
    centre[d] = Quadratic::anchor(x[d] - 0.5, cells.grid.cells(d), local) + 1;
    Quadratic::weights(local, w[d]);
  }
  for (int j = dim == 1 ? 1 : 0; j < (dim == 1 ? 2 : 3); ++j) {
    for (int i = 0; i < 3; ++i) {
      const int column = centre[0] + i - 1, row = dim == 1 ? 0 : centre[1] + j - 1;
      // For a point on a side the third cell lies beyond the layer; its weight is zero.
      if (column < 0 || column >= cells.count[0] || row < 0 || row >= cells.rows()) continue;
      cells.at(column, row) += m * w[0][i] * w[1][j];
    }
  }
}

}  // namespace

template <int dim>
void cell_density(const Grid<dim>& grid, Columns& points, bool quadratic) {
  CellGrid<dim> cells(grid);
  const double* mass = points(column::mass);
  double* density = points(column::density);
  const auto logical = [&](int p, double(&x)[dim]) {
    for (int d = 0; d < dim; ++d) x[d] = grid.logical(points(column::position, d)[p], d);
  };
  const auto own = [&](const double(&x)[dim]) -> double& {
    return cells.at(cell_of(x[0], grid.cells(0)), dim == 1 ? 0 : cell_of(x[dim - 1], grid.cells(dim - 1)));
  };
  double x[dim];
  for (int p = 0; p < points.points(); ++p) {
    logical(p, x);
    if (quadratic) {
      add_quadratic<dim>(cells, x, mass[p]);
    } else {
      own(x) += mass[p];
    }
  }
  if (quadratic) cells.fold_walls();
  double volume = grid.h();
  if constexpr (dim == 2) volume *= grid.h();
  for (int p = 0; p < points.points(); ++p) {
    logical(p, x);
    density[p] = own(x) / volume;  // [York 4.5, 4.6]
  }
}

template void cell_density<1>(const Grid<1>&, Columns&, bool);
template void cell_density<2>(const Grid<2>&, Columns&, bool);

}  // namespace plumbline
