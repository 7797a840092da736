// Noh's problem: cold gas runs against a wall, an axis, a centre.
#include "reference/noh.hpp"

#include <memory>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/shock_front.hpp"

namespace plumbline {
namespace {

constexpr double end_time = 0.6;  // the shock of the plane then stands at 0.2 m

// What a key `geometry` stands for; each a row of the table of geometries.
struct NohGeometry {
  std::string name;
  int dimension;  // of the exact solution
};
const std::vector<NohGeometry>& geometries() {
  static const std::vector<NohGeometry> all{{"plane", 1}};
  return all;
}
const NohGeometry& geometry_of(const Settings& settings) {
  for (const NohGeometry& geometry : geometries()) {
    if (geometry.name == settings.text("geometry")) return geometry;
  }
  return geometries().front();
}

GasFlow noh_flow(const Settings& settings) {
  const reference::NohProblem problem{geometry_of(settings).dimension, settings.number("gamma"), 1, 1};
  const auto exact = std::make_shared<const reference::Noh>(problem);
  GasFlow flow;
  flow.gamma = problem.gamma;
  flow.end_time = settings.number("t_end");
  // Gas beyond the domain, as long as it takes what stands there to arrive: the stream carries everything inwards.
  flow.margin = {0, problem.velocity * flow.end_time + 0.1};
  flow.initial = [problem, p = settings.number("pressure")](double) {
    return reference::GasState{problem.density, -problem.velocity, p};
  };
  flow.exact = [exact](double r, double t) { return exact->sample(r, t); };
  const double h = flow.cells_along / settings.number("cells");
  flow.further = [exact, h](const std::vector<GasSample>& points, double time) {
    const reference::Bounded radius = exact->shock_radius(time);
    return shock_measures(
        points, h,
        {0, radius, exact->ahead(radius.value, time).density.value, exact->behind().density, exact->behind().energy});
  };
  return flow;
}

class Noh final : public Case {
 public:
  std::string name() const override { return "noh"; }

  Kind kind() const override { return Kind::gas; }

  Traits needs() const override { return {Trait::returned_loss}; }  // a cold gas has no energy to lose
  std::vector<Key> keys() const override {
    std::vector<std::string> names;
    for (const NohGeometry& geometry : geometries()) names.push_back(geometry.name);
    return {{.name = "geometry", .value = names.front(), .choices = names, .description = "against what the gas runs"},
            {.name = "gamma",
             .value = 5.0 / 3,
             .low = 1,
             .high = 3,
             .low_open = true,
             .description = "ratio of specific heats"},
            {.name = "pressure",
             .value = 0.0,
             .unit = "Pa",
             .low = 0,
             .description = "of the cold gas; the reference has none"},
            {.name = "t_end", .value = end_time, .unit = "s", .low = 0, .low_open = true, .description = "end time"}};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override { return york_points(scheme); }
  void derive(Settings& settings, const std::string& scheme) const override { york_step(settings, scheme); }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return gas_problem(noh_flow(settings), settings);
  }
  std::vector<double> default_levels() const override { return {100, 200, 400, 800, 1600}; }

  std::vector<StudyPlan> studies() const override {
    return {{.id = "default",
             .title = "default, against a wall",
             .why = "One shock, and the layer at the wall: order 1 in the mean.",
             .values = {100, 140, 200, 280, 400},
             .full_values = {100, 200, 400, 800, 1600}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all = required_order("default", "density.L1", 0.8,
                                               "a shock and the layer at the wall allow 1; 0.8 as of the shock tubes");
    for (CaseGate& gate : shock_gates("default", 400, 1.0 / 400, 4)) all.push_back(std::move(gate));
    all.push_back(energy_gate("default"));
    all.push_back(coverage_gate("default", 100));
    return all;
  }
};

PLUMBLINE_CASE(Noh);

}  // namespace
}  // namespace plumbline
