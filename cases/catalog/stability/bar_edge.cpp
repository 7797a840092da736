// The free end of an elastic bar.
#include <cmath>
#include <span>

#include "cases/catalog/stability/map_scheme.hpp"
#include "cases/harness/laboratory/bar_patch.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

std::vector<double> falling(double from, double ratio, int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) all.push_back(from * std::pow(ratio, k));
  return {all.rbegin(), all.rend()};
}

class BarEdge final : public StabilityProblem {
 public:
  std::string name() const override { return "bar-edge"; }
  Kind kind() const override { return Kind::solid; }
  bool compares_integrators() const override { return true; }
  std::vector<Key> keys() const override {
    return {{.name = "depth",
             .value = 0.25,
             .low = 0,
             .high = 1,
             .low_open = true,
             .description = "of the last point in its cell, in cells"},
            {.name = "length",
             .value = 16.0,
             .low = 2,
             .high = 200,
             .integer = true,
             .description = "of the bar, in cells"},
            {.name = "far_end",
             .value = "wall",
             .choices = {"wall", "free"},
             .description = "the other end: on a plane of symmetry, or free, too"}};
  }
  std::vector<Override> choices(const std::string&) const override {
    return {{"shape", "linear"}, {"transfer", "flip"}, {"integrator", "musl"}, {"positions", "frozen"}, {"ppc", 2.0}};
  }
  Patch patch(const Settings& settings, const Extent&) const override {
    return bar_edge_patch({settings.text("shape"), settings.text("transfer"), settings.integer("transfer_order")},
                          settings.integer("ppc"), settings.number("depth"), settings.integer("length"),
                          settings.text("far_end") == "wall" ? FarEnd::wall : FarEnd::free);
  }
  std::optional<ClosedForm> closed_form(const Settings& s) const override {
    const auto scheme = map_scheme(s);
    if (!scheme) return std::nullopt;
    const Patch bar = patch(s, {});
    const std::span<const double> places = bar.scene.bodies[0].points.values(column::position);
    const std::vector<double> points(places.begin(), places.end());
    const double spacing = 1.0 / s.integer("ppc");
    const reference::Bounded limit = s.text("far_end") == "wall"
                                         ? reference::leaning_bar_courant_limit(*scheme, points, spacing)
                                         : reference::free_bar_courant_limit(*scheme, points, spacing);
    return ClosedForm{limit.value, "largest eigenvalue of a symmetric matrix, reference/mpm_amplification.hpp"};
  }
  // A strain that no velocity has made throws the light node beyond the end about by its share over its mass, once.
  Watch watch(const Settings& s) const override {
    Watch watch;
    watch.grown /= s.number("depth");
    watch.grown_slowly /= s.number("depth");
    return watch;
  }
  Scan scan(const Settings&) const override { return {.low = 1e-3, .high = 4, .steps = 36}; }
  std::vector<std::vector<Override>> listed() const override { return {{{"depth", 0.25}}, {{"depth", shallow}}}; }
  // An edge of any matter: a gas pushes no harder on the light node than a bar of its speed of sound does. A wave along
  // each direction adds at most the same stiffness once more.
  std::vector<Occurrence> occurrences(const SceneContents& scene) const override {
    std::vector<Occurrence> all;
    for (const SceneContents::Part& part : scene.parts) {
      for (const double depth :
           part.free_edge ? std::vector<double>{0.6 / part.per_cell, shallow} : std::vector<double>{}) {
        all.push_back({{{"depth", depth}, {"ppc", 1.0 * part.per_cell}, {"length", 6.0}}, 1 / std::sqrt(scene.dim)});
      }
    }
    return all;
  }
  std::vector<MapPlan> maps(Tier tier) const override {
    std::vector<MapPlan> all;
    const bool full = tier == Tier::full;
    for (const Method& method : explicit_methods(full ? std::vector<std::string>{"linear", "gimp", "quadratic", "cubic"}
                                                      : std::vector<std::string>{"linear", "quadratic"},
                                                 {"flip"})) {
      std::vector<Override> overrides = method.overrides();
      if (!full) overrides.emplace_back("length", 6.0);  // the mode that is lost first sits at the end
      all.push_back({.kind = "limit",
                     .title = "largest stable step",
                     .overrides = std::move(overrides),
                     .x = {"depth", "depth of the last point in its cell", falling(1, 0.25, full ? 6 : 4)},
                     .y = {"ppc", "points per cell", full ? std::vector<double>{1, 2, 3} : std::vector<double>{1, 2}}});
    }
    return all;
  }

 private:
  static constexpr double shallow = 0.01;  // depth of a point that has hardly entered its cell
};

PLUMBLINE_STABILITY_PROBLEM(BarEdge);

}  // namespace
}  // namespace plumbline
