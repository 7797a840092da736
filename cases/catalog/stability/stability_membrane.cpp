// What the laboratory says of strings, taut and slack, along the grid and across it.
#include <cmath>

#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

Findings limits_at(const std::string& scheme, double slope) {
  const StabilityProblem& membrane = find_stability_problem("membrane");
  Findings findings;
  double apart = 0;
  std::vector<double> predicted, observed, offsets{0.01, 0.25, 0.5};
  for (const double offset : offsets) {
    const Settings settings = stability_settings(membrane, scheme, {{"slope", slope}, {"offset", offset}});
    const Prediction found = membrane.predicted(settings, 1e-5);
    const Observation seen = membrane.observed(settings, found.reach);
    predicted.push_back(found.limit());
    observed.push_back(seen.brackets.empty() ? std::nan("") : 0.5 * (seen.brackets[0].low + seen.brackets[0].high));
    apart = larger(apart, std::abs(observed.back() / predicted.back() - 1));
  }
  findings.measures.push_back(scalar_measure("observed.departure", apart, 0, 1e-15, "1"));
  findings.profile.abscissa = "offset";
  findings.profile.columns = {{"offset", "1", "offset of the string above a node", offsets},
                              {"predicted", "h/c", "largest stable step", predicted},
                              {"observed", "h/c", "seen in runs", observed}};
  return findings;
}

// Along the grid and with positions held a string of accumulated strain is a bar.
Findings as_a_bar() {
  const StabilityProblem& membrane = find_stability_problem("membrane");
  Findings findings;
  double worst = 0;
  for (const double ppc : {1.0, 2.0}) {
    for (const double place : {0.1, 0.3, 0.5}) {
      const Settings settings = stability_settings(membrane, "york1997",
                                                   {{"positions", "frozen"}, {"ppc", ppc}, {"place", place}});
      const double limit = membrane.predicted(settings, 1e-5).limit();
      worst = larger(worst, std::abs(limit / membrane.closed_form(settings)->limit - 1));
    }
  }
  findings.measures.push_back(scalar_measure("limit.departure", worst, 0, 1e-15, "1"));
  return findings;
}

Findings slack(const std::string& scheme) {
  const StabilityProblem& membrane = find_stability_problem("membrane");
  const Settings settings = stability_settings(membrane, scheme, {{"strain", -0.01}});
  const Prediction found = membrane.predicted(settings, 1e-5);
  const Observation seen = membrane.observed(settings, found.reach);
  Findings findings;
  findings.measures = {finding("predicted_stable", found.always_stable() ? 1 : 0),
                       finding("observed_stable", seen.always_stable ? 1 : 0)};
  return findings;
}

class StabilityMembrane final : public TrialCase {
 public:
  std::string name() const override { return "stability-membrane"; }

  std::vector<Trial> trials() const override {
    return {
        {"along", "segments, along the grid", "Three offsets.", [] { return limits_at("default", 0); }},
        {"slope-half", "segments, slope ½", "Three offsets.", [] { return limits_at("default", 0.5); }, Tier::full},
        {"diagonal", "segments, slope 1", "Three offsets.", [] { return limits_at("default", 1); }, Tier::full},
        {"york-along", "accumulated strain, along the grid", "Three offsets.", [] { return limits_at("york1997", 0); },
         Tier::full},
        {"as-a-bar", "accumulated strain, positions held", "Exact.", as_a_bar},
        {"slack", "slack segments", "Nothing pulls.", [] { return slack("default"); }},
        {"slack-york", "slack, accumulated strain", "Nothing pulls.", [] { return slack("york1997"); }, Tier::full}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const std::string study : {"along", "slope-half", "diagonal", "york-along"}) {
      all.push_back(error_gate(study, "observed.departure", trial_level,
                               declare(study + "/observed", {{}, 0.01}, Origin::requirement,
                                       "observed limits within 1 % of the predicted ones, a tenth of the room that "
                                       "cfl=auto leaves below a limit"),
                               study == "along" ? Tier::quick : Tier::full));
    }
    all.push_back(error_gate("as-a-bar", "limit.departure", trial_level,
                             declare("as-a-bar/limit", {{}, 1e-3}, Origin::theory,
                                     "the closed form of a bar; growth below 0.002 a step is not counted, and a radius "
                                     "grows with the root of the step's excess")));
    for (const std::string study : {"slack", "slack-york"}) {
      for (const std::string who : {"predicted", "observed"}) {
        all.push_back(
            value_gate(study, who + "_stable", trial_level,
                       declare(study + "/" + who, {1, 1}, Origin::theory, "nothing pulls: every step is stable"),
                       study == "slack" ? Tier::quick : Tier::full));
      }
    }
    return all;
  }
};

PLUMBLINE_CASE(StabilityMembrane);

}  // namespace
}  // namespace plumbline
