// Noh's problem against an axis and a centre, each in two geometries.
#include <memory>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/radial.hpp"
#include "cases/catalog/gas/shock_front.hpp"
#include "reference/noh.hpp"

namespace plumbline {
namespace {

constexpr double end_time = 0.6;  // the shock then stands at 0.2 m
constexpr double judged = 0.3;  // m; gas that is there at the end came from within 0.9 m, the end of the gas is at 0.4

struct NohRadialText {
  std::string name;
  int dimension;
  double plateau;
};

GasFlow noh_flow(int dimension, const Settings& settings) {
  const RadialGeometry geometry = radial_geometry(dimension, settings.text("geometry"));
  const reference::NohProblem problem{dimension, settings.number("gamma"), 1, 1};
  const auto exact = std::make_shared<const reference::Noh>(problem);
  GasFlow flow;
  set_geometry(flow, geometry, 1, settings);
  flow.gamma = problem.gamma;
  flow.end_time = settings.number("t_end");
  flow.judged = Interval{0, judged};
  flow.initial = [problem, p = settings.number("pressure")](double) {
    return reference::GasState{problem.density, -problem.velocity, p};
  };
  flow.exact = [exact](double r, double t) { return exact->sample(r, t); };
  const double h = cell_size(flow, settings);
  flow.further = [exact, geometry, h](const std::vector<GasSample>& points, double time) {
    const reference::Bounded radius = exact->shock_radius(time);
    std::vector<Measure> all = shock_measures(
        points, h,
        {0, radius, exact->ahead(radius.value, time).density.value, exact->behind().density, exact->behind().energy});
    all.push_back(coverage_within(geometry, points, judged, h));
    return all;
  };
  return flow;
}

class NohRadial final : public Case {
 public:
  explicit NohRadial(NohRadialText text) : text_(std::move(text)), registered_(this) {}

  std::string name() const override { return text_.name; }

  Kind kind() const override { return Kind::gas; }

  Traits needs() const override { return {Trait::returned_loss}; }  // a cold gas has no energy to lose
  std::map<std::string, std::string> may_be_undefined() const override {
    if (text_.dimension != 3) return {};
    return {{"shock_position",
             "on less than 50 cells a radius the plateau of 64 hardly reaches halfway, and no shock is found"}};
  }
  std::vector<Key> keys() const override {
    return {geometry_key(text_.dimension),
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
             .high = 1e-3,
             .description = "of the cold gas; the reference has none"},
            {.name = "t_end",
             .value = end_time,
             .unit = "s",
             .low = 0,
             .high = end_time,
             .low_open = true,
             .description = "end time"}};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override {
    return scheme == "york1997" ? york_points(scheme) : std::vector<Override>{{"ppc", 2.0}};
  }
  void derive(Settings& settings, const std::string& scheme) const override { york_step(settings, scheme); }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return gas_problem(noh_flow(text_.dimension, settings), settings);
  }
  std::vector<double> default_levels() const override { return {50, 70, 100, 140, 200}; }
  std::vector<StudyPlan> studies() const override {
    StudyPlan plan{.id = "default",
                   .title = "default, by rings",
                   .why = "One shock, and the layer at the centre: order 1 in the mean.",
                   .values = {50, 70, 100, 140, 200},
                   .full_values = {100, 140, 200, 280, 400}};
    if (text_.dimension == 3) {
      plan.values = {20, 28, 36, 44, 52};
      plan.full_values = {28, 40, 52, 72, 100};
    }
    return {plan};
  }
  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all{energy_gate("default")};
    if (text_.dimension == 3) {
      add_missed(all);
      return all;
    }
    for (CaseGate& gate : required_order("default", "density.L1", 0.8,
                                         "a shock and the layer at the axis allow 1; 0.8 as of the shock tubes")) {
      all.push_back(std::move(gate));
    }
    all.push_back(shock_gates("default", 200, 1.0 / 200, text_.plateau).front());
    for (CaseGate& gate : shock_gates("default", 400, 1.0 / 400, text_.plateau)) {
      gate.tier = Tier::full;
      all.push_back(std::move(gate));
    }
    all.push_back(radial_coverage_gate("default", 200));
    return all;
  }

 private:
  // What the sphere does not reach on meshes that can be paid for.
  void add_missed(std::vector<CaseGate>& all) const {
    const std::string cause =
        "gas is compressed 64 times within a layer at the centre that is heated once and for all and some ten cells "
        "thick: "
        "the plateau lacks 48, 25 and 12 % at 52, 100 and 200 cells, with order 1";
    const double cell = 1.0 / 52;
    std::vector<CaseGate> missed = shock_gates("default", 52, cell, text_.plateau);
    missed[0].gate = expected_failure(missed[0].gate, cause, {cell, 1.2 * cell}, "2026-11-21 12b1694");
    missed[1].gate = expected_failure(missed[1].gate, cause, {0.45 * text_.plateau, 0.5 * text_.plateau},
                                      "2026-11-21 12b1694");
    all.insert(all.end(), missed.begin(), missed.end());
  }

  NohRadialText text_;
  RegisterCase registered_;
};

const NohRadial cylindrical{{"noh-cylindrical", 2, 16}};
const NohRadial spherical{{"noh-spherical", 3, 64}};

}  // namespace
}  // namespace plumbline
