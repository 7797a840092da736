// Noh's problem against an axis and a centre, each in two geometries.
#include <memory>

#include "cases/gas/gas_case.hpp"
#include "cases/gas/radial.hpp"
#include "cases/gas/shock_front.hpp"
#include "reference/noh.hpp"

namespace plumbline {
namespace {

constexpr double end_time = 0.6;  // the shock then stands at 0.2 m
constexpr double judged = 0.3;  // m; gas that is there at the end came from within 0.9 m, the end of the gas is at 0.4

constexpr const char* sketch =
    R"svg(<svg viewBox="0 0 360 150" role="img" aria-label="Gas streams towards the centre from all sides; the shock it makes runs outwards">
<g stroke="currentColor" stroke-width="1.5" fill="none"><path d="M110 10v125h150" /><path d="M110 85a50 50 0 0 1 50 50" stroke-dasharray="4 3"/><path d="M240 115l-50 8m9 -6l-9 6l10 3M215 60l-40 35m4 -10l-4 10l10 -3M130 25l-8 48m-4 -9l4 9l7 -8"/></g>
<path d="M110 135v-50a50 50 0 0 1 50 50z" fill="currentColor" opacity=".28"/>
<g fill="currentColor" font-size="12"><text x="116" y="128">at rest</text><text x="222" y="80">u = −1</text><text x="146" y="149">U t</text></g></svg>)svg";

struct NohRadialText {
  std::string name, title, claim, around;
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

  Statement statement() const override {
    Statement s;
    s.name = text_.name;
    s.title = text_.title;
    s.source = "W. F. Noh, J. Comput. Phys. 72 (1987) 78, doi 10.1016/0021-9991(87)90074-X";
    s.claim = text_.claim;
    s.physics =
        "Cold gas, γ = 5/3, streams at one speed towards " + text_.around +
        ", grows denser on its way because there is less and less room, and is stopped by a shock that runs outwards "
        "at a third of the stream's speed.\n\n"
        "Ahead of the shock there is no pressure, and the gas may not heat: what is squeezed sideways there is "
        "compressed without resistance. An artificial viscosity that cannot tell this squeeze from a shock heats it; "
        "the density ahead is then right and the energy is not.\n\n"
        "Wall heating is stronger than against a wall: the first gas that is stopped is a whole kernel of it, at the "
        "place with the least room. It is measured, not mended: `wall_heating`.\n\n"
        "At t = 0 the gas fills the domain of 1 m. Its end streams in too and is at 0.4 m at the end time; errors are "
        "judged within 0.3 m. The gas starts without affine velocities: the first map makes what a kernel's width "
        "takes of the turning direction into heat, h²/(8 r²) of u².";
    s.equations = gas_equations();
    s.equations.push_back("U = (γ − 1)/2 |u|,  ρ₂ = ρ ((γ + 1)/(γ − 1))^d");
    s.sketch = sketch;
    s.cells_along = "a radius of 1 m";
    s.reference_name = "noh";
    s.reference_text = "Closed form.";
    s.reference_bound = "Rounding, carried through.";
    s.theory_orders = {
        {"density.L1", 1, "the shock is spread over a number of cells, and wall heating covers a number of cells"},
        {"velocity.L1", 1, "the shock is spread over a number of cells"},
        {"wall_heating", 0, "a fixed share over a fixed number of cells, as for every scheme with a viscous shock"}};
    s.known_limits = {"Density and internal energy in the cells at the centre do not converge: wall heating."};
    if (text_.dimension == 3) {
      s.known_limits.push_back(
          "At 100 cells of a radius the plateau of 64 is a quarter too low and the shock a cell ahead of its place: it "
          "is 20 cells from the centre, and the wall heating covers a quarter of that. No gate asks for more.");
    }
    return s;
  }

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
    for (CaseGate& gate : target_order("default", "density.L1", 0.8,
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
  GateCount gate_count() const override { return text_.dimension == 3 ? GateCount{7, 7} : GateCount{9, 11}; }

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

const NohRadial cylindrical{{"noh-cylindrical", "Noh's problem against an axis",
                             "The shock stands within one cell of its place and leaves sixteen times the density.",
                             "an axis", 2, 16}};
const NohRadial spherical{
    {"noh-spherical", "Noh's problem against a centre",
     "The shock runs outwards at a third of the stream's speed; what coarse meshes leave of 64 times the density.",
     "a centre", 3, 64}};

}  // namespace
}  // namespace plumbline
