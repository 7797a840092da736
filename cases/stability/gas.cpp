// A gas without ends.
#include <cmath>
#include <numbers>

#include "cases/laboratory/problem.hpp"
#include "cases/stability/gas_patch.hpp"

namespace plumbline {
namespace {

Side side_of(const Settings& s) {
  const std::string& side = s.text("side");
  return side == "both" ? Side::both : side == "closing" ? Side::closing : Side::opening;
}

class Gas final : public StabilityProblem {
 public:
  ProblemStatement statement() const override {
    return {.name = "gas",
            .title = "Gas without ends",
            .source = "York 1997, SAND97-1893, chapter 4; no analysis of it is known",
            .statement = "Waves of every length in an ideal gas that goes on for ever.",
            .equations = {},
            .sampled = "all wave numbers, one offset of a regular lattice"};
  }
  Kind kind() const override { return Kind::gas; }
  std::vector<Key> keys() const override {
    return {{.name = "dim", .value = 1.0, .low = 1, .high = 2, .integer = true, .description = "a line, or the plane"},
            {.name = "mach",
             .value = 0.0,
             .low = 0,
             .high = 10,
             .description = "velocity of the gas along x over its speed of sound"},
            {.name = "viscosity", .value = 0.0, .low = 0, .high = 1e3, .description = "physical, mu/(rho c h)"},
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
    return gas_patch(s,
                     {.dim = s.integer("dim"),
                      .offset = s.number("offset"),
                      .mach = s.number("mach"),
                      .viscosity = s.number("viscosity"),
                      .side = side_of(s)},
                     extent);
  }
};

PLUMBLINE_STABILITY_PROBLEM(Gas);

}  // namespace
}  // namespace plumbline
