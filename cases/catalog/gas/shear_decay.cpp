// A shear flow that its own viscosity brings to rest.
#include "reference/shear_decay.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/gas_problem.hpp"

namespace plumbline {
namespace {

// Rigid ends at y = 0 and y = height hold the sliding gas up; what they send comes with the speed of sound, 1.19 m/s,
// by 0.24 m until the end, spread by viscosity over sqrt(4/3 nu t) = 0.2 m. Judged is a strip in the middle, 1.4 m from
// either end: the front of the sound, and five of those lengths beyond it.
constexpr double height = 3, half_strip = 0.1;  // m

reference::ShearDecayProblem shear_of(const Settings& settings) {
  reference::ShearDecayProblem shear;
  shear.amplitude = settings.number("amplitude");
  shear.wavenumber = std::numbers::pi;
  shear.viscosity = settings.number("viscosity");
  return shear;
}

class ShearDecayCase final : public Case {
 public:
  std::string name() const override { return "shear-decay"; }

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
    std::vector<CaseGate> all = required_order(
        "default", "velocity.L1", 1.8, "smooth flow allows 2; 0.2 for the coarsest mesh, as of the sound pulse");
    all.push_back(energy_gate("default"));
    return all;
  }
};

PLUMBLINE_CASE(ShearDecayCase);

}  // namespace
}  // namespace plumbline
