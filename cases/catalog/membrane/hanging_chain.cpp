// A heavy chain hangs from the top wall and swings in its first mode.
#include <cmath>

#include "cases/catalog/membrane/mode_watch.hpp"
#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "reference/hanging_chain.hpp"

namespace plumbline {
namespace {

constexpr double room = 0.4;  // m, to the walls beside and below the chain: two cells and more

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
  std::string name() const override { return "hanging-chain"; }

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
      all.push_back(error_gate(
          study, "period", 20,
          declare(id + "/period-20", {{}, 0.002 * reference::HangingChain({}).period().value}, Origin::requirement,
                  "within 0.2 % at twenty cells a length; a rigid rod's period is 1.8 % shorter")));
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
};

PLUMBLINE_CASE(HangingChainCase);

}  // namespace
}  // namespace plumbline
