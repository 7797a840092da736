// What the laboratory says of a gas around the axis.
#include <cmath>

#include "cases/harness/gates.hpp"
#include "cases/laboratory/problem.hpp"
#include "cases/stability/trial_case.hpp"

namespace plumbline {
namespace {

struct Seen {
  double predicted = 0, observed = 0;
};

Seen look(const std::string& scheme, const std::string& geometry, const std::vector<Override>& more) {
  const StabilityProblem& can = find_stability_problem("axisymmetric");
  std::vector<Override> overrides = more;
  overrides.emplace_back("geometry", geometry);
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

class StabilityAxisymmetric final : public TrialCase {
 public:
  Statement statement() const override {
    Statement s;
    s.name = "stability-axisymmetric";
    s.sketch =
        R"svg(<svg viewBox="0 0 240 140" role="img" aria-label="Cells beside an axis with rings of gas"><path d="M40 15h160v40h-160zM80 15v40M120 15v40M160 15v40M40 55h160v40h-160zM80 55v40M120 55v40M160 55v40M40 5v100" fill="none" stroke="currentColor" stroke-width="1.2"/><g fill="currentColor"><circle cx="50" cy="25" r="2"/><circle cx="50" cy="45" r="2"/><circle cx="50" cy="65" r="2"/><circle cx="50" cy="85" r="2"/><circle cx="70" cy="25" r="2"/><circle cx="70" cy="45" r="2"/><circle cx="70" cy="65" r="2"/><circle cx="70" cy="85" r="2"/><circle cx="90" cy="25" r="2"/><circle cx="90" cy="45" r="2"/><circle cx="90" cy="65" r="2"/><circle cx="90" cy="85" r="2"/><circle cx="110" cy="25" r="2"/><circle cx="110" cy="45" r="2"/><circle cx="110" cy="65" r="2"/><circle cx="110" cy="85" r="2"/><circle cx="130" cy="25" r="2"/><circle cx="130" cy="45" r="2"/><circle cx="130" cy="65" r="2"/><circle cx="130" cy="85" r="2"/><circle cx="150" cy="25" r="2"/><circle cx="150" cy="45" r="2"/><circle cx="150" cy="65" r="2"/><circle cx="150" cy="85" r="2"/><circle cx="170" cy="25" r="2"/><circle cx="170" cy="45" r="2"/><circle cx="170" cy="65" r="2"/><circle cx="170" cy="85" r="2"/><circle cx="190" cy="25" r="2"/><circle cx="190" cy="45" r="2"/><circle cx="190" cy="65" r="2"/><circle cx="190" cy="85" r="2"/></g><g fill="currentColor" font-size="12"><text x="15" y="20">axis</text><text x="90" y="120">r</text></g></svg>)svg";
    s.title = "Largest stable steps of a gas around the axis";
    s.source = "York 1997, SAND97-1893, section 6.3, whose airbags are axisymmetric; no analysis of it is known";
    s.claim =
        "Near the axis the limit of the step is lower than in the plane: by a twentieth by default, by an eighth by "
        "York's "
        "choices.";
    s.physics =
        "A gas at rest in a can, and in the same box in the plane. Next to the axis a ring strains by v_r/r as much as "
        "by "
        "∂v_r/∂r, on a node that carries only the mass of thin rings: the stiffest place of the can.\n\n"
        "York's airbags (dt = 3.5e-6, h = 0.02, c = 67.9) took 0.012 h/c, far below the gas's limit.";
    s.equations = {"Σ_p V_p p (∂N_i/∂r + N_i/r_p) = 0 at rest"};
    s.cells_along = "nothing: trials are not refined";
    s.reference_name = "bar-stability";
    s.reference_text = "None: runs are compared with what the step predicts.";
    s.reference_bound = "Rounding.";
    s.theory_orders = {{"observed.departure", 0, "nothing is refined"}};
    return s;
  }
  std::vector<Trial> trials() const override {
    std::vector<Trial> all;
    for (const std::string scheme : {"default", "york1997"}) {
      all.push_back({scheme, scheme + ": a can of three cells, and the plane", "2 x 2 rings a cell.", [scheme] {
                       return limits(scheme, {{"width", 3.0}});
                     }});
      all.push_back({scheme + "-wide", scheme + ": a can of five cells", "The same, wider.",
                     [scheme] { return limits(scheme, {}); }, Tier::full});
    }
    return all;
  }
  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const std::string scheme : {"default", "york1997"}) {
      for (const bool wide : {false, true}) {
        const Tier tier = wide ? Tier::full : Tier::quick;
        const std::string trial = scheme + (wide ? "-wide" : "");
        all.push_back(error_gate(
            trial, "observed.departure", trial_level,
            declare(trial + "/limit", {{}, 0.02}, Origin::target, "observed limits within 2 % of the predicted ones"),
            tier));
        all.push_back(
            value_gate(trial, "axis_over_plane", trial_level,
                       declare(trial + "/axis", {0.5, 1.0}, Origin::theory,
                               "the hoop strain adds to the stiffness of the first node, at most as much again "
                               "as the radial one: 1/2 to 1 even if it carried no more mass"),
                       tier));
      }
    }
    return all;
  }
  GateCount gate_count() const override { return {12, 24}; }
};

PLUMBLINE_CASE(StabilityAxisymmetric);

}  // namespace
}  // namespace plumbline
