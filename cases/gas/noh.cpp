// Noh's problem: cold gas runs against a wall, an axis, a centre.
#include "reference/noh.hpp"

#include <memory>

#include "cases/gas/gas_case.hpp"
#include "cases/gas/shock_front.hpp"

namespace plumbline {
namespace {

constexpr double end_time = 0.6;  // the shock of the plane then stands at 0.2 m

constexpr const char* sketch =
    R"svg(<svg viewBox="0 0 360 110" role="img" aria-label="Gas streams left against a wall; the shock it makes runs right">
<g stroke="currentColor" stroke-width="1.5" fill="none"><path d="M20 15v60" stroke-width="4"/><path d="M100 19v52" stroke-dasharray="4 3"/><path d="M200 45h-60m8 -5l-8 5l8 5M300 45h-60m8 -5l-8 5l8 5"/></g>
<rect x="22" y="25" width="78" height="40" fill="currentColor" opacity=".28"/><rect x="100" y="25" width="240" height="40" fill="currentColor" opacity=".06"/>
<g fill="currentColor" font-size="12" text-anchor="middle"><text x="60" y="49">at rest</text><text x="170" y="37">u = −1</text><text x="20" y="95">r = 0</text><text x="100" y="95">U t</text></g></svg>)svg";

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
  Statement statement() const override {
    Statement s;
    s.name = "noh";
    s.title = "Noh's problem";
    s.source = "W. F. Noh, J. Comput. Phys. 72 (1987) 78, doi 10.1016/0021-9991(87)90074-X";
    s.claim =
        "The shock of infinite strength runs at a third of the speed of the stream, within one cell, and leaves the "
        "exact density behind it but at the wall.";
    s.physics =
        "Cold gas, γ = 5/3, streams at one speed against a wall (an axis, a centre) and is stopped by a shock that "
        "runs "
        "outwards. All kinetic energy becomes heat at once: density 4 (16, 64) behind it.\n\n"
        "The exact gas has no pressure ahead of the shock. So has the gas here: its internal energy is exactly zero "
        "until the shock arrives, and nothing may make it negative.\n\n"
        "Wall heating: the first few cells are stopped before the numerical shock has its profile; they get too much "
        "heat and, at the right pressure, too little density. It stays, because nothing conducts heat away. It is "
        "measured, not mended: `wall_heating` is the largest share by which the internal energy near the wall is too "
        "high.\n\n"
        "The gas goes on beyond the domain, so far that its end is not seen. Errors are volume-weighted means over the "
        "points in the domain.";
    s.equations = gas_equations();
    s.equations.push_back("U = (γ − 1)/2 |u|,  ρ₂ = ρ (γ + 1)/(γ − 1) in the plane");
    s.sketch = sketch;
    s.cells_along = "the domain's length of 1 m";
    s.reference_name = "noh";
    s.reference_text = "Closed form.";
    s.reference_bound = "Rounding, carried through.";
    s.theory_orders = {
        {"density.L1", 1, "the shock is spread over a number of cells, and wall heating covers a number of cells"},
        {"velocity.L1", 1, "the shock is spread over a number of cells"},
        {"wall_heating", 0, "a fixed share over a fixed number of cells, as for every scheme with a viscous shock"}};
    s.known_limits = {"Density and internal energy in the cells at the wall do not converge: wall heating."};
    return s;
  }

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
    std::vector<CaseGate> all = target_order("default", "density.L1", 0.8,
                                             "a shock and the layer at the wall allow 1; 0.8 as of the shock tubes");
    for (CaseGate& gate : shock_gates("default", 400, 1.0 / 400, 4)) all.push_back(std::move(gate));
    all.push_back(energy_gate("default"));
    all.push_back(coverage_gate("default", 100));
    return all;
  }

  GateCount gate_count() const override { return {10, 10}; }
};

PLUMBLINE_CASE(Noh);

}  // namespace
}  // namespace plumbline
