// A taut string swings across between two walls.
#include <cmath>
#include <numbers>

#include "cases/catalog/membrane/mode_watch.hpp"
#include "cases/catalog/membrane/string.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/verify/restart_gate.hpp"
#include "reference/string_vibration.hpp"

namespace plumbline::string_vibration {
namespace {

// One struct for points and reference.
struct TautString : Parameters {
  reference::StringVibrationProblem string;
  std::string strain = text(strain_key());

  explicit TautString(Parameters given = {}) : Parameters(std::move(given)) {
    string.youngs_modulus = positive("youngs_modulus", string.youngs_modulus, "Pa", "E of the string");
    string.area = positive("area", string.area, "m^2", "section of the taut string");
    string.density = positive("string_density", string.density, "kg/m^3", "density of the taut string");
    string.strain = within("pretension", string.strain, "1", 0, 0.1, "strain of the taut string");
    string.mode = integer({.name = "mode", .value = 1.0, .low = 1, .high = 100, .description = "number of half waves"});
    string.amplitude = positive("amplitude", 1e-4, "m", "largest displacement");
  }

  // Of the waves along it.
  double wave_speed() const { return std::sqrt(string.youngs_modulus / string.density); }
};

class StringVibrationRun final : public Problem {
 public:
  explicit StringVibrationRun(const Settings& settings)
      : settings_(settings),
        at_(settings_),
        exact_(at_.string),
        state_(displaced()),
        watch_(mode_shape(), 0.0, 1, at_.string.amplitude) {}

  double end_time() const override { return 1.3 * exact_.period().value; }  // past the third zero and a whole period

  Scene scene() const override {
    const reference::StringVibrationProblem& p = at_.string;
    Scene scene;
    scene.grid.dim = 2;
    scene.grid.h = p.length / settings_.number("cells");
    const int beside = cells_beside(scene.grid.h);
    scene.grid.cells = {settings_.integer("cells"), 2 * beside, 1};
    scene.grid.origin = {0, -beside * scene.grid.h, 0};
    scene.grid.walls[0] = {Wall::no_slip, Wall::no_slip};
    scene.grid.walls[1] = {Wall::symmetry, Wall::symmetry};
    scene.bodies.push_back(string_body("string", at_.strain, {p.youngs_modulus, p.area, p.density, true}, state_, 2));
    apply_choices(settings_, scene);
    return scene;
  }

  void observe(const Simulation& simulation) override { watch_.observe(simulation); }
  void history(Archive& archive) override { watch_.history(archive); }
  std::vector<Measure> measures(const Simulation& simulation) const override {
    return watch_.measures(simulation, exact_.kirchhoff_period());
  }
  Profile profile(const Simulation&) const override {
    const double w = exact_.omega().value;
    return watch_.profile("displacement of the mode", "exact displacement of the mode",
                          [&](double t) { return at_.string.amplitude * std::cos(w * t); });
  }

 private:
  StringState displaced() const {
    const reference::StringVibrationProblem& p = at_.string;
    StringState state = straight_string({0, 0}, {p.length, 0}, segment_count(settings_) + 1, p.strain);
    for (auto& place : state.place) place[1] = exact_.displacement(place[0], 0).value;
    return state;
  }

  std::vector<double> mode_shape() const {
    std::vector<double> shape;
    for (const auto& place : state_.place) shape.push_back(place[1] / at_.string.amplitude);
    return shape;
  }

  Settings settings_;
  TautString at_;
  reference::StringVibration exact_;
  StringState state_;
  ModeWatch watch_;
};

// The period's error over T k^2 (h^2/8 + s^2/24).
const Number period_constant = number_at(
    "error of the period over T k^2 (h^2/8 + s^2/24) at 40 cells", "period", 40,
    [](const RunResult& run, const Measure& period) {
      const double k = std::numbers::pi * run.settings.number("mode"), s = run.h / run.settings.number("ppc");
      return Measured::of(period.error / (*period.reference * k * k * (run.h * run.h / 8 + s * s / 24)));
    });

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const std::string study : {"default", "accumulated"}) {
    all.push_back(gate(study + "/period-order", order_of("period"), at_least(1.9),
                       theory("the maps' smoothing is of second order; 0.1 for the interval")));
    all.push_back(gate(study + "/period-constant-40", period_constant, between(0.95, 1.05),
                       theory("k^2 h^2/8 from the maps, k^2 s^2/24 from the spacing of points; the next order is "
                              "(kh)^2, 0.6 %, and the loss of amplitude shifts the zeros by less")));
    all.push_back(
        gate(study + "/loss-order", order_of("amplitude_loss"), at_least(2.8),
             theory("the affine transfer loses (kh)^4 a step, steps follow h: order 3, and 0.2 for the coarse levels "
                    "and the interval")));
  }
  all.push_back(restart_gate("default", "runs of a membrane"));
  return all;
}

Case string_vibration() {
  const std::vector<double> finer{10, 20, 40, 80, 160};
  return {.name = "string-vibration",
          .kind = Kind::membrane,
          .keys = TautString().keys(),
          .sets = {{"cells", 20.0}},
          .york1997 = {york_strain()},
          .york_step =
              [](const Settings& settings) { return york_string_step(settings, TautString(settings).wave_speed()); },
          .problem = run_of<StringVibrationRun>,
          .studies = {study("default", "default", "Order 2.", string_levels).in_full(finer),
                      accumulated_study("Order 2.", string_levels).in_full(finer)},
          .gates = gates(),
          .levels = string_levels};
}
PLUMBLINE_CASE(string_vibration);

}  // namespace
}  // namespace plumbline::string_vibration
