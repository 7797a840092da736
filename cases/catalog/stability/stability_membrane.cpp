// What the laboratory says of strings, taut and slack, along the grid and across it.
#include <cmath>

#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline::stability_membrane {
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

std::vector<Trial> trials() {
  const std::string offsets = "Three offsets.", nothing = "Nothing pulls.";
  return {{"along", "segments, along the grid", offsets, [] { return limits_at("default", 0); }},
          {"slope-half", "segments, slope ½", offsets, [] { return limits_at("default", 0.5); }, Tier::full},
          {"diagonal", "segments, slope 1", offsets, [] { return limits_at("default", 1); }, Tier::full},
          {"york-along", "accumulated strain, along the grid", offsets, [] { return limits_at("york1997", 0); },
           Tier::full},
          {"as-a-bar", "accumulated strain, positions held", "Exact.", as_a_bar},
          {"slack", "slack segments", nothing, [] { return slack("default"); }},
          {"slack-york", "slack, accumulated strain", nothing, [] { return slack("york1997"); }, Tier::full}};
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const std::string study : {"along", "slope-half", "diagonal", "york-along"}) {
    all.push_back(gate(study + "/observed", error_of("observed.departure"), at_most(0.01), requirement(observed_limits))
                      .in(study == "along" ? Tier::quick : Tier::full));
  }
  all.push_back(gate("as-a-bar/limit", error_of("limit.departure"), at_most(1e-3),
                     theory("the closed form of a bar; growth below 0.002 a step is not counted, and a radius grows "
                            "with the root of the step's excess")));
  for (const std::string study : {"slack", "slack-york"}) {
    for (const std::string who : {"predicted", "observed"}) {
      all.push_back(
          gate(study + "/" + who, value_of(who + "_stable"), exactly(1), theory("nothing pulls: every step is stable"))
              .in(study == "slack" ? Tier::quick : Tier::full));
    }
  }
  return all;
}

Case stability_membrane() { return trial_case("stability-membrane", trials(), gates()); }
PLUMBLINE_CASE(stability_membrane);

}  // namespace
}  // namespace plumbline::stability_membrane
