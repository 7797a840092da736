// A heavy chain hangs from the top wall and swings in its first mode.
#include <cmath>

#include "cases/harness/archive.hpp"
#include "cases/harness/gates.hpp"
#include "cases/harness/whole.hpp"
#include "cases/membrane/mode_watch.hpp"
#include "cases/membrane/string.hpp"
#include "reference/hanging_chain.hpp"

namespace plumbline {
namespace {

constexpr double room = 0.4;  // m, to the walls beside and below the chain: two cells and more

constexpr const char* sketch =
    R"svg(<svg viewBox="0 0 360 160" role="img" aria-label="A chain hanging from a wall in its first mode, the free end swings most">
<g fill="none" stroke="currentColor" stroke-width="1.5"><path d="M120 14h120"/><path d="M130 14l6-7m20 7l6-7m20 7l6-7m20 7l6-7m20 7l6-7"/><path d="M180 14v132" stroke-dasharray="4 4" stroke-width="1"/><path d="M180 14c6 50 20 90 52 132"/><path d="M180 14c-6 50-20 90-52 132" stroke-dasharray="2 4" stroke-width="1"/></g>
<g fill="currentColor"><circle cx="180" cy="14" r="2.5"/><circle cx="184" cy="40" r="2.5"/><circle cx="190" cy="66" r="2.5"/><circle cx="200" cy="93" r="2.5"/><circle cx="213" cy="120" r="2.5"/><circle cx="232" cy="146" r="2.5"/><g font-size="12"><text x="246" y="150">A</text><text x="250" y="80">T = ρ g s</text><text x="60" y="80">g ↓</text></g></g></svg>)svg";

class HangingChainProblemRun final : public Problem {
 public:
  explicit HangingChainProblemRun(const Settings& settings)
      : settings_(settings),
        exact_(chain_from(settings)),
        state_(displaced()),
        watch_(mode_shape(), 0.0, 0, exact_.problem().amplitude) {}

  double end_time() const override { return 1.3 * exact_.period().value; }  // past the third zero and a whole period

  Scene scene() const override {
    const reference::HangingChainProblem& p = exact_.problem();
    Scene scene;
    scene.grid.dim = 2;
    const double h = scene.grid.h = p.length / settings_.number("cells");
    const int beside = std::max(2, whole(std::round(room / h)));
    scene.grid.cells = {2 * beside, settings_.integer("cells") + beside, 1};
    scene.grid.origin = {-beside * h, -beside * h, 0};
    scene.grid.walls[0] = {Wall::symmetry, Wall::symmetry};
    scene.grid.walls[1] = {Wall::symmetry, Wall::no_slip};
    scene.gravity[1] = -p.gravity;
    const double youngs_modulus = p.line_density * p.gravity * p.length / settings_.number("stretch");
    scene.bodies.push_back(
        string_body("chain", settings_.text("strain"), {youngs_modulus, 1, p.line_density, true}, state_, 2));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override { watch_.observe(simulation); }
  void history(Archive& archive) override { watch_.history(archive); }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const reference::Bounded period = exact_.period();
    const auto ratio = [](const char* name, double value) {
      Measure m = scalar_measure(name, value, 0, 0, "1");
      m.scale = 1;
      return m;
    };
    const double none = std::nan("");
    return {scalar_measure("period", watch_.period().value_or(none), period.value, period.bound, "s"),
            ratio("amplitude_loss", watch_.amplitude_loss().value_or(none)), ratio("impurity", watch_.impurity()),
            ratio("energy_drift", energy_drift(simulation.ledger().energy))};
  }

  Profile profile(const Simulation&) const override {
    Profile profile;
    profile.kind = "history";
    profile.abscissa = "time";
    profile.columns = {{"time", "s", "time", {}},
                       {"coordinate", "m", "displacement of the mode at the free end", {}},
                       {"coordinate_reference", "m", "exact displacement of the free end", {}}};
    for (const std::size_t k : thinned_rows(watch_.times().size(), 800)) {
      const double t = watch_.times()[k];
      profile.columns[0].values.push_back(t);
      profile.columns[1].values.push_back(watch_.coordinate()[k]);
      profile.columns[2].values.push_back(exact_.displacement(0, t).value);
    }
    return profile;
  }

 private:
  static reference::HangingChainProblem chain_from(const Settings& s) {
    reference::HangingChainProblem p;
    p.gravity = s.number("gravity");
    p.line_density = s.number("line_density");
    p.mode = s.integer("mode");
    p.amplitude = s.number("amplitude");
    return p;
  }

  // From the support down. The chain is stretched by its own weight already: points stand evenly, with the strain that
  // carries what hangs below them, so that the tension is ρ g s exactly whatever the stiffness.
  StringState displaced() const {
    const double length = exact_.problem().length, stretch = settings_.number("stretch");
    const int segments = std::max(4, whole(std::round(settings_.number("cells") * settings_.number("ppc"))));
    StringState state = straight_string({0, length}, {0, 0}, segments + 1);
    for (std::size_t p = 0; p < state.place.size(); ++p) {
      const double s = state.place[p][1];
      state.place[p][0] = exact_.displacement(s, 0).value;
      state.strain[p] = stretch * s / length;
      if (p > 0) state.segment_strain[p - 1] = 0.5 * (state.strain[p - 1] + state.strain[p]);
    }
    return state;
  }

  std::vector<double> mode_shape() const {
    std::vector<double> shape;
    for (const auto& place : state_.place) shape.push_back(exact_.shape(place[1]).value);
    return shape;
  }

  Settings settings_;
  reference::HangingChain exact_;
  StringState state_;
  ModeWatch watch_;
};

class HangingChainCase final : public Case {
 public:
  Statement statement() const override {
    Statement s;
    s.name = "hanging-chain";
    s.title = "Small swing of a heavy hanging chain";
    s.source = "D. Bernoulli 1733; H. Lamb, Hydrodynamics, 6th ed., article 195";
    s.claim = "A chain whose tension falls to nothing at its free end swings with the period of its Bessel mode.";
    s.physics =
        "A heavy chain of membrane points hangs from the top wall. Its tension is the weight of what hangs below: ρ g "
        "L at "
        "the support and zero at the free end, where the wave speed vanishes, too. Released from rest in the shape of "
        "its "
        "first mode, with an amplitude of a thousandth of its length, it swings.\n\n"
        "The chain starts in the balance of its own weight: strain at the support is `stretch`, points stand evenly "
        "and "
        "weigh the same, so the tension is exact whatever the stiffness.";
    s.equations = {"y_tt = g (s y_s)_s,  s from the free end", "y = A J₀(2ω√(s/g)) cos ωt",
                   "J₀(2ω√(L/g)) = 0:  ω = ½ j₀₁ √(g/L) = 3.7661 rad/s"};
    s.sketch = sketch;
    s.cells_along = "the chain's length of 1 m";
    s.reference_name = "hanging-chain";
    s.reference_text = "Closed form with the zeros of J0 by GSL.";
    s.reference_bound = "Computed: rounding and the zeros' own bound.";
    s.theory_orders = {{"period", 2, "the maps smooth force and motion by the share k²h²/8 each"}};
    s.known_limits = {"At the free end the kernel is half empty: light nodes move there with the last point."};
    return s;
  }

  Kind kind() const override { return Kind::membrane; }

  std::vector<Key> keys() const override {
    const reference::HangingChainProblem p;
    return {strain_key(),
            positive_key("gravity", p.gravity, "m/s^2", "gravity"),
            positive_key("line_density", p.line_density, "kg/m", "mass per length"),
            {.name = "stretch",
             .value = 1e-3,
             .low = 0,
             .high = 0.1,
             .low_open = true,
             .description = "strain at the support by the chain's weight: its stiffness"},
            {.name = "mode", .value = 1.0, .low = 1, .high = 20, .integer = true, .description = "of the swing"},
            positive_key("amplitude", 1e-3, "m", "of the free end")};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override {
    if (scheme == "york1997") return {{"cells", 20.0}, york_strain()};
    return {{"cells", 20.0}};
  }

  void derive(Settings& settings, const std::string& scheme) const override {
    const double speed = std::sqrt(settings.number("gravity") / settings.number("stretch"));
    york_string_step(settings, scheme, speed);
  }

  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return std::make_unique<HangingChainProblemRun>(settings);
  }

  std::vector<double> default_levels() const override { return {10, 14, 20, 28, 40}; }

  std::vector<StudyPlan> studies() const override {
    return {{.id = "default",
             .title = "default",
             .why = "Order 2.",
             .values = {10, 14, 20, 28, 40},
             .full_values = {10, 14, 20, 28, 40, 56, 80}},
            {.id = "accumulated",
             .title = "strain summed from rates",
             .why = "Order 2.",
             .overrides = {york_strain()},
             .values = {20},
             .full_values = {10, 14, 20, 28, 40}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const char* study : {"default", "accumulated"}) {
      const std::string id = study;
      const Tier orders = id == "default" ? Tier::quick : Tier::full;
      all.push_back(error_gate(study, "period", 20,
                               declare(id + "/period-20", {{}, 0.002 * reference::HangingChain({}).period().value},
                                       Origin::target, "within 0.2 % at twenty cells a length")));
      all.push_back(
          order_gate(study, "period",
                     declare(id + "/period-order", {1.8, {}}, Origin::theory,
                             "the maps' smoothing is of second order; 0.2 for the free end, where the kernel is "
                             "half empty, and the interval"),
                     orders));
      all.push_back(
          order_gate(study, "amplitude_loss",
                     declare(id + "/loss-order", {2.5, {}}, Origin::theory,
                             "the affine transfer loses (kh)^4 a step, steps follow h: order 3; 0.5 for the free "
                             "end, the coarse levels and the interval"),
                     orders));
    }
    return all;
  }

  GateCount gate_count() const override { return {14, 16}; }
};

PLUMBLINE_CASE(HangingChainCase);

}  // namespace
}  // namespace plumbline
