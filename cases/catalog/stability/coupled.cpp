// Gas and a membrane on shared nodes.
#include <algorithm>
#include <cmath>

#include "cases/catalog/stability/coupled_patch.hpp"
#include "cases/catalog/stability/fast_growth.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

class Coupled final : public StabilityProblem {
 public:
  std::string name() const override { return "coupled"; }
  Kind kind() const override { return Kind::coupled; }
  std::vector<Key> keys() const override {
    return {
        {.name = "dim",
         .value = 1.0,
         .low = 1,
         .high = 2,
         .integer = true,
         .description = "a layer of gas h high along the membrane, or a box that it divides"},
        positive_key("density_ratio", 1, "1", "m_s/(rho h), m_s the membrane's mass per area"),
        positive_key("stiffness_ratio", 1, "1", "E t/(rho c^2 h), E t the membrane's tension per strain"),
        {.name = "place",
         .value = 0.5,
         .low = 0,
         .high = 1,
         .low_open = true,
         .high_open = true,
         .description = "height of the membrane in its cell, in cells; on a line, of its points in their shares"},
        {.name = "width", .value = 2.0, .low = 2, .high = 20, .integer = true, .description = "of the box, in cells"},
        {.name = "height", .value = 3.0, .low = 2, .high = 20, .integer = true, .description = "of the box, in cells"},
        {.name = "slow",
         .value = 0.05,
         .unit = "c/h",
         .low = 0,
         .high = 10,
         .description = "in the box, growth per time that is no matter of the step, and not counted"}};
  }
  std::vector<Override> choices(const std::string& scheme) const override {
    std::vector<Override> chosen{{"ppc", 4.0}, {"membrane.ppc", 2.0}};
    if (scheme == "default") chosen.push_back({"membrane.strain", "segments"});
    if (scheme == "york1997") chosen.push_back({"positions", "frozen"});
    return chosen;
  }
  Patch patch(const Settings& s, const Extent& extent) const override {
    const CoupledCell cell{.place = s.number("place"),
                           .density_ratio = s.number("density_ratio"),
                           .stiffness_ratio = s.number("stiffness_ratio")};
    if (s.integer("dim") == 1) return coupled_line_patch(s, cell, extent);
    return coupled_box_patch(s, cell, s.integer("width"), s.integer("height"));
  }
  // Relative to the speed of long waves along the membrane, all of the gas moving with it.
  Scan scan(const Settings& s) const override {
    const double speed = std::sqrt((1 + s.number("stiffness_ratio")) / (1 + s.number("density_ratio")));
    if (s.integer("dim") == 1) return {0.4 / speed, 4 / speed, 12};
    return {0.3 / std::max(speed, 1.0), 4 / std::max(speed, 0.8), 8};
  }
  Watch watch(const Settings& s) const override {
    if (s.integer("dim") == 2) return watch_beside(s.number("slow"), scan(s));
    Watch watch;
    watch.steps = 1000;
    // A velocity makes stresses of its size times the root of the stiffness.
    const double stresses = std::sqrt(1 + s.number("stiffness_ratio"));
    watch.grown = 1e6 * stresses;
    watch.grown_slowly = 1e3 * stresses;
    return watch;
  }
  Prediction predicted(const Settings& s, const Scan& scan, double width) const override {
    if (s.integer("dim") == 1) return StabilityProblem::predicted(s, scan, width);
    return predict_beside(s.number("slow"), experiment_of(*this, s), scan, width);
  }
  std::vector<std::vector<Override>> listed() const override {
    return {{{"density_ratio", 1.0}, {"stiffness_ratio", 1.0}}};
  }
  std::vector<std::vector<Override>> concessions() const override {
    return {{{"membrane.loss", "booked"}}, {{"transfer", "flip"}, {"membrane.loss", "booked"}}};
  }
  // Of gas and membrane; c is the gas's.
  double fastest(const Settings& s) const override {
    return std::sqrt(std::max(1.0, s.number("stiffness_ratio") / s.number("density_ratio")));
  }
  // Along the membrane.
  std::vector<Occurrence> occurrences(const SceneContents& scene) const override {
    std::vector<Occurrence> all;
    for (const SceneContents::Coupling& found : scene.couplings) {
      for (const double place : sampled_places) {
        all.push_back({{{"ppc", 1.0 * found.gas.per_cell},
                        {"membrane.ppc", 1.0 * found.chain.per_cell},
                        {"membrane.strain", found.chain.segments ? "segments" : "accumulated"},
                        {"density_ratio", found.density_ratio},
                        {"stiffness_ratio", found.stiffness_ratio},
                        {"place", place}},
                       1 / std::sqrt(scene.dim)});
      }
    }
    return all;
  }
  std::vector<MapPlan> maps(Tier tier) const override {
    const bool full = tier == Tier::full;
    const Axis masses{"density_ratio", "m_s/(ρ h)",
                      full ? std::vector<double>{0.01, 0.1, 1, 10, 100} : std::vector<double>{0.1, 1, 10}};
    const Axis stiffnesses{"stiffness_ratio", "E t/(ρ c² h)",
                           full ? std::vector<double>{0.01, 0.1, 1, 10, 100, 1e4} : std::vector<double>{0.1, 1, 10}};
    const Axis places{"place", "place of the membrane in its cell", {0.02, 0.25, 0.5, 0.75, 0.98}};
    std::vector<MapPlan> all;
    for (const std::string scheme : {"default", "york1997"}) {
      all.push_back(
          {.title = "largest stable step along the membrane", .scheme = scheme, .x = masses, .y = stiffnesses});
      if (!full) continue;
      all.push_back(
          {.title = "largest stable step along the membrane", .scheme = scheme, .x = places, .y = stiffnesses});
      all.push_back({.title = "largest stable step in the box",
                     .scheme = scheme,
                     .overrides = {{"dim", 2.0}},
                     .x = {"place", "height of the membrane in its cell", {0.02, 0.25, 0.5}},
                     .y = {"stiffness_ratio", "E t/(ρ c² h)", {0.1, 10, 1e3}}});
    }
    return all;
  }
};

PLUMBLINE_STABILITY_PROBLEM(Coupled);

}  // namespace
}  // namespace plumbline
