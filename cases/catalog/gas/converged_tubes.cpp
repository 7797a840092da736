// Flows without a closed solution, judged against a converged one: Shu and Osher's, Woodward and Colella's.
#include "cases/catalog/gas/finite_volume_comparator.hpp"
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/shock_tube.hpp"
#include "reference/converged_gas.hpp"

namespace plumbline::converged_tubes {
namespace {

using Solution = const reference::ConvergedGas& (*)();  // made when first asked for

GasFlow flow_of(const reference::GasProblem& problem, Solution solution) {
  GasFlow flow;
  flow.cells_along = problem.high - problem.low;
  flow.low[0] = problem.low;
  flow.high[0] = problem.high;
  flow.jumps = problem.jumps;
  flow.initial = problem.initial;
  flow.exact = [solution](double x, double) { return solution().sample(x); };
  flow.exact_error = [solution] { return solution().error(); };
  flow.judged = Interval{problem.low, problem.high};
  flow.gamma = problem.gamma;
  flow.end_time = problem.end_time;
  for (const std::size_t side : {0u, 1u}) {
    const double end = side == 0 ? problem.low : problem.high;
    const double reach = disturbed_by_wall(problem.initial(end), problem.gamma, problem.end_time);
    flow.margin[side] = reach > 0 ? reach + 0.1 * flow.cells_along : 0.0;
  }
  return flow;
}

Case converged_tube(std::string name, const reference::GasProblem& problem, Solution solution) {
  return {.name = std::move(name),
          .kind = Kind::gas,
          .york1997 = york_points,
          .york_step = york_step,
          .problem = gas_run([=](const Settings&) { return flow_of(problem, solution); }),
          .studies = {study("default", "default: points of equal mass",
                            "Shocks and contacts are jumps: order 1 once the structure between them is resolved, less "
                            "before. The order is fitted to the meshes whose errors the converged reference can tell "
                            "apart from its own.",
                            {50, 70, 100, 140, 200})
                          .in_full({50, 70, 100, 140, 200, 400, 800, 1600})},
          .gates = {gate("default/density-order", fitted_order_of("density.L1"), at_least(0.5),
                         theory("a scheme of first order smears contacts as the root of h, the worst that meshes "
                                "coarser than the structure may show")),
                    energy_gate("default"), coverage_gate("default", 200)},
          .levels = {100, 200, 400, 800, 1600},
          .comparators = [=](const Settings&, const std::vector<double>& cells) -> std::vector<Comparator> {
            return {finite_volume_comparator(
                problem, [=](double x) { return solution().sample(x); }, cells)};
          }};
}

std::vector<Case> converged_tubes() {
  return {converged_tube("shu-osher", reference::shu_osher_problem(), reference::shu_osher),
          converged_tube("woodward-colella", reference::woodward_colella_problem(), reference::woodward_colella)};
}
PLUMBLINE_CASE(converged_tubes);

}  // namespace
}  // namespace plumbline::converged_tubes
