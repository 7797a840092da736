// Flows without a closed solution, judged against a converged one: Shu and Osher's, Woodward and Colella's.
#include <functional>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/gas_problem.hpp"
#include "cases/catalog/gas/shock_tube.hpp"
#include "cases/catalog/gas/stick.hpp"
#include "reference/converged_gas.hpp"

namespace plumbline {
namespace {

struct ConvergedTube {
  std::string name;
  std::function<reference::GasProblem()> problem;
  std::function<const reference::ConvergedGas&()> solution;
};

GasFlow flow_of(const ConvergedTube& tube) {
  const reference::GasProblem problem = tube.problem();
  GasFlow flow;
  flow.cells_along = problem.high - problem.low;
  flow.low[0] = problem.low;
  flow.high[0] = problem.high;
  flow.jumps = problem.jumps;
  flow.initial = problem.initial;
  flow.exact = [solution = tube.solution](double x, double) { return solution().sample(x); };
  flow.exact_error = [solution = tube.solution] { return solution().error(); };
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

class ConvergedCase final : public Case {
 public:
  explicit ConvergedCase(ConvergedTube tube) : tube_(std::move(tube)), registered_(this) {}

  std::string name() const override { return tube_.name; }

  Kind kind() const override { return Kind::gas; }
  std::vector<Key> keys() const override { return {}; }
  std::vector<Override> points_and_end(const std::string& scheme) const override { return york_points(scheme); }
  void derive(Settings& settings, const std::string& scheme) const override { york_step(settings, scheme); }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return gas_problem(flow_of(tube_), settings);
  }
  std::vector<double> default_levels() const override { return {100, 200, 400, 800, 1600}; }

  std::vector<Comparator> comparators(const Settings&, const std::vector<double>& cells) const override {
    return {finite_volume_stick(
        tube_.problem(), [this](double x) { return tube_.solution().sample(x); }, cells)};
  }

  std::vector<StudyPlan> studies() const override {
    return {
        {.id = "default",
         .title = "default: points of equal mass",
         .why = "Shocks and contacts are jumps: order 1 once the structure between them is resolved, less before. The "
                "order is fitted to the meshes whose errors the converged reference can tell apart from its own.",
         .values = {50, 70, 100, 140, 200},
         .full_values = {50, 70, 100, 140, 200, 400, 800, 1600}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all = {
        fitted_order_gate("default", "density.L1",
                          declare("default/density-order", {0.5, {}}, Origin::theory,
                                  "a scheme of first order smears contacts as the root of h, the worst that meshes "
                                  "coarser than the structure may show"))};
    all.push_back(energy_gate("default"));
    all.push_back(coverage_gate("default", 200));
    return all;
  }

 private:
  ConvergedTube tube_;
  RegisterCase registered_;
};

const ConvergedCase shu_osher{{"shu-osher", reference::shu_osher_problem, reference::shu_osher}};
const ConvergedCase woodward_colella{
    {"woodward-colella", reference::woodward_colella_problem, reference::woodward_colella}};

}  // namespace
}  // namespace plumbline
