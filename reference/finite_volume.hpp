#pragma once
// What a gas dynamicist would pick: a plain second-order finite-volume solver in one dimension, MUSCL-Hancock with
// van Leer's limiter and the HLLC fluxes (Toro, 3rd ed., sections 14.4 and 10.4). The comparator beside which
// error and cost of other methods are shown; it is no reference for them.
#include <cstdint>
#include <functional>
#include <vector>

#include "reference/gas_problem.hpp"

namespace plumbline::reference {

/// At the end time. `cells` are the means of density, momentum and energy as the state that has them.
struct FiniteVolumeSolution {
  double low = 0, high = 1, gamma = 1.4;
  std::vector<GasState> cells;
  std::int64_t steps = 0;
  double width() const { return (high - low) / static_cast<double>(cells.size()); }
  double centre(std::size_t i) const { return low + (static_cast<double>(i) + 0.5) * width(); }
  std::int64_t cell_steps() const { return steps * static_cast<std::int64_t>(cells.size()); }  // the cost
};

/// Planar only, reflecting or outflow ends; cells >= 2, 0 < courant < 1 (the limit of stability, by |u| + a).
/// Throws ParameterError for anything else, std::runtime_error if density or energy stops being positive.
FiniteVolumeSolution solve_finite_volume(const GasProblem& problem, int cells, double courant = 0.8);

/// Means over the domain of |cell mean - exact(centre of the cell)|; energy is specific internal energy.
GasFields mean_errors(const FiniteVolumeSolution& solution, const std::function<GasState(double)>& exact);

}  // namespace plumbline::reference
