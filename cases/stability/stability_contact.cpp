// What the laboratory says of two bars in contact: each smooth side, and runs across the switch.
#include <cmath>

#include "cases/harness/gates.hpp"
#include "cases/laboratory/problem.hpp"
#include "cases/stability/trial_case.hpp"

namespace plumbline {
namespace {

const std::vector<double>& interfaces() {
  static const std::vector<double> all{0.01, 0.25, 0.4, 0.5};
  return all;
}

// Predicted and observed limits of one side over the places of the interface.
Findings limits(const std::string& scheme, const std::string& side) {
  const StabilityProblem& contact = find_stability_problem("contact");
  Findings findings;
  double apart = 0, least = 1e300, least_seen = 1e300;
  std::vector<double> predicted, observed;
  for (const double at : interfaces()) {
    const Settings settings = stability_settings(contact, scheme, {{"side", side}, {"interface", at}});
    const Prediction found = contact.predicted(settings, 1e-6);
    const Observation seen = contact.observed(settings, found.reach);
    predicted.push_back(found.limit());
    observed.push_back(seen.brackets.empty() ? std::nan("") : 0.5 * (seen.brackets[0].low + seen.brackets[0].high));
    apart = larger(apart, std::abs(observed.back() / predicted.back() - 1));
    least = smaller(least, predicted.back());
    least_seen = smaller(least_seen, observed.back());
  }
  findings.measures = {scalar_measure("observed.departure", apart, 0, 1e-15, "1"), finding("least", least, "h/c"),
                       finding("least_observed", least_seen, "h/c")};
  findings.profile.abscissa = "interface";
  findings.profile.columns = {{"interface", "1", "where the bars meet in their cell", interfaces()},
                              {"predicted", "h/c", "largest stable step, " + side, predicted},
                              {"observed", "h/c", "seen in runs", observed}};
  return findings;
}

class StabilityContact final : public TrialCase {
 public:
  Statement statement() const override {
    Statement s;
    s.name = "stability-contact";
    s.sketch =
        R"svg(<svg viewBox="0 0 360 90" role="img" aria-label="Two bars pressed together between two walls"><path d="M20 20h320v40h-320zM60 20v40M100 20v40M140 20v40M180 20v40M220 20v40M260 20v40M300 20v40M20 10v60M340 10v60" fill="none" stroke="currentColor" stroke-width="1.2"/><g fill="currentColor"><circle cx="30" cy="36" r="3"/><circle cx="50" cy="36" r="3"/><circle cx="70" cy="36" r="3"/><circle cx="90" cy="36" r="3"/><circle cx="110" cy="36" r="3"/><circle cx="130" cy="36" r="3"/><circle cx="150" cy="36" r="3"/><circle cx="170" cy="36" r="3"/><rect x="188" y="41" width="5" height="5"/><rect x="208" y="41" width="5" height="5"/><rect x="228" y="41" width="5" height="5"/><rect x="248" y="41" width="5" height="5"/><rect x="268" y="41" width="5" height="5"/><rect x="288" y="41" width="5" height="5"/><rect x="308" y="41" width="5" height="5"/><rect x="328" y="41" width="5" height="5"/></g><g fill="currentColor" font-size="12"><text x="150" y="84">interface</text></g></svg>)svg";
    s.title = "Largest stable steps of bars in contact";
    s.source = "York 1997, SAND97-1893, appendix A.1; kernel/README.md, \"Touching\"";
    s.claim =
        "Contact that makes the midpoint velocity common keeps about h/c: what bars bear with their ends, touching or "
        "apart, "
        "and runs meet it. York's contact-release loses stability where neither of its two linear steps does: by "
        "switching.";
    s.physics =
        "Two bars, each with a velocity field of its own. `touching`: pressed together at rest. `apart`: without "
        "stress, "
        "too far from each other to touch, yet at nodes that both use. Both sides are linear, and the laboratory "
        "differentiates each.\n\nUnder York's criterion bars at rest are neither. His two linear steps take turns, "
        "decided by "
        "the sign of a velocity difference; a product of two stable steps need not be stable, and runs grow from steps "
        "on "
        "that both sides bear.";
    s.equations = {"touching: v̄₁ = v̄₂ at every shared node", "apart: each field alone"};
    s.cells_along = "nothing: trials are not refined";
    s.reference_name = "none";
    s.reference_text = "Predicted limits of each side; runs.";
    s.reference_bound = "Width of the brackets, 0.2 %.";
    s.theory_orders = {{"observed.departure", 0, "nothing is refined"}};
    s.known_limits = {"One dimension: normals and the choice of touching points are not put to the test."};
    return s;
  }

  // One of the four in the quick tier: the others take as long again each.
  static Tier tier_of(const std::string& study) { return study == "default-touching" ? Tier::quick : Tier::full; }

  std::vector<Trial> trials() const override {
    std::vector<Trial> all;
    for (const std::string scheme : {"default", "york1997"}) {
      for (const std::string side : {"touching", "apart"}) {
        all.push_back({scheme + "-" + side, scheme + ", bars " + side, "Four places of the interface.",
                       [=] { return limits(scheme, side); }, tier_of(scheme + "-" + side)});
      }
    }
    return all;
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const std::string study : {"default-touching", "default-apart"}) {
      all.push_back(error_gate(
          study, "observed.departure", trial_level,
          declare(study + "/observed", {{}, 0.01}, Origin::target, "observed limits within 1 % of the predicted ones"),
          tier_of(study)));
    }
    for (const std::string study : {"default-touching", "default-apart", "york1997-touching", "york1997-apart"}) {
      all.push_back(value_gate(
          study, "least", trial_level,
          declare(study + "/above-safe-step", {0.5, {}}, Origin::target, "cases of solids run at half of h/c"),
          tier_of(study)));
    }
    for (const bool touching : {true, false}) {
      const std::string study = touching ? "york1997-touching" : "york1997-apart";
      all.push_back(
          error_gate(study, "observed.departure", trial_level,
                     expected_failure(declare(study + "/observed", {{}, 0.01}, Origin::target,
                                              "observed limits within 1 % of the predicted ones"),
                                      "the criterion switches between two linear steps, each stable; their products "
                                      "are not",
                                      touching ? Range{0.29, 0.37} : Range{0.41, 0.51}, "2026-11-23 5825b24"),
                     Tier::full));
    }
    return all;
  }

  GateCount gate_count() const override { return {6, 24}; }
};

PLUMBLINE_CASE(StabilityContact);

}  // namespace
}  // namespace plumbline
