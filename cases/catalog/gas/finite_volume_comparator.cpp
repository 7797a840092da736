#include "cases/catalog/gas/finite_volume_comparator.hpp"

#include <chrono>

#include "cases/catalog/gas/gas_problem.hpp"
#include "reference/finite_volume.hpp"

namespace plumbline {

Comparator finite_volume_comparator(const reference::GasProblem& problem,
                                    const std::function<reference::Sample(double x)>& exact,
                                    const std::vector<double>& cells) {
  Comparator comparator{"finite-volume", "finite volumes, second order (MUSCL-Hancock, HLLC)"};
  for (const double n : cells) {
    const auto start = std::chrono::steady_clock::now();
    const auto solution = reference::solve_finite_volume(problem, static_cast<int>(n));
    const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const auto errors = reference::mean_errors(solution, [&](double x) { return state_of(exact(x)); });
    comparator.levels.push_back({n,
                                 solution.steps,
                                 solution.cell_steps(),
                                 wall,
                                 {{"density.L1", errors.density},
                                  {"velocity.L1", errors.velocity},
                                  {"pressure.L1", errors.pressure},
                                  {"energy.L1", errors.energy}}});
  }
  return comparator;
}

}  // namespace plumbline
