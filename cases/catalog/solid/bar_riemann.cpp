// Jumps that run along a bar with free ends.
#include "reference/bar_riemann.hpp"

#include <cmath>

#include "cases/catalog/solid/elastic_bar.hpp"
#include "cases/catalog/solid/manufactured_case.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {
namespace {

class BarRiemannCase final : public Case {
 public:
  std::string name() const override { return "bar-riemann"; }

  Kind kind() const override { return Kind::solid; }

  std::vector<Key> keys() const override {
    const reference::BarRiemannProblem bar;
    return {positive_key("youngs_modulus", bar.youngs_modulus, "Pa", "E"),
            positive_key("initial_density", bar.density, "kg/m^3", "density"),
            positive_key("length", bar.length, "m", "length of the bar"),
            positive_key("velocity", 0.01, "m/s", "of the left half at the start"),
            positive_key("t_end", 1.25 / std::sqrt(1e5), "s", "end time")};
  }

  std::vector<Override> points_and_end(const std::string&) const override { return {{"cells", 100.0}}; }
  void derive(Settings& settings, const std::string& scheme) const override {
    if (scheme == "york1997" && !settings.is_set("dt") && !settings.is_set("cfl")) {
      settings.set("cfl", 0.2, "bar-riemann");
    }
  }

  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    reference::BarRiemannProblem at;
    at.youngs_modulus = settings.number("youngs_modulus");
    at.density = settings.number("initial_density");
    at.length = settings.number("length");
    at.pieces = {{0, settings.number("velocity"), 0}, {at.length / 2, 0, 0}};
    const auto exact = std::make_shared<const reference::BarRiemann>(at);
    ElasticBar bar;
    bar.youngs_modulus = at.youngs_modulus;
    bar.density = at.density;
    bar.length = at.length;
    bar.margin = 2 * settings.number("velocity") * settings.number("t_end");
    bar.exact = [exact](double x, double t) {
      const reference::BarState state = exact->state(x, t);
      return BarSample{state.displacement, state.velocity, state.stress};
    };
    return elastic_bar_problem(std::move(bar), settings);
  }

  std::vector<double> default_levels() const override { return {50, 100, 200, 400, 800}; }

  std::vector<StudyPlan> studies() const override {
    return {{.id = "default",
             .title = "default",
             .why = "Trains of waves behind the jumps: order 1/2 in the mean.",
             .values = {50, 70, 100, 140, 200},
             .full_values = {50, 100, 200, 400, 800}},
            {.id = "york1997", .title = "york1997", .why = "One mesh.", .scheme = "york1997", .values = {100}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const char* measure : {"velocity.L1", "stress.L1"}) {
      all.push_back(fitted_order_gate("default", measure,
                                      declare(std::string("default/") + measure + "-order", {0.45, {}}, Origin::theory,
                                              "1/2, and 0.05 for coarse meshes")));
    }
    all.push_back(fitted_order_gate(
        "default", "displacement.L1",
        declare("default/displacement-order", {1.2, {}}, Origin::theory, "4/3 less 0.13 for coarse meshes")));
    all.push_back(energy_monotone_gate("default"));
    return all;
  }
};

PLUMBLINE_CASE(BarRiemannCase);

}  // namespace
}  // namespace plumbline
