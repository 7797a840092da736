// Gas and a membrane on shared nodes.
#include <algorithm>
#include <cmath>

#include "cases/laboratory/problem.hpp"
#include "cases/stability/coupled_patch.hpp"
#include "cases/stability/fast_growth.hpp"

namespace plumbline {
namespace {

class Coupled final : public StabilityProblem {
 public:
  ProblemStatement statement() const override {
    return {.name = "coupled",
            .title = "Membrane in a gas",
            .source = "York 1997, SAND97-1893, chapter 6; an analysis \"has not been conducted\"",
            .statement = "",
            .equations = {},
            .sampled = ""};
  }
  Kind kind() const override { return Kind::coupled; }
  std::vector<Key> keys() const override {
    return {{.name = "dim",
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
             .value = 0.02,
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
    return {0.3 / std::max(speed, 1.0), 4 / speed, 12};
  }
  Watch watch(const Settings& s) const override {
    if (s.integer("dim") == 2) return watch_beside(s.number("slow"), scan(s));
    Watch watch;
    watch.steps = 1000;
    return watch;
  }
  Prediction predicted(const Settings& s, double width) const override {
    if (s.integer("dim") == 1) return StabilityProblem::predicted(s, width);
    return predict_beside(s.number("slow"), experiment_of(*this, s), scan(s), width);
  }
};

PLUMBLINE_STABILITY_PROBLEM(Coupled);

}  // namespace
}  // namespace plumbline
