// A shear flow that its own viscosity brings to rest.
#include "reference/shear_decay.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "cases/gas/gas_case.hpp"
#include "cases/gas/gas_problem.hpp"

namespace plumbline {
namespace {

// Rigid ends at y = 0 and y = height hold the sliding gas up; what they send comes with the speed of sound, 1.19 m/s,
// by 0.24 m until the end, spread by viscosity over sqrt(4/3 nu t) = 0.2 m. Judged is a strip in the middle, 1.4 m from
// either end: the front of the sound, and five of those lengths beyond it.
constexpr double height = 3, half_strip = 0.1;  // m

constexpr const char* sketch =
    R"svg(<svg viewBox="0 0 360 110" role="img" aria-label="Gas sliding up at the left wall and down at the right wall, half a cosine between">
<g fill="none" stroke="currentColor" stroke-width="1.5"><path d="M80 5v100M280 5v100"/><path d="M80 55h200" stroke-dasharray="4 3"/><path d="M80 20c60 0 60 70 200 70"/>
<path d="M90 55v-33m-4 7l4 -7l4 7M130 55v-24m-4 7l4 -7l4 7M230 55v24m-4 -7l4 7l4 -7M270 55v33m-4 -7l4 7l4 -7"/></g>
<g fill="currentColor" font-size="12"><text x="20" y="58">slip wall</text><text x="290" y="58">slip wall</text></g></svg>)svg";

reference::ShearDecayProblem shear_of(const Settings& settings) {
  reference::ShearDecayProblem shear;
  shear.amplitude = settings.number("amplitude");
  shear.wavenumber = std::numbers::pi;
  shear.viscosity = settings.number("viscosity");
  return shear;
}

class ShearDecayCase final : public Case {
 public:
  Statement statement() const override {
    Statement s;
    s.name = "shear-decay";
    s.title = "A shear flow decays by viscosity";
    s.source = "York 1997, SAND97-1893, eq. 4.1; L. D. Landau, E. M. Lifshitz, Fluid Mechanics, 2nd ed., section 24";
    s.claim = "Physical viscosity enters with York's mu and nothing else: the decay converges at second order.";
    s.physics =
        "Gas slides along slip walls, up on one side and down on the other, u_y = U cos πx. The stress 2μ e_xy of "
        "York's "
        "(4.1) brings it to rest at the rate ν π²; nothing else acts on it, so that a factor in μ, a shear strain "
        "counted twice or a map that smooths shows in the rate itself. The heat is a hundred thousandth of the "
        "internal energy and part of the reference.\n\n"
        "The walls above and below hold the gas up: what they send is kept out of the strip that is judged. "
        "Artificial viscosity acts in compression alone and stays out of it.";
    s.equations = {"ρ ∂u_y/∂t = μ ∂²u_y/∂x²", "u_y = U cos(kx) exp(−ν k² t)", "σ = 2μ e − ⅔ μ tr(e) 1 − p 1",
                   "p = (γ − 1) ρ e"};
    s.sketch = sketch;
    s.cells_along = "the distance of the slip walls of 1 m, half a wave";
    s.reference_name = "shear-decay";
    s.reference_text =
        "Closed form for a gas of constant density; heat and its sound to second order in U/c, what is left out "
        "bounded.";
    s.reference_bound = "Computed: orders of U/c left out, and rounding carried through.";
    s.theory_orders = {{"velocity.L1", 2,
                        "nothing jumps; shapes, step and points are of second order, and the smoothing of the maps is "
                        "undone to its leading term"}};
    s.known_limits = {
        "APIC keeps of a point's velocity what is affine over a kernel: shear of a wavelength of a few cells decays "
        "by the maps, too, at each step."};
    return s;
  }

  Kind kind() const override { return Kind::gas; }

  std::vector<Key> keys() const override {
    return {
        {.name = "amplitude",
         .value = 0.01,
         .unit = "m/s",
         .low = -0.1,
         .high = 0.1,
         .description = "U, largest velocity at t = 0"},
        {.name = "viscosity", .value = 0.15, .unit = "Pa s", .low = 0, .high = 0.15, .description = "mu [York 4.1]"},
        {.name = "t_end",
         .value = 0.2,
         .unit = "s",
         .low = 0,
         .high = 0.2,
         .low_open = true,
         .description = "end time"}};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override { return york_points(scheme); }
  void derive(Settings& settings, const std::string& scheme) const override { york_step(settings, scheme); }

  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    const auto exact = std::make_shared<const reference::ShearDecay>(shear_of(settings));
    GasFlow flow;
    flow.dim = 2;
    flow.high = {1, height, 0};
    flow.gamma = exact->problem().gamma;
    flow.viscosity = exact->problem().viscosity;
    flow.end_time = settings.number("t_end");
    flow.initial = [exact](double x) {
      const reference::Sample at = exact->sample(x, 0);
      return reference::GasState{at.density.value, at.velocity.value, at.pressure.value};
    };
    flow.exact = [exact](double x, double t) { return exact->sample(x, t); };
    flow.direction = [](const Position&) { return Position{0, 1, 0}; };
    flow.inside = [](const Position& x) { return std::abs(x[1] - height / 2) <= half_strip; };
    flow.filled = false;
    return gas_problem(flow, settings);
  }

  std::vector<double> default_levels() const override { return {10, 14, 20, 28, 40}; }

  std::vector<StudyPlan> studies() const override {
    const std::string why = "Nothing jumps: shapes, step and points are each of second order.";
    return {{.id = "default",
             .title = "default, shear between slip walls",
             .why = why,
             .values = {10, 12, 14, 17, 20},
             .full_values = {10, 14, 20, 28, 40}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all = target_order("default", "velocity.L1", 1.8,
                                             "smooth flow allows 2; 0.2 for the coarsest mesh, as of the sound pulse");
    all.push_back(energy_gate("default"));
    return all;
  }

  GateCount gate_count() const override { return {8, 8}; }
};

PLUMBLINE_CASE(ShearDecayCase);

}  // namespace
}  // namespace plumbline
