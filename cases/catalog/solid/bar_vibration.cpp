// Free vibration of a bar, fixed at one end.
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalog/solid/elastic_bar.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/run/extremes.hpp"
#include "cases/harness/verify/restart_gate.hpp"
#include "reference/bar_vibration.hpp"

namespace plumbline::bar_vibration {
namespace {

struct FixedBar : BarParameters<reference::BarVibrationProblem> {
  explicit FixedBar(Parameters given = {}) : BarParameters(std::move(given)) {
    bar.velocity = positive("velocity", bar.velocity, "m/s", "largest velocity at the start");
    bar.mode = integer({.name = "mode", .value = 1.0, .low = 1, .high = 20, .description = "number of the mode"});
    end_time = positive("t_end", 53, "s", "end time");
  }
};

// The centre of mass moves to and fro: its velocity's extremes give the period.
Measure period_measure(const reference::BarVibration& exact, const ElasticBar::History& history) {
  const auto period = mean_period(find_extremes(history.time, history.mean_velocity));
  const reference::Bounded right = exact.period();
  return scalar_measure("period", period.value_or(std::nan("")), right.value, right.bound, "s");
}

std::unique_ptr<Problem> run(const Settings& settings) {
  const FixedBar at(settings);
  const reference::BarVibration exact(at.bar);
  ElasticBar bar = at.elastic();
  bar.fixed = true;
  bar.margin = 2 * exact.amplitude().value;
  bar.exact = [exact](double x, double t) {
    return BarSample{exact.displacement(x, t), exact.velocity(x, t), exact.stress(x, t)};
  };
  const double k = exact.wavenumber().value;
  bar.velocity_gradient = [k, v = at.bar.velocity](double x) { return v * k * std::cos(k * x); };
  bar.further = [exact](const ElasticBar::History& history) { return std::vector{period_measure(exact, history)}; };
  return elastic_bar_problem(std::move(bar), settings);
}

std::vector<StudyPlan> studies() {
  return {study("default", "default, small strain", "Everything is smooth: second order.", {8, 16, 32, 64, 128})
              .with({{"velocity", 1e-5}})
              .in_full({8, 16, 32, 64, 128, 256, 512}),
          study("literature", "default, v₀ = 0.1, 13 cells as published", "One mesh.", {13}),
          study("york1997", "york1997, v₀ = 0.1, 13 cells", "One mesh.", {13}).of_york()};
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const std::string measure : {"period", "displacement.worst", "displacement.L2"}) {
    all.push_back(gate("default/" + measure + "-order", fitted_order_of(measure), at_least(1.8),
                       theory("second order; 0.2 for the coarsest mesh")));
  }
  all.push_back(gate("default/energy_lost-order", fitted_order_of("energy_lost"), at_least(2.8),
                     theory("(kh)^4 of a wave a step, h^-1 steps: 3; 0.2 for the coarsest mesh")));
  all.push_back(energy_monotone_gate("default"));
  all.push_back(energy_monotone_gate("literature"));
  for (const std::string study : {"literature", "york1997"}) {
    all.push_back(gate(study + "/period-13", value_at("period", 13), between(9.9, 10.1),
                       theory("10 s, and 1 % for the strain, which the linear reference does not know")));
  }
  all.push_back(restart_gate("default", "runs of a solid"));
  for (const std::string integrator : {"implicit-midpoint", "generalized-alpha", "central-difference"}) {
    all.push_back(restart_gate("default", "runs with the integrator " + integrator,
                               {{"integrator", integrator}, {"transfer", "flip"}}, "-" + integrator));
  }
  return all;
}

Case bar_vibration() {
  return {.name = "bar-vibration",
          .kind = Kind::solid,
          .keys = FixedBar().keys(),
          .sets = {{"cells", 25.0}},
          .york_step = courant_number(0.2),
          .problem = run,
          .studies = studies(),
          .gates = gates(),
          .levels = {8, 16, 32, 64, 128}};
}
PLUMBLINE_CASE(bar_vibration);

}  // namespace
}  // namespace plumbline::bar_vibration
