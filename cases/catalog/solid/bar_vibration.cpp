// Free vibration of a bar, fixed at one end.
#include "reference/bar_vibration.hpp"

#include <cmath>

#include "cases/catalog/solid/elastic_bar.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/run/extremes.hpp"
#include "cases/harness/verify/restart_gate.hpp"

namespace plumbline {
namespace {

reference::BarVibrationProblem problem_from(const Settings& settings) {
  reference::BarVibrationProblem problem;
  problem.youngs_modulus = settings.number("youngs_modulus");
  problem.density = settings.number("initial_density");
  problem.length = settings.number("length");
  problem.velocity = settings.number("velocity");
  problem.mode = settings.integer("mode");
  return problem;
}

// The centre of mass moves to and fro: its velocity's extremes give the period.
Measure period_measure(const reference::BarVibration& exact, const ElasticBar::History& history) {
  const auto period = mean_period(find_extremes(history.time, history.mean_velocity));
  const reference::Bounded right = exact.period();
  return scalar_measure("period", period.value_or(std::nan("")), right.value, right.bound, "s");
}

class BarVibrationCase final : public Case {
 public:
  std::string name() const override { return "bar-vibration"; }

  Kind kind() const override { return Kind::solid; }

  std::vector<Key> keys() const override {
    const reference::BarVibrationProblem bar;
    return {positive_key("youngs_modulus", bar.youngs_modulus, "Pa", "E"),
            positive_key("initial_density", bar.density, "kg/m^3", "density"),
            positive_key("length", bar.length, "m", "length of the bar"),
            positive_key("velocity", bar.velocity, "m/s", "largest velocity at the start"),
            {.name = "mode", .value = 1.0, .low = 1, .high = 20, .integer = true, .description = "number of the mode"},
            positive_key("t_end", 53, "s", "end time")};
  }

  std::vector<Override> points_and_end(const std::string&) const override { return {{"cells", 25.0}}; }
  void derive(Settings& settings, const std::string& scheme) const override {
    if (scheme == "york1997" && !settings.is_set("dt") && !settings.is_set("cfl")) {
      settings.set("cfl", 0.2, "bar-vibration");
    }
  }

  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    const auto exact = std::make_shared<const reference::BarVibration>(problem_from(settings));
    const reference::BarVibrationProblem& at = exact->problem();
    ElasticBar bar;
    bar.youngs_modulus = at.youngs_modulus;
    bar.density = at.density;
    bar.length = at.length;
    bar.fixed = true;
    bar.margin = 2 * exact->amplitude().value;
    bar.exact = [exact](double x, double t) {
      return BarSample{exact->displacement(x, t), exact->velocity(x, t), exact->stress(x, t)};
    };
    const double k = exact->wavenumber().value;
    bar.velocity_gradient = [k, v = at.velocity](double x) { return v * k * std::cos(k * x); };
    bar.further = [exact](const ElasticBar::History& history) {
      return std::vector<Measure>{period_measure(*exact, history)};
    };
    return elastic_bar_problem(std::move(bar), settings);
  }

  std::vector<double> default_levels() const override { return {8, 16, 32, 64, 128}; }

  std::vector<StudyPlan> studies() const override {
    const std::vector<double> coarse{8, 16, 32, 64, 128}, fine{8, 16, 32, 64, 128, 256, 512};
    return {
        {.id = "default",
         .title = "default, small strain",
         .why = "Everything is smooth: second order.",
         .overrides = {{"velocity", 1e-5}},
         .values = coarse,
         .full_values = fine},
        {.id = "literature", .title = "default, v₀ = 0.1, 13 cells as published", .why = "One mesh.", .values = {13}},
        {.id = "york1997",
         .title = "york1997, v₀ = 0.1, 13 cells",
         .why = "One mesh.",
         .scheme = "york1997",
         .values = {13}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const char* measure : {"period", "displacement.worst", "displacement.L2"}) {
      all.push_back(fitted_order_gate("default", measure,
                                      declare(std::string("default/") + measure + "-order", {1.8, {}}, Origin::theory,
                                              "second order; 0.2 for the coarsest mesh")));
    }
    all.push_back(fitted_order_gate("default", "energy_lost",
                                    declare("default/energy_lost-order", {2.8, {}}, Origin::theory,
                                            "(kh)^4 of a wave a step, h^-1 steps: 3; 0.2 for the coarsest mesh")));
    all.push_back(energy_monotone_gate("default"));
    all.push_back(energy_monotone_gate("literature"));
    for (const char* study : {"literature", "york1997"}) {
      all.push_back(value_gate(study, "period", 13,
                               declare(std::string(study) + "/period-13", {9.9, 10.1}, Origin::theory,
                                       "10 s, and 1 % for the strain, which the linear reference does not know")));
    }
    all.push_back(restart_gate("default", "runs of a solid"));
    for (const char* integrator : {"implicit-midpoint", "generalized-alpha", "central-difference"}) {
      all.push_back(restart_gate("default", std::string("runs with the integrator ") + integrator,
                                 {{"integrator", integrator}, {"transfer", "flip"}}, std::string("-") + integrator));
    }
    return all;
  }
};

PLUMBLINE_CASE(BarVibrationCase);

}  // namespace
}  // namespace plumbline
