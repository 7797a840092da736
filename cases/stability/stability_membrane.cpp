// What the laboratory says of strings, taut and slack, along the grid and across it.
#include <cmath>

#include "cases/harness/gates.hpp"
#include "cases/laboratory/problem.hpp"
#include "cases/stability/trial_case.hpp"

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
  Statement statement() const override {
    Statement s;
    s.name = "stability-membrane";
    s.sketch =
        R"svg(<svg viewBox="0 0 300 140" role="img" aria-label="A string along the grid and one across its cells"><path d="M20 15h120v40h-120zM60 15v40M100 15v40M20 55h120v40h-120zM60 55v40M100 55v40M160 15h120v40h-120zM200 15v40M240 15v40M160 55h120v40h-120zM200 55v40M240 55v40M20 45h120M160 95l120 -60" fill="none" stroke="currentColor" stroke-width="1.2"/><g fill="currentColor"><circle cx="30" cy="45" r="3"/><circle cx="50" cy="45" r="3"/><circle cx="70" cy="45" r="3"/><circle cx="90" cy="45" r="3"/><circle cx="110" cy="45" r="3"/><circle cx="130" cy="45" r="3"/><circle cx="170" cy="90" r="3"/><circle cx="190" cy="80" r="3"/><circle cx="210" cy="70" r="3"/><circle cx="230" cy="60" r="3"/><circle cx="250" cy="50" r="3"/><circle cx="270" cy="40" r="3"/></g><g fill="currentColor" font-size="12"><text x="40" y="120">slope 0</text><text x="190" y="120">slope 1/2</text></g></svg>)svg";
    s.title = "Largest stable steps of a string";
    s.source = "York 1997, SAND97-1893, chapters 5 and 8; kernel/materials/segment_membrane.hpp";
    s.claim =
        "A chain of segments bears about 1.6 h/c at two points a cell, at every slope and offset tried; accumulated "
        "strain along the grid bears what a bar does; a slack string bears any step.";
    s.physics =
        "A straight string, stretched by one hundredth, goes on for ever along the grid, at the slope ½ or at 45°. "
        "Waves "
        "along and across it are looked at together; positions move. Growth below 0.002 a step, which long waves "
        "across the "
        "string show, is not taken for a loss of stability.\n\nAccumulated strain has no state of rest across the "
        "grid: the forces "
        "of an even tension do not cancel at the nodes, and the string bends between them. Its limits across the grid "
        "are "
        "shown in the maps for what one step does, not judged here.";
    s.equations = {"T = A E ε where ε > 0, else 0"};
    s.cells_along = "nothing: trials are not refined";
    s.reference_name = "mpm-stability";
    s.reference_text = "Limits of a bar, reference/mpm_amplification.hpp, for strings along the grid.";
    s.reference_bound = "Rounding.";
    s.theory_orders = {{"observed.departure", 0, "nothing is refined"}};
    s.known_limits = {
        "With accumulated strain points away from the middle of their shares let waves across the string grow at "
        "every step, weakly: forces go by gradients of the shapes, tangents by neighbours."};
    return s;
  }

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
      all.push_back(error_gate(
          study, "observed.departure", trial_level,
          declare(study + "/observed", {{}, 0.01}, Origin::target, "observed limits within 1 % of the predicted ones"),
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

  GateCount gate_count() const override { return {16, 37}; }
};

PLUMBLINE_CASE(StabilityMembrane);

}  // namespace
}  // namespace plumbline
