// One run of a probe that falls on York's airbag.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "cases/catalog/coupled/airbag_start.hpp"
#include "cases/harness/description/case.hpp"
#include "cases/harness/description/parameters.hpp"

namespace plumbline {

// What York's two simulations differ in. York, Table 7
struct AirbagSpec {
  std::string name;
  double mass = 0;    // of the probe, kg
  double radius = 0;  // of the probe, m
  double speed = 0;   // at impact, m/s
  double crown = 0;   // height of the bag's pole in York's outline, m
  double end_time = 0;
};

// The parameters of either, what they differ in as defaults.
struct AirbagParameters : Parameters {
  BagPressures pressures = bag_pressures(
      one_of("pressure", "physical", {"york", "physical"},
             "4000 Pa above the air outside, or 4000 Pa and nothing outside, as York's input has it"));
  bool tethered = one_of("tether", "removed", {"kept", "removed"},
                         "at impact; it holds the ring on the top side while the bag is blown up") == "kept";
  AirbagSpec spec;

  explicit AirbagParameters(const AirbagSpec& defaults, Parameters given = {})
      : Parameters(std::move(given)),
        spec(defaults) {
    spec.speed = positive("speed", spec.speed, "m/s", "of the probe at impact");
    spec.crown = number({.name = "crown",
                         .value = spec.crown,
                         .unit = "m",
                         .low = tether_height,
                         .high = 0.35,
                         .description = "height of the upper pole in York's outline, from which the bag is blown up"});
    spec.end_time = positive("t_end", spec.end_time, "s", "end time, since impact");
  }
};

// Case::problem.
std::function<std::unique_ptr<Problem>(const Settings&)> airbag_run(const AirbagSpec& defaults);

// The probe, a solid cylinder 80 mm high with its face at the height `face`, at rest: rows of points about h/ppc apart
// that fill it exactly, the density such that it has its mass.
Body airbag_probe(const AirbagSpec& spec, const GridSpec& grid, int ppc, double face);

}  // namespace plumbline
