// Flows without a closed solution, judged against a converged one: Shu and Osher's, Woodward and Colella's.
#include <functional>

#include "cases/gas/gas_case.hpp"
#include "cases/gas/gas_problem.hpp"
#include "cases/gas/shock_tube.hpp"
#include "cases/gas/stick.hpp"
#include "reference/converged_gas.hpp"

namespace plumbline {
namespace {

struct ConvergedTube {
  std::string name, title, source, claim, physics, sketch, cells_along;
  std::function<reference::GasProblem()> problem;
  std::function<const reference::ConvergedGas&()> solution;
  std::vector<std::string> known_limits;
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

  Statement statement() const override {
    Statement s;
    s.name = tube_.name;
    s.title = tube_.title;
    s.source = tube_.source;
    s.claim = tube_.claim;
    s.physics = tube_.physics;
    s.equations = gas_equations();
    s.sketch = tube_.sketch;
    s.cells_along = tube_.cells_along;
    s.reference_name = tube_.name;
    s.reference_text =
        "No closed solution: a Lagrangian scheme of another kind, on three meshes each twice as fine as the one "
        "before.";
    s.reference_bound =
        "Estimated from the three meshes (grid convergence index); levels whose error is not well above it do not "
        "enter "
        "the fit.";
    s.theory_orders = first_order_at_jumps();
    s.known_limits = tube_.known_limits;
    return s;
  }

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

  GateCount gate_count() const override { return {7, 7}; }

 private:
  ConvergedTube tube_;
  RegisterCase registered_;
};

const ConvergedCase shu_osher{
    {.name = "shu-osher",
     .title = "A shock runs into a density wave",
     .source = "C.-W. Shu, S. Osher, J. Comput. Phys. 83 (1989) 32, doi 10.1016/0021-9991(89)90222-2, example 8",
     .claim = "The short waves behind the shock are resolved, and errors fall at first order.",
     .physics =
         "A shock of Mach 3 enters gas whose density is a sine wave. It compresses the wave to a short one that stays "
         "behind it, and sends sound back that steepens into weak shocks. Dissipation takes the short waves first: on "
         "coarse meshes their height is the error.\n\n"
         "Gas streams in through the left end: it goes on beyond, so far that nothing which the wall out there sends "
         "arrives. The right end is not reached. Errors are judged in [−5, 5].",
     .sketch =
         R"svg(<svg viewBox="0 0 360 110" role="img" aria-label="Density: high behind a shock at the left, a sine wave ahead of it"><g stroke="currentColor" stroke-width="1.5" fill="none"><path d="M20 20h32v45c8 -14 12 -14 20 0s12 14 20 0s12 -14 20 0s12 14 20 0s12 -14 20 0s12 14 20 0s12 -14 20 0s12 14 20 0s12 -14 20 0s12 14 20 0s12 -14 20 0s12 14 20 0s12 -14 20 0s12 14 20 0"/><path d="M60 30h40m-8 -5l8 5l-8 5"/></g><g fill="currentColor" font-size="12" text-anchor="middle"><text x="24" y="100">−5</text><text x="52" y="100">−4</text><text x="332" y="100">5</text></g></svg>)svg",
     .cells_along = "the domain's length of 10 m",
     .problem = reference::shu_osher_problem,
     .solution = reference::shu_osher,
     .known_limits = {"Below 400 cells the short waves behind the shock are not resolved."}}};

const ConvergedCase woodward_colella{
    {.name = "woodward-colella",
     .title = "Two blast waves that collide",
     .source = "P. Woodward, P. Colella, J. Comput. Phys. 54 (1984) 115, doi 10.1016/0021-9991(84)90142-6",
     .claim = "Strong shocks that cross each other and contacts keep the first order.",
     .physics = "Three gases of one density between walls, with pressures of 1000, 0.01 and 100. Two strong shocks run "
                "at each "
                "other, collide, and cross contacts and rarefactions reflected from the walls. At the end the densest "
                "gas is a "
                "layer a few hundredths wide between contacts: its height is what meshes lose first.",
     .sketch =
         R"svg(<svg viewBox="0 0 360 110" role="img" aria-label="A closed tube with three gases of pressures 1000, 0.01 and 100"><g fill="none" stroke="currentColor" stroke-width="1.5"><rect x="20" y="25" width="320" height="40"/><path d="M52 19v52M308 19v52" stroke-dasharray="4 3"/></g><rect x="20" y="25" width="32" height="40" fill="currentColor" opacity=".4"/><rect x="308" y="25" width="32" height="40" fill="currentColor" opacity=".2"/><g fill="currentColor" font-size="12" text-anchor="middle"><text x="36" y="18">1000</text><text x="180" y="49">p = 0.01</text><text x="324" y="18">100</text><text x="20" y="90">0</text><text x="52" y="90">0.1</text><text x="308" y="90">0.9</text><text x="340" y="90">1</text></g></svg>)svg",
     .cells_along = "the tube's length of 1 m",
     .problem = reference::woodward_colella_problem,
     .solution = reference::woodward_colella,
     .known_limits = {
         "Contacts are followed by the points, but their internal energy keeps what each shock overheated."}}};

}  // namespace
}  // namespace plumbline
