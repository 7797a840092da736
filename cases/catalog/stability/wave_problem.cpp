// A standing wave: orders of integrators behind maps, at a fixed mesh.
#include <cmath>

#include "cases/catalog/stability/orders_in_time.hpp"
#include "cases/harness/laboratory/claims.hpp"
#include "cases/harness/laboratory/problem.hpp"
#include "cases/harness/laboratory/wave.hpp"

namespace plumbline {
namespace {

constexpr int wave_cells = 4;

MapChoice maps_of(const Settings& settings) {
  return {settings.text("shape"), settings.text("transfer"), settings.integer("transfer_order")};
}

class Wave final : public StabilityProblem {
 public:
  std::string name() const override { return "wave"; }
  Kind kind() const override { return Kind::solid; }
  bool compares_integrators() const override { return true; }
  std::vector<Key> keys() const override { return {}; }
  std::vector<Override> choices(const std::string&) const override {
    return {{"shape", "linear"}, {"transfer", "flip"}, {"integrator", "musl"}, {"positions", "frozen"}, {"ppc", 2.0}};
  }
  Patch patch(const Settings& settings, const Extent&) const override {
    Patch patch;
    patch.scene = wave(settings).scene();
    patch.places.emplace_back();
    for (int p = 0; p < patch.scene.bodies[0].points.points(); ++p) patch.places[0].push_back({{}, p});
    return patch;
  }

  std::map<std::string, MeasuredOrder> orders(const Settings& settings) const override {
    if (settings.text("transfer") != "flip") return {};
    const StandingWave bar = wave(settings);
    const IntegratorChoice integrator{settings.text("integrator"), integrator_parameters(settings)};
    const double t = 2.5;  // about a third of a period
    const StandingWave::Amplitudes exact = bar.exact(t);
    const std::size_t points = exact.size() / 2;
    auto orders = orders_in_time({"velocity", "strain"}, t, 48, 6, 1e-14, [&](int steps) -> std::vector<double> {
      const StandingWave::Amplitudes found = bar.stepped(integrator, t, steps);
      double squares[2] = {0, 0};
      for (std::size_t k = 0; k < 2 * points; ++k) squares[k / points] += std::pow(found[k] - exact[k], 2);
      const double n = static_cast<double>(points);
      return {std::sqrt(squares[0] / n), std::sqrt(squares[1] / n)};
    });
    const Claims claims = claims_of(integrator);
    for (auto& [field, order] : orders) order.theory = claimed_order(claims, "fixed mesh", field);
    return orders;
  }

 private:
  static StandingWave wave(const Settings& settings) {
    return {maps_of(settings), wave_cells, settings.integer("ppc")};
  }
};

PLUMBLINE_STABILITY_PROBLEM(Wave);

}  // namespace
}  // namespace plumbline
