// A mass on a spring: what a time integrator alone bears.
#include <cmath>

#include "cases/laboratory/problem.hpp"
#include "cases/stability/orders_in_time.hpp"
#include "cases/stability/oscillator.hpp"
#include "reference/oscillator_limits.hpp"

namespace plumbline {
namespace {

using reference::OscillatorMethod;

IntegratorChoice integrator_of(const Settings& settings) {
  return {settings.text("integrator"), integrator_parameters(settings)};
}

// What an integrator is when no maps filter velocities: which two velocities a strain is made of, and when.
std::optional<OscillatorMethod> method_of(const std::string& integrator) {
  static const std::map<std::string, OscillatorMethod> methods{
      {"usf", OscillatorMethod::symplectic_euler},
      {"usl", OscillatorMethod::symplectic_euler},
      {"musl", OscillatorMethod::symplectic_euler},
      {"usavg", OscillatorMethod::leapfrog},
      {"leapfrog", OscillatorMethod::leapfrog},
      {"central-difference", OscillatorMethod::leapfrog},
      {"ssp-rk3", OscillatorMethod::ssp_rk3},
      {"rk4", OscillatorMethod::rk4},
      {"implicit-midpoint", OscillatorMethod::newmark_trapezoid},
      {"generalized-alpha", OscillatorMethod::generalized_alpha},
  };
  const auto found = methods.find(integrator);
  return found == methods.end() ? std::nullopt : std::optional(found->second);
}

class OscillatorProblem final : public StabilityProblem {
 public:
  ProblemStatement statement() const override {
    return {
        .name = "oscillator",
        .title = "A mass on a spring",
        .source =
            "kernel/README.md, \"Integrators of the laboratory\"; generalized-alpha: Hulbert, Chung 1996, doi "
            "10.1016/S0045-7825(96)01036-5",
        .statement =
            "One point whose strain is its displacement, and a node that always has the point's velocity: what an "
            "integrator does before any map between points and grid takes part. Steps are in units of 1/ω. The "
            "matrix of a step is found by stepping unit states, what the integrator remembers among them.",
        .equations = {"u″ = −ω² u − 2 ζ ω u′",
                      "usf, usl, musl, usavg, leapfrog, central-difference, midpoint: ω Δt = 2", "ssp-rk3: ω Δt = √3",
                      "rk4: ω Δt = √8", "generalized-alpha: ω Δt = √(12 (1 + ρ) (2 − ρ) / (10 − 5ρ + ρ²))",
                      "implicit-midpoint: none", "energy: grows by √(1 + (ω Δt)²/2) at every step"},
        .sampled = "every state of one oscillator"};
  }
  Kind kind() const override { return Kind::membrane; }
  bool compares_integrators() const override { return true; }
  bool has_grid() const override { return false; }
  std::vector<Key> keys() const override {
    return {
        {.name = "damping", .value = 0.0, .low = 0, .high = 10, .description = "ratio ζ of the damper; 1: critical"}};
  }
  std::vector<Override> choices(const std::string&) const override { return {{"integrator", "musl"}}; }
  Scan scan(const Settings&) const override { return {0.1, 8, 64}; }
  std::string unit() const override { return "1/omega"; }
  std::vector<std::vector<Override>> concessions() const override { return {}; }
  bool quickly_listed(bool) const override { return true; }
  std::vector<std::vector<Override>> listed() const override { return {{}}; }

  std::optional<ClosedForm> closed_form(const Settings& settings) const override {
    if (settings.number("damping") != 0) return std::nullopt;
    const std::string& integrator = settings.text("integrator");
    if (integrator == "energy") return ClosedForm{0, "kernel/README.md, \"The energy-conserving step\""};
    if (integrator == "midpoint") return ClosedForm{2, "kernel/README.md, \"Midpoint\""};
    const auto method = method_of(integrator);
    if (!method) return std::nullopt;
    const double rho_b = *method == OscillatorMethod::generalized_alpha ? settings.number("rho_b") : 1;
    const double limit = reference::oscillator_limit(*method, rho_b).value;
    return ClosedForm{limit, "reference oscillator-limits"};
  }

  Prediction predicted(const Settings& settings, const Scan& scan, double width) const override {
    const IntegratorChoice integrator = integrator_of(settings);
    const double damping = settings.number("damping");
    Prediction prediction = predict(
        [&](double dt, const std::vector<WaveNumber>&) -> Growth {
          return {dt, spectral_radius(step_matrix(integrator, damping, dt)), {}};
        },
        scan, width);
    prediction.unknowns = static_cast<int>(step_matrix(integrator, damping, 1).rows());
    return prediction;
  }

  Observation observed(const Settings& settings, int) const override {
    const IntegratorChoice integrator = integrator_of(settings);
    const Watch how = watch(settings);
    return observe([&](double dt) { return run_oscillator(integrator, settings.number("damping"), how, dt); },
                   scan(settings), how);
  }

  std::map<std::string, MeasuredOrder> orders(const Settings& settings) const override {
    const IntegratorChoice integrator = integrator_of(settings);
    const double damping = settings.number("damping"), t = 2;
    // From both unit states: of one alone, errors of phase or of size may vanish at the end by chance.
    auto orders = orders_in_time({"displacement", "velocity"}, t, 32, 5, 1e-15, [&](int steps) -> std::vector<double> {
      Eigen::Matrix2d off;
      for (int k = 0; k < 2; ++k) {
        const Eigen::Vector2d start = Eigen::Vector2d::Unit(k);
        off.col(k) = oscillation(integrator, damping, start, t, steps) - exact_oscillation(damping, start, t);
      }
      return {off.row(0).norm(), off.row(1).norm()};
    });
    if (const auto theory = orders_on_oscillator(integrator.name)) {
      orders["displacement"].theory = theory->displacement;
      orders["velocity"].theory = theory->velocity;
    }
    return orders;
  }
};

PLUMBLINE_STABILITY_PROBLEM(OscillatorProblem);

}  // namespace
}  // namespace plumbline
