// What the laboratory says of two bars in contact: each smooth side, and runs across the switch.
#include <cmath>

#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline::stability_contact {
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

// One of the four in the quick tier: the others take as long again each.
Tier tier_of(const std::string& study) { return study == "default-touching" ? Tier::quick : Tier::full; }

std::vector<Trial> trials() {
  std::vector<Trial> all;
  for (const std::string scheme : {"default", "york1997"}) {
    for (const std::string side : {"touching", "apart"}) {
      all.push_back({scheme + "-" + side, scheme + ", bars " + side, "Four places of the interface.",
                     [=] { return limits(scheme, side); }, tier_of(scheme + "-" + side)});
    }
  }
  return all;
}

CaseGate observed_gate(const std::string& study) {
  return gate(study + "/observed", error_of("observed.departure"), at_most(0.01), requirement(observed_limits))
      .in(tier_of(study));
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all{observed_gate("default-touching"), observed_gate("default-apart")};
  for (const std::string study : {"default-touching", "default-apart", "york1997-touching", "york1997-apart"}) {
    all.push_back(gate(study + "/above-safe-step", value_of("least"), at_least(0.5),
                       requirement("cases of solids run at half of h/c, at which contact must be stable"))
                      .in(tier_of(study)));
  }
  const std::string switches = "the criterion switches between two linear steps, each stable; their products are not";
  all.push_back(observed_gate("york1997-touching").fails(switches, {0.29, 0.37}, "2026-11-23 5825b24"));
  all.push_back(observed_gate("york1997-apart").fails(switches, {0.41, 0.51}, "2026-11-23 5825b24"));
  return all;
}

Case stability_contact() { return trial_case("stability-contact", trials(), gates()); }
PLUMBLINE_CASE(stability_contact);

}  // namespace
}  // namespace plumbline::stability_contact
