// A mass on a spring: the stability limit of a time integrator alone.
#include <cmath>

#include "cases/catalog/stability/orders_in_time.hpp"
#include "cases/harness/laboratory/claims.hpp"
#include "cases/harness/laboratory/matrices.hpp"
#include "cases/harness/laboratory/oscillator.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

IntegratorChoice integrator_of(const Settings& settings) {
  return {settings.text("integrator"), integrator_parameters(settings)};
}

class OscillatorProblem final : public StabilityProblem {
 public:
  std::string name() const override { return "oscillator"; }
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
