// Two elastic bars end to end, each with a velocity field of its own.
#include <algorithm>
#include <cmath>

#include "cases/catalog/stability/contact_patch.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

ContactPatch choices_of(const Settings& s) {
  ContactPatch patch;
  patch.ppc = s.integer("ppc");
  patch.interface = s.number("interface");
  patch.touching = s.text("side") == "touching";
  return patch;
}

// York's criteria look at the velocities that the step begins with: bars at rest neither touch nor part.
bool asks_velocities(const Settings& s) { return s.text("contact").rfind("york", 0) == 0; }

class ContactProblem final : public StabilityProblem {
 public:
  std::string name() const override { return "contact"; }
  Kind kind() const override { return Kind::solid; }
  bool has_contact() const override { return true; }
  std::vector<Key> keys() const override {
    return {{.name = "side",
             .value = "touching",
             .choices = {"touching", "apart"},
             .description = "on which side of the switch"},
            {.name = "interface",
             .value = 0.5,
             .low = 0,
             .high = 1,
             .high_open = true,
             .description = "where the bars meet in their cell"}};
  }
  std::vector<Override> choices(const std::string&) const override { return {{"positions", "frozen"}}; }
  Patch patch(const Settings& settings, const Extent&) const override {
    Patch patch = choices_of(settings).make();
    apply_choices(settings, patch.scene);
    return patch;
  }
  Scan scan(const Settings&) const override { return {.low = 0.05, .high = 4, .steps = 20}; }
  Prediction predicted(const Settings& settings, const Scan& scan, double width) const override {
    Experiment experiment = experiment_of(*this, settings);
    experiment.patch = [&](const Extent&) {
      ContactPatch choice = choices_of(settings);
      if (asks_velocities(settings)) choice.approach = choice.touching ? 0.01 : -0.01;
      Patch patch = choice.make();
      apply_choices(settings, patch.scene);
      return patch;
    };
    return predict(experiment, scan, width);
  }
  Watch watch(const Settings& settings) const override {
    Watch watch;
    if (asks_velocities(settings)) watch.perturbation = ContactPatch::pressure;
    return watch;
  }
  std::vector<std::vector<Override>> listed() const override { return {{{"side", "touching"}}, {{"side", "apart"}}}; }
  std::vector<Occurrence> occurrences(const SceneContents& scene) const override {
    std::vector<Occurrence> all;
    if (!scene.contact) return all;
    int per_cell = scene.parts.front().per_cell;
    for (const SceneContents::Part& part : scene.parts) per_cell = std::min(per_cell, part.per_cell);
    for (const char* side : {"touching", "apart"}) {
      for (const double place : sampled_places) {
        all.push_back({{{"side", side}, {"interface", place}, {"ppc", 1.0 * per_cell}}, 1 / std::sqrt(scene.dim)});
      }
    }
    return all;
  }
  std::vector<MapPlan> maps(Tier tier) const override {
    const bool full = tier == Tier::full;
    const Axis interface {
      "interface", "where the bars meet in their cell",
          full ? std::vector<double>{0.01, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875} : std::vector<double> {
        0.01, 0.25, 0.5
      }
    };
    std::vector<MapPlan> all;
    for (const char* scheme : {"default", "york1997"}) {
      for (const char* side : {"touching", "apart"}) {
        all.push_back({.kind = "limit",
                       .title = std::string("largest stable step, ") + side,
                       .scheme = scheme,
                       .overrides = {{"side", side}},
                       .x = interface,
                       .y = {"ppc", "points per cell", full ? std::vector<double>{1, 2, 3} : std::vector<double>{2}}});
      }
    }
    return all;
  }
};

PLUMBLINE_STABILITY_PROBLEM(ContactProblem);

}  // namespace
}  // namespace plumbline
