// What the laboratory says of a gas around the axis.
#include <cmath>
#include <utility>

#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline::stability_axisymmetric {
namespace {

struct Seen {
  double predicted = 0, observed = 0;
};

Seen look(const std::string& scheme, const std::string& geometry, const std::vector<Override>& more) {
  const StabilityProblem& can = find_stability_problem("axisymmetric");
  std::vector<Override> overrides = more;
  overrides.emplace_back("geometry", geometry);
  if (scheme == "default")
    overrides.emplace_back("quadrature", 0.0);  // rings have nothing else: the plane beside them neither
  const Settings settings = stability_settings(can, scheme, overrides);
  const Prediction predicted = can.predicted(settings, 1e-3);
  const Observation observed = can.observed(settings, predicted.reach);
  if (observed.brackets.size() != 1) return {predicted.limit(), std::nan("")};
  return {predicted.limit(), 0.5 * (observed.brackets[0].low + observed.brackets[0].high)};
}

Findings limits(const std::string& scheme, const std::vector<Override>& more) {
  Findings findings;
  const Seen axis = look(scheme, "axis", more), plane = look(scheme, "plane", more);
  const double worst = larger(std::abs(axis.observed / axis.predicted - 1),
                              std::abs(plane.observed / plane.predicted - 1));
  findings.measures = {scalar_measure("observed.departure", worst, 0, 1e-15, "1"),
                       finding("limit.axis", axis.predicted, "h/c"), finding("limit.plane", plane.predicted, "h/c"),
                       finding("axis_over_plane", axis.predicted / plane.predicted)};
  return findings;
}

const std::vector<std::string> schemes{"default", "york1997"};

std::vector<Trial> trials() {
  std::vector<Trial> all;
  for (const std::string& scheme : schemes) {
    all.push_back({scheme, scheme + ": a can of three cells, and the plane", "2 x 2 rings a cell.", [scheme] {
                     return limits(scheme, {{"width", 3.0}});
                   }});
    all.push_back({scheme + "-wide", scheme + ": a can of five cells", "The same, wider.",
                   [scheme] { return limits(scheme, {}); }, Tier::full});
  }
  return all;
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const std::string& scheme : schemes) {
    for (const auto& [trial, tier] : {std::pair{scheme, Tier::quick}, {scheme + "-wide", Tier::full}}) {
      all.push_back(
          gate(trial + "/limit", error_of("observed.departure"), at_most(0.02), requirement(roughly_observed_limits))
              .in(tier));
      all.push_back(gate(trial + "/axis", value_of("axis_over_plane"), between(0.5, 1.0),
                         theory("the hoop strain adds to the stiffness of the first node, at most as much again as the "
                                "radial one: 1/2 to 1 even if it carried no more mass"))
                        .in(tier));
    }
  }
  return all;
}

Case stability_axisymmetric() { return trial_case("stability-axisymmetric", trials(), gates()); }
PLUMBLINE_CASE(stability_axisymmetric);

}  // namespace
}  // namespace plumbline::stability_axisymmetric
