// An infinite (periodic) gas.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/catalog/stability/gas_patch.hpp"
#include "cases/catalog/stability/map_scheme.hpp"
#include "cases/harness/laboratory/problem.hpp"
#include "reference/bar_stability.hpp"

namespace plumbline {
namespace {

Side side_of(const Settings& s) {
  const std::string& side = s.text("side");
  return side == "both" ? Side::both : side == "closing" ? Side::closing : Side::opening;
}

bool viscous(const Settings& s) {
  return s.number("viscosity") > 0 || (side_of(s) != Side::opening && s.number("viscosity.linear") > 0);
}

class Gas final : public StabilityProblem {
 public:
  std::string name() const override { return "gas"; }
  Kind kind() const override { return Kind::gas; }
  std::vector<Key> keys() const override {
    return {{.name = "dim", .value = 1.0, .low = 1, .high = 2, .integer = true, .description = "a line, or the plane"},
            {.name = "viscosity", .value = 0.0, .low = 0, .high = 1e3, .description = "physical, μ/(ρ c h)"},
            {.name = "side",
             .value = "closing",
             .choices = {"both", "closing", "opening"},
             .description = "of the artificial viscosity's switch: as it is, always on, always off"}};
  }
  std::vector<Override> choices(const std::string& scheme) const override {
    if (scheme == "york1997") return {{"ppc", 3.0}};
    return {};
  }
  Patch patch(const Settings& s, const Extent& extent) const override {
    return gas_patch(
        s,
        {.dim = s.integer("dim"), .offset = s.number("offset"), .viscosity = s.number("viscosity"), .side = side_of(s)},
        extent);
  }
  Scan scan(const Settings& s) const override {
    if (s.integer("dim") == 2) return {.low = 0.1, .high = 2.4, .steps = 5};
    const double nu = s.number("viscosity");
    return {.low = 0.2 / (1 + 4 * nu), .high = 3.9, .steps = 12};
  }
  // Stresses of waves that do not grow rise with the step; at 0.995 of the limit by up to a hundred.
  Watch watch(const Settings&) const override {
    Watch watch;
    watch.steps = 800;
    watch.grown = 1e6;
    watch.grown_slowly = 1e3;
    return watch;
  }
  std::optional<ClosedForm> closed_form(const Settings& s) const override {
    if (s.integer("dim") != 1 || viscous(s) || s.number("sharpening") > 0) return std::nullopt;
    if (s.integer("ppc") != 1 || s.text("shape") != "linear" || s.text("transfer") != "flip") return std::nullopt;
    const auto update = stress_update(s.text("integrator"));
    const double place = std::fmod(s.number("offset") + 0.5, 1.0);
    if (!update || place == 0) return std::nullopt;
    return ClosedForm{reference::frozen_courant_limit(*update, place).value * std::sqrt(gas_gamma / (gas_gamma - 1)),
                      "reference bar-stability over the speed of a gas whose points' pushes follow their energy alone"};
  }
  std::vector<std::vector<Override>> listed() const override { return {{{"ppc", 4.0}, {"offset", 0.0}}}; }
  // On a line; each further direction adds at most the same stiffness once more, and the same viscosity. A run's step is
  // bounded by its viscosity, too.
  std::vector<Occurrence> occurrences(const SceneContents& scene) const override {
    std::vector<Occurrence> all;
    for (const SceneContents::Part& gas : scene.of(SceneContents::Matter::gas)) {
      // Cold gas has no speed, and neither viscosity nor scale of it.
      const double diffusion = gas.diffusivity > 0 ? gas.diffusivity / (gas.speed * scene.h) : 0;
      const double bound = std::max(1.0, 2 * scene.dim * diffusion);
      const double factor = diffusion > 0 ? bound / scene.dim : 1 / std::sqrt(scene.dim);
      for (const double place : sampled_places) {
        const double offset = std::fmod(place + 0.5, 1.0) / gas.per_cell;  // regular where none
        all.push_back(
            {{{"dim", 1.0}, {"offset", offset}, {"ppc", 1.0 * gas.per_cell}, {"viscosity", 0.75 * diffusion}}, factor});
      }
    }
    return all;
  }
  std::vector<MapPlan> maps(Tier tier) const override {
    const bool full = tier == Tier::full;
    std::vector<MapPlan> all;
    for (const std::string scheme : {"default", "york1997"}) {
      all.push_back(
          {.kind = "limit",
           .title = "largest stable step",
           .scheme = scheme,
           .x = {"offset", "shift of the lattice, cells", evenly_spaced(0.01, 0.31, full ? 9 : 4)},
           .y = {"ppc", "points per cell", full ? std::vector<double>{1, 2, 3, 4, 8} : std::vector<double>{2, 3}}});
      all.push_back(
          {.kind = "growth",
           .title = "spectral radius",
           .scheme = scheme,
           .x = {"theta", "wave number", evenly_spaced(std::numbers::pi / 20, std::numbers::pi, full ? 40 : 20)},
           .y = {"dt", "step", evenly_spaced(0.2, 3.2, full ? 30 : 11)}});
      if (!full) continue;
      all.push_back({.kind = "limit",
                     .title = "largest stable step, with physical viscosity",
                     .scheme = scheme,
                     .overrides = {{"side", "opening"}},
                     .x = {"viscosity", "μ/(ρ c h)", {0, 0.03, 0.1, 0.3, 1, 3, 10}},
                     .y = {"offset", "shift of the lattice, cells", {0.01, 0.11, 0.21, 0.31}}});
    }
    return all;
  }
};

PLUMBLINE_STABILITY_PROBLEM(Gas);

}  // namespace
}  // namespace plumbline
