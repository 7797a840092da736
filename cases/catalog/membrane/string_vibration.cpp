// A taut string swings across between two walls.
#include <cmath>
#include <numbers>

#include "cases/catalog/membrane/mode_watch.hpp"
#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/description/archive.hpp"
#include "cases/harness/files/whole.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/verify/restart_gate.hpp"
#include "reference/string_vibration.hpp"

namespace plumbline {
namespace {

constexpr double room = 0.4;  // m, to the walls beside the string: two cells and more

reference::StringVibrationProblem string_from(const Settings& s) {
  reference::StringVibrationProblem p;
  p.youngs_modulus = s.number("youngs_modulus");
  p.area = s.number("area");
  p.density = s.number("string_density");
  p.strain = s.number("pretension");
  p.mode = s.integer("mode");
  p.amplitude = s.number("amplitude");
  return p;
}

class StringVibrationCase final : public Problem {
 public:
  explicit StringVibrationCase(const Settings& settings)
      : settings_(settings),
        exact_(string_from(settings)),
        state_(displaced()),
        watch_(mode_shape(), 0.0, 1, exact_.problem().amplitude) {}

  double end_time() const override { return 1.3 * exact_.period().value; }  // past the third zero and a whole period

  Scene scene() const override {
    const reference::StringVibrationProblem& p = exact_.problem();
    Scene scene;
    scene.grid.dim = 2;
    scene.grid.h = p.length / settings_.number("cells");
    const int beside = std::max(2, whole(std::round(room / scene.grid.h)));
    scene.grid.cells = {settings_.integer("cells"), 2 * beside, 1};
    scene.grid.origin = {0, -beside * scene.grid.h, 0};
    scene.grid.walls[0] = {Wall::no_slip, Wall::no_slip};
    scene.grid.walls[1] = {Wall::symmetry, Wall::symmetry};
    scene.bodies.push_back(
        string_body("string", settings_.text("strain"), {p.youngs_modulus, p.area, p.density, true}, state_, 2));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override { watch_.observe(simulation); }
  void history(Archive& archive) override { watch_.history(archive); }

  std::vector<Measure> measures(const Simulation& simulation) const override {
    const reference::Bounded period = exact_.kirchhoff_period();
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
                       {"coordinate", "m", "displacement of the mode", {}},
                       {"coordinate_reference", "m", "exact displacement of the mode", {}}};
    const double w = exact_.omega().value;
    for (const std::size_t k : thinned_rows(watch_.times().size(), 800)) {
      const double t = watch_.times()[k];
      profile.columns[0].values.push_back(t);
      profile.columns[1].values.push_back(watch_.coordinate()[k]);
      profile.columns[2].values.push_back(exact_.problem().amplitude * std::cos(w * t));
    }
    return profile;
  }

 private:
  StringState displaced() const {
    const reference::StringVibrationProblem& p = exact_.problem();
    const int segments = std::max(4, whole(std::round(settings_.number("cells") * settings_.number("ppc"))));
    StringState state = straight_string({0, 0}, {p.length, 0}, segments + 1, p.strain);
    for (auto& place : state.place) place[1] = exact_.displacement(place[0], 0).value;
    return state;
  }

  std::vector<double> mode_shape() const {
    std::vector<double> shape;
    for (const auto& place : state_.place) shape.push_back(place[1] / exact_.problem().amplitude);
    return shape;
  }

  Settings settings_;
  reference::StringVibration exact_;
  StringState state_;
  ModeWatch watch_;
};

class StringVibrationEntry final : public Case {
 public:
  std::string name() const override { return "string-vibration"; }

  Kind kind() const override { return Kind::membrane; }

  std::vector<Key> keys() const override {
    const reference::StringVibrationProblem p;
    return {
        strain_key(),
        positive_key("youngs_modulus", p.youngs_modulus, "Pa", "E of the string"),
        positive_key("area", p.area, "m^2", "section of the taut string"),
        positive_key("string_density", p.density, "kg/m^3", "density of the taut string"),
        {.name = "pretension",
         .value = p.strain,
         .low = 0,
         .high = 0.1,
         .low_open = true,
         .description = "strain of the taut string"},
        {.name = "mode", .value = 1.0, .low = 1, .high = 100, .integer = true, .description = "number of half waves"},
        positive_key("amplitude", 1e-4, "m", "largest displacement")};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override {
    if (scheme == "york1997") return {{"cells", 20.0}, york_strain()};
    return {{"cells", 20.0}};
  }

  void derive(Settings& settings, const std::string& scheme) const override {
    const double speed = std::sqrt(settings.number("youngs_modulus") / settings.number("string_density"));
    york_string_step(settings, scheme, speed);
  }

  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return std::make_unique<StringVibrationCase>(settings);
  }

  std::vector<double> default_levels() const override { return {10, 14, 20, 28, 40}; }

  std::vector<StudyPlan> studies() const override {
    return {{.id = "default",
             .title = "default",
             .why = "Order 2.",
             .values = {10, 14, 20, 28, 40},
             .full_values = {10, 20, 40, 80, 160}},
            {.id = "accumulated",
             .title = "strain summed from rates",
             .why = "Order 2.",
             .overrides = {york_strain()},
             .values = {10, 14, 20, 28, 40},
             .full_values = {10, 20, 40, 80, 160}}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const char* study : {"default", "accumulated"}) {
      const std::string id = study;
      all.push_back(order_gate(study, "period",
                               declare(id + "/period-order", {1.9, {}}, Origin::theory,
                                       "the maps' smoothing is of second order; 0.1 for the interval")));
      all.push_back(constant_gate(id));
      all.push_back(
          order_gate(study, "amplitude_loss",
                     declare(id + "/loss-order", {2.8, {}}, Origin::theory,
                             "the affine transfer loses (kh)^4 a step, steps follow h: order 3, and 0.2 for the "
                             "coarse levels and the interval")));
    }
    all.push_back(restart_gate("default", "runs of a membrane"));
    return all;
  }

 private:
  // The period's error over T k^2 (h^2/8 + s^2/24).
  static CaseGate constant_gate(const std::string& study) {
    CaseGate g = measure_gate(
        study,
        declare(
            study + "/period-constant-40", {0.95, 1.05}, Origin::theory,
            "k^2 h^2/8 from the maps, k^2 s^2/24 from the spacing of points; the next order is (kh)^2, 0.6 %, and the "
            "loss of amplitude shifts the zeros by less"),
        "period", 40, [](const RunResult& run, const Measure& period) {
          const double k = std::numbers::pi * run.settings.number("mode"), s = run.h / run.settings.number("ppc");
          Measured measured;
          measured.value = period.error / (*period.reference * k * k * (run.h * run.h / 8 + s * s / 24));
          return measured;
        });
    g.gate.quantity = "error of the period over T k^2 (h^2/8 + s^2/24) at 40 cells";
    return g;
  }
};

PLUMBLINE_CASE(StringVibrationEntry);

}  // namespace
}  // namespace plumbline
