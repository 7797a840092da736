// Jumps that run along a bar with free ends.
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "cases/catalog/solid/elastic_bar.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "reference/bar_riemann.hpp"

namespace plumbline::bar_riemann {
namespace {

struct FreeBar : BarParameters<reference::BarRiemannProblem> {
  double velocity = positive("velocity", 0.01, "m/s", "of the left half at the start");

  explicit FreeBar(Parameters given = {}) : BarParameters(std::move(given)) {
    bar.pieces = {{0, velocity, 0}, {bar.length / 2, 0, 0}};
    end_time = positive("t_end", 1.25 / std::sqrt(1e5), "s", "end time");
  }
};

std::unique_ptr<Problem> run(const Settings& settings) {
  const FreeBar at(settings);
  ElasticBar bar = at.elastic();
  bar.margin = 2 * at.velocity * at.end_time;
  bar.exact = [exact = reference::BarRiemann(at.bar)](double x, double t) {
    const reference::BarState state = exact.state(x, t);
    return BarSample{state.displacement, state.velocity, state.stress};
  };
  return elastic_bar_problem(std::move(bar), settings);
}

std::vector<StudyPlan> studies() {
  return {
      study("default", "default", "Trains of waves behind the jumps: order 1/2 in the mean.", {50, 70, 100, 140, 200})
          .in_full({50, 100, 200, 400, 800}),
      study("york1997", "york1997", "One mesh.", {100}).of_york()};
}

std::vector<CaseGate> gates() {
  const Because half = theory("1/2, and 0.05 for coarse meshes");
  return {gate("default/velocity.L1-order", fitted_order_of("velocity.L1"), at_least(0.45), half),
          gate("default/stress.L1-order", fitted_order_of("stress.L1"), at_least(0.45), half),
          gate("default/displacement-order", fitted_order_of("displacement.L1"), at_least(1.2),
               theory("4/3 less 0.13 for coarse meshes")),
          energy_monotone_gate("default")};
}

Case bar_riemann() {
  return {.name = "bar-riemann",
          .kind = Kind::solid,
          .keys = FreeBar().keys(),
          .sets = {{"cells", 100.0}},
          .york_step = courant_number(0.2),
          .problem = run,
          .studies = studies(),
          .gates = gates(),
          .levels = {50, 100, 200, 400, 800}};
}
PLUMBLINE_CASE(bar_riemann);

}  // namespace
}  // namespace plumbline::bar_riemann
