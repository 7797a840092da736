// An infinite (periodic) elastic bar.
#include <cmath>
#include <numbers>

#include "cases/catalog/stability/map_scheme.hpp"
#include "cases/harness/laboratory/bar_patch.hpp"
#include "cases/harness/laboratory/problem.hpp"
#include "reference/bar_stability.hpp"

namespace plumbline {
namespace {

class Bar final : public StabilityProblem {
 public:
  std::string name() const override { return "bar"; }
  Kind kind() const override { return Kind::solid; }
  bool compares_integrators() const override { return true; }
  std::vector<Key> keys() const override {
    return {{.name = "N",
             .value = 0.5,
             .low = 0,
             .high = 1,
             .low_open = true,
             .high_open = true,
             .description = "place of the points in their shares of a cell; with one point a cell its local weight"}};
  }
  std::vector<Override> choices(const std::string&) const override {
    return {{"shape", "linear"}, {"transfer", "flip"}, {"integrator", "musl"}, {"positions", "frozen"}, {"ppc", 1.0}};
  }
  Patch patch(const Settings& settings, const Extent& extent) const override {
    return bar_patch({settings.text("shape"), settings.text("transfer"), settings.integer("transfer_order")},
                     settings.integer("ppc"), settings.number("N"), extent);
  }
  std::optional<ClosedForm> closed_form(const Settings& s) const override {
    if (s.integer("ppc") != 1 || s.text("shape") != "linear" || s.text("transfer") != "flip") return std::nullopt;
    if (s.text("positions") != "frozen") return std::nullopt;
    const auto update = stress_update(s.text("integrator"));
    if (!update) return std::nullopt;
    return ClosedForm{reference::frozen_courant_limit(*update, s.number("N")).value,
                      "reference bar-stability, York 1997 chapter 8"};
  }
  bool quickly_listed(bool) const override { return true; }
  std::vector<std::vector<Override>> listed() const override { return {{{"N", 0.5}}, {{"N", sampled_places.back()}}}; }
  // In the plane and in space `plane` says what waves in several directions do, where there is one point a cell. With more
  // that costs too much: each further direction adds at most the same stiffness once more.
  std::vector<Occurrence> occurrences(const SceneContents& scene) const override {
    std::vector<Occurrence> all;
    for (const SceneContents::Part& solid : scene.of(SceneContents::Matter::solid)) {
      if (scene.dim > 1 && solid.per_cell == 1) continue;
      for (const double place : sampled_places) {
        all.push_back({{{"N", place}, {"ppc", 1.0 * solid.per_cell}}, 1 / std::sqrt(scene.dim)});
      }
    }
    return all;
  }
  std::vector<MapPlan> maps(Tier tier) const override {
    const bool full = tier == Tier::full;
    const std::vector<std::string> shapes = full ? std::vector<std::string>{"linear", "gimp", "quadratic", "cubic"}
                                                 : std::vector<std::string>{"linear", "quadratic"};
    std::vector<MapPlan> all;
    for (const Method& method : explicit_methods(shapes, {"flip", "apic"})) {  // the table of safe steps has the others
      // A lattice at N is the mirror image of one at 1 - N.
      all.push_back({.kind = "limit",
                     .title = "largest stable step",
                     .overrides = method.overrides(),
                     .x = {"N", "place of the points in their share of a cell", evenly_spaced(0.02, 0.5, full ? 9 : 5)},
                     .y = {"ppc", "points per cell", full ? points_many : points_few}});
      all.push_back(
          {.kind = "growth",
           .title = "spectral radius",
           .overrides = method.overrides(),
           .x = {"theta", "wave number", evenly_spaced(std::numbers::pi / 40, std::numbers::pi, full ? 24 : 12)},
           .y = {"dt", "step", evenly_spaced(0.1, 3, full ? 20 : 10)}});
      if (full) all[all.size() - 2].observe = {{0.02, 1}, {0.26, 1}, {0.5, 1}, {0.5, 2}};
    }
    return all;
  }

 private:
  inline static const std::vector<double> points_few{1, 2}, points_many{1, 2, 3, 4};
};

PLUMBLINE_STABILITY_PROBLEM(Bar);

}  // namespace
}  // namespace plumbline
