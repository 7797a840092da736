// Jumps that run along a bar with free ends.
#include "reference/bar_riemann.hpp"

#include <cmath>

#include "cases/harness/gates.hpp"
#include "cases/solid/elastic_bar.hpp"
#include "cases/solid/manufactured_case.hpp"

namespace plumbline {
namespace {

constexpr const char* sketch =
    R"svg(<svg viewBox="0 0 360 120" role="img" aria-label="A bar whose left half moves right at the start; two jumps run outwards from the middle">
<g stroke="currentColor" stroke-width="1.5" fill="none"><path d="M40 25h280v24h-280z"/><path d="M180 25v24" stroke-dasharray="4 3"/><path d="M90 37h50m-8-5l8 5l-8 5"/><path d="M176 62h-50m8-5l-8 5l8 5M184 62h50m-8-5l8 5l-8 5"/><path d="M40 85h60v10h160v10h60" opacity=".7"/></g>
<g fill="currentColor" font-size="12" text-anchor="middle"><text x="110" y="18">v = v₀</text><text x="250" y="18">v = 0</text><text x="150" y="78">c</text><text x="210" y="78">c</text></g></svg>)svg";

class BarRiemannCase final : public Case {
 public:
  Statement statement() const override {
    Statement s;
    s.name = "bar-riemann";
    s.title = "Jumps in a bar";
    s.source =
        "J. le R. d'Alembert 1747; R. J. LeVeque, Finite Volume Methods for Hyperbolic Problems, 2002, section 2.9";
    s.claim = "Jumps run at the speed of sound, reflect at free ends, and are spread without being raised.";
    s.physics =
        "The left half of a free bar (E = 1e5, ρ = 1, L = 1) moves at 0.01 m/s, the right half rests. A compression of "
        "ρcv/2 runs out from the middle to both sides and comes back from the free ends as tension; at t = 1.25 L/c "
        "the "
        "two have passed each other.\n\n"
        "Strains are 1.6e-5, and the linear reference is right to that share. Nothing but the affine transfer damps "
        "the "
        "short waves that trail each jump.";
    s.equations = {"ρ ∂v/∂t = ∂σ/∂x,  ∂σ/∂t = E ∂v/∂x", "v ∓ σ/(ρc) constant along x ∓ ct = const", "free end: σ = 0"};
    s.sketch = sketch;
    s.cells_along = "the bar's length";
    s.reference_name = "bar-riemann";
    s.reference_text = "d'Alembert's solution, the bar unfolded at its ends.";
    s.reference_bound = "Rounding, carried through; where it leaves the side of a jump open, both sides.";
    for (const char* measure : {"velocity.L1", "stress.L1"}) {
      s.theory_orders.push_back(
          {measure, 0.5,
           "dispersion of second order makes of a jump an integral of Airy's function over the width d = (t h²)^(1/3), "
           "whose waves fall with the distance s d as s^(-3/4): d (1/d)^(1/4) in the mean, order 1/2"});
    }
    s.theory_orders.push_back({"displacement.L1", 4.0 / 3, "its waves fall faster than 1/s: d² in the mean"});
    s.known_limits = {"The jumps' overshoot does not fall with h: nothing but the affine transfer damps it."};
    return s;
  }

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

  GateCount gate_count() const override { return {12, 12}; }
};

PLUMBLINE_CASE(BarRiemannCase);

}  // namespace
}  // namespace plumbline
