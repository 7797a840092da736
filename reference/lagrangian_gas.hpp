#pragma once
// A Godunov scheme of second order on cells that move with the gas, in the plane, the cylinder and the sphere: no gas
// crosses a cell's edge, so contacts stay as sharp as they start, and a free surface is just the last edge. It makes
// the references of problems without a closed solution (converged_gas.hpp).
// Edges: the exact Riemann problem (Toro, 3rd ed., chapter 4); in between: B. van Leer, J. Comput. Phys. 32 (1979) 101.
#include <cstdint>
#include <functional>
#include <vector>

#include "reference/gas_problem.hpp"

namespace plumbline::reference {

/// Where in a piece between jumps its edges lie, both as fractions: place(0) = 0 to place(1) = 1, increasing; empty:
/// evenly.
using CellPlacement = std::function<double(double)>;

/// `cells` + 1 edges, ascending, from problem.low to problem.high, with an edge on each jump: each piece between jumps
/// gets its share of the cells in multiples of `multiple`, at least one, so that the number of cells may differ a
/// little from `cells`. The mesh of 2 n cells with 2 m has all the edges of that of n with m.
std::vector<double> lagrangian_mesh(const GasProblem& problem, int cells, int multiple = 1,
                                    const CellPlacement& place = {});

/// At the end time; all vectors have one entry for each cell but `edges`, which has one more.
class LagrangianSolution {
 public:
  std::vector<double> edges;                                // positions or radii, ascending
  std::vector<double> masses;                               // by area, by length and radian, by steradian
  std::vector<double> density, velocity, pressure, energy;  // of the cell; energy: specific internal
  std::int64_t steps = 0;
  std::int64_t cell_steps() const { return steps * static_cast<std::int64_t>(masses.size()); }

  /// Linear within each cell, limited by its neighbours; beyond the ends the value at the end.
  GasFields at(double x) const;
  std::size_t cell_of(double x) const;  // the first or last one beyond the ends

 private:
  GasFields value(std::size_t cell) const;
};

/// problem's boundaries and dimension all supported; reflecting ends do not move. 0 < courant < 1.
/// Throws ParameterError, or std::runtime_error if a cell turns inside out.
LagrangianSolution solve_lagrangian(const GasProblem& problem, const std::vector<double>& mesh, double courant = 0.8);

}  // namespace plumbline::reference
