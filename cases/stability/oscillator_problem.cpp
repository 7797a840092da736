// A mass on a spring: what a time integrator alone bears.
#include <cmath>

#include "cases/laboratory/claims.hpp"
#include "cases/laboratory/problem.hpp"
#include "cases/stability/orders_in_time.hpp"
#include "cases/stability/oscillator.hpp"

namespace plumbline {
namespace {

IntegratorChoice integrator_of(const Settings& settings) {
  return {settings.text("integrator"), integrator_parameters(settings)};
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
    const std::optional<double> limit = claims_of(integrator_of(settings)).limit;
    if (!limit) return std::nullopt;
    return ClosedForm{*limit, "claimed by the integrator"};
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
    const Claims claims = claims_of(integrator);
    for (auto& [field, order] : orders) order.theory = claimed_order(claims, "oscillator", field);
    return orders;
  }
};

PLUMBLINE_STABILITY_PROBLEM(OscillatorProblem);

}  // namespace
}  // namespace plumbline
