// Sod's shock tube in space.
#include "cases/gas/gas_case.hpp"
#include "cases/gas/sod_tube.hpp"
#include "cases/harness/restart_gate.hpp"

namespace plumbline {
namespace {

const ShockTube tube = [] {
  ShockTube solid = sod_tube;
  solid.dimension = 3;
  return solid;
}();

constexpr const char* sketch =
    R"svg(<svg viewBox="0 0 360 110" role="img" aria-label="A square duct, dense gas left and thin gas right of a diaphragm across it">
<g fill="none" stroke="currentColor" stroke-width="1.5"><path d="M20 40h290v40h-290zM20 40l25 -20h290l-25 20M335 20v40l-25 20"/><path d="M165 80v-40l25 -20" stroke-dasharray="4 3"/></g>
<rect x="20" y="40" width="145" height="40" fill="currentColor" opacity=".28"/><rect x="165" y="40" width="145" height="40" fill="currentColor" opacity=".06"/>
<g fill="currentColor" font-size="12" text-anchor="middle"><text x="92" y="64">ρ = 1, p = 1</text><text x="237" y="64">ρ = 0.125, p = 0.1</text>
<text x="20" y="97">x = 0</text><text x="165" y="97">0.5</text><text x="310" y="97">1</text></g></svg>)svg";

class Sod3d final : public Case {
 public:
  Statement statement() const override {
    Statement s;
    s.name = "sod-3d";
    s.title = "Sod's shock tube in space";
    s.source = "York 1997, SAND97-1893, section 4.1; Sod 1978, doi 10.1016/0021-9991(78)90023-2";
    s.claim = "In space the aligned tube has the numbers of the tube on a line, but for rounding.";
    s.physics =
        "Sod's tube as a square duct, four cells wide between mirrors. Points stand on lines along the duct, two a "
        "cell across, all alike: what each direction across adds to a sum over points is a sum of shape functions at "
        "places half a cell apart, which is one at every node. So nodes across the duct have equal velocities, "
        "nothing moves across, and every line does what the points on a line do.\n\n"
        "Whatever a geometry gets wrong - a weight, a gradient, a wall's half cell, a volume - shows here at once.";
    s.equations = gas_equations();
    s.sketch = sketch;
    s.cells_along = "the tube's length of 1 m";
    s.reference_name = "riemann";
    s.reference_text = "Exact solution of the Riemann problem, as for the tube on a line.";
    s.reference_bound = "Computed with each value: residual of the root over the slope, and rounding carried through.";
    s.theory_orders = first_order_at_jumps();
    s.known_limits = {"Where the layout is not aligned with the grid the sums across are not one: see sod-rotated."};
    return s;
  }

  Kind kind() const override { return Kind::gas; }
  std::vector<Key> keys() const override { return shock_tube_keys(tube); }
  std::vector<Override> points_and_end(const std::string& scheme) const override { return york_points(scheme); }
  void derive(Settings& settings, const std::string& scheme) const override { york_step(settings, scheme); }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return shock_tube_problem(shock_tube_from(settings, tube), settings);
  }
  std::vector<double> default_levels() const override { return {50, 70, 100, 140, 200}; }

  std::vector<StudyPlan> studies() const override {
    const std::string why = "Shock and contact are jumps: order 1, in any number of dimensions.";
    const std::vector<double> few{50, 100}, levels{50, 70, 100, 140, 200};
    return {{.id = "default", .title = "default, in space", .why = why, .values = few, .full_values = levels},
            {.id = "line",
             .title = "default, on a line",
             .why = why,
             .overrides = {{"dimension", 1.0}},
             .values = few,
             .full_values = levels},
            {.id = "equal-volume",
             .title = "default with points of equal volume, in space",
             .why = why,
             .overrides = {{"points", "equal-volume"}, {"ppc", 3.0}},
             .values = {50}},
            {.id = "equal-volume-line",
             .title = "default with points of equal volume, on a line",
             .why = why,
             .overrides = {{"dimension", 1.0}, {"points", "equal-volume"}, {"ppc", 3.0}},
             .values = {50}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all{same_numbers_gate("default", "line", 50), same_numbers_gate("default", "line", 100),
                              same_numbers_gate("equal-volume", "equal-volume-line", 50), energy_gate("default"),
                              coverage_gate("default", 100)};
    all.push_back(fitted_order_gate("default", "density.L1",
                                    declare("default/density-order", {0.8, {}}, Origin::theory,
                                            "shock and contact allow 1; 0.8 as of the other shock tubes"),
                                    Tier::full));
    all.push_back(restart_gate("default", "runs in space"));
    return all;
  }

  GateCount gate_count() const override { return {24, 25}; }
};

PLUMBLINE_CASE(Sod3d);

}  // namespace
}  // namespace plumbline
