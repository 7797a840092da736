// Gas and a membrane on shared nodes.
#include "cases/laboratory/problem.hpp"
#include "cases/stability/coupled_patch.hpp"

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
    return {positive_key("density_ratio", 1, "1", "m_s/(rho h), m_s the membrane's mass per area"),
            positive_key("stiffness_ratio", 1, "1", "E t/(rho c^2 h), E t the membrane's tension per strain"),
            positive_key("strain", 0.02, "1", "of the membrane at rest"),
            {.name = "place",
             .value = 0.5,
             .low = 0,
             .high = 1,
             .low_open = true,
             .high_open = true,
             .description = "height of the membrane in its cell, in cells"},
            {.name = "width", .value = 2.0, .low = 2, .high = 100, .integer = true, .description = "cells along it"},
            {.name = "height", .value = 3.0, .low = 2, .high = 100, .integer = true, .description = "cells across it"}};
  }
  std::vector<Override> choices(const std::string& scheme) const override {
    std::vector<Override> chosen{{"ppc", 4.0}, {"membrane.ppc", 2.0}};
    if (scheme == "default") chosen.push_back({"membrane.strain", "segments"});
    return chosen;
  }
  Patch patch(const Settings& s, const Extent&) const override {
    return coupled_patch(s, {.width = s.integer("width"),
                             .height = s.integer("height"),
                             .place = s.number("place"),
                             .density_ratio = s.number("density_ratio"),
                             .stiffness_ratio = s.number("stiffness_ratio"),
                             .strain = s.number("strain")});
  }
  Scan scan(const Settings&) const override { return {0.2, 4, 10}; }
};

PLUMBLINE_STABILITY_PROBLEM(Coupled);

}  // namespace
}  // namespace plumbline
