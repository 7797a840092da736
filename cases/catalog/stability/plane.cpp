// An infinite (periodic) elastic plate.
#include <algorithm>
#include <cmath>

#include "cases/catalog/stability/map_scheme.hpp"
#include "cases/catalog/stability/plate_waves.hpp"
#include "cases/harness/laboratory/bar_patch.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

Key place_key(const std::string& name, const std::string& along) {
  return {.name = name,
          .value = 0.5,
          .low = 0,
          .high = 1,
          .low_open = true,
          .high_open = true,
          .description = "place of the points in their shares of a cell along " + along};
}

class Plane final : public StabilityProblem {
 public:
  std::string name() const override { return "plane"; }
  Kind kind() const override { return Kind::solid; }
  std::vector<Key> keys() const override {
    return {{.name = "nu",
             .value = 0.0,
             .low = -1,
             .high = 0.5,
             .low_open = true,
             .high_open = true,
             .description = "Poisson's ratio"},
            place_key("place_x", "x"),
            place_key("place_y", "y")};
  }
  std::vector<Override> choices(const std::string&) const override {
    return {{"shape", "linear"}, {"transfer", "flip"}, {"integrator", "musl"}, {"positions", "frozen"}, {"ppc", 1.0}};
  }
  Patch patch(const Settings& s, const Extent& extent) const override {
    return plate_patch({s.text("shape"), s.text("transfer"), s.integer("transfer_order")}, s.integer("ppc"),
                       s.number("place_x"), s.number("place_y"), s.number("nu"), extent);
  }
  Scan scan(const Settings&) const override { return {.low = 0.3, .high = 3, .steps = 6}; }
  Watch watch(const Settings&) const override { return {.core = 8, .steps = 600, .width = 4e-3, .slowest = 3e-3}; }
  std::optional<ClosedForm> closed_form(const Settings& s) const override {
    const auto scheme = map_scheme(s);
    const std::string& transfer = s.text("transfer");
    if (!scheme || (transfer != "flip" && transfer != "pic")) return std::nullopt;
    return ClosedForm{
        plate_limit(*scheme, {s.integer("ppc"), s.number("place_x"), s.number("place_y")}, s.number("nu")),
        "two by two matrices of the waves on one node a cell"};
  }
  // A matrix of four points has many waves to look at, and a patch with a reach of eight cells many points.
  Prediction predicted(const Settings& settings, const Scan& scan, double width) const override {
    Experiment experiment = experiment_of(*this, settings);
    experiment.least_reach = settings.text("shape") == "linear" ? 3 : 5;
    return predict(experiment, scan, std::max(width, 1e-6));
  }
  bool quickly_listed(bool explicit_step) const override { return explicit_step; }
  std::vector<std::vector<Override>> listed() const override {
    return {{{"place_x", 0.5}, {"place_y", 0.5}},
            {{"place_x", sampled_places.back()}, {"place_y", sampled_places.back()}}};
  }
  // Of one point a cell: more cost too much, and `bar` says what is safe. In space a wave has a third direction: at most half
  // as much stiffness again.
  std::vector<Occurrence> occurrences(const SceneContents& scene) const override {
    std::vector<Occurrence> all;
    if (scene.dim < 2) return all;
    for (const SceneContents::Part& solid : scene.of(SceneContents::Matter::solid)) {
      if (solid.per_cell > 1) continue;
      for (const double place : sampled_places) {
        all.push_back({{{"place_x", place}, {"place_y", place}, {"ppc", 1.0}}, std::sqrt(2.0 / scene.dim)});
      }
    }
    return all;
  }
  std::vector<MapPlan> maps(Tier tier) const override {
    std::vector<MapPlan> all;
    const bool full = tier == Tier::full;
    const std::vector<double> places = full ? std::vector<double>{0.02, 0.14, 0.26, 0.38, 0.5}
                                            : std::vector<double>{0.02, 0.5};
    for (const Method& method : explicit_methods({"linear"}, {"flip"})) {
      if (!full && method.integrator != "musl" && method.integrator != "usl") continue;
      all.push_back({.kind = "limit",
                     .title = "largest stable step, one point a cell",
                     .overrides = method.overrides(),
                     .x = {"place_x", "place of the points in their cells along x", places},
                     .y = {"place_y", "along y", places}});
    }
    return all;
  }
};

PLUMBLINE_STABILITY_PROBLEM(Plane);

}  // namespace
}  // namespace plumbline
