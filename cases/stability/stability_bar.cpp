// What the laboratory says of an elastic bar, against closed forms and against runs.
#include <cmath>

#include "cases/harness/gates.hpp"
#include "cases/laboratory/problem.hpp"
#include "cases/stability/bar_table.hpp"
#include "cases/stability/trial_case.hpp"

namespace plumbline {
namespace {

constexpr int places = 50;

// The settings of `bar` with one point a cell at N, linear shapes and FLIP.
Settings at_place(const StabilityProblem& bar, const std::string& integrator, double place) {
  return stability_settings(bar, "default", {{"integrator", integrator}, {"N", place}});
}

Findings closed_forms(const std::string& integrator) {
  const StabilityProblem& bar = find_stability_problem("bar");
  Findings findings;
  findings.profile.abscissa = "N";
  std::vector<double> at, predicted, closed;
  double worst = 0;
  for (int k = 0; k < places; ++k) {
    const double place = (k + 0.5) / places;
    const Configuration found = examine(bar, "default", at_place(bar, integrator, place), false);
    at.push_back(place);
    predicted.push_back(found.predicted.limit());
    closed.push_back(found.closed_form->limit);
    worst = larger(worst, std::abs(predicted.back() / closed.back() - 1));
  }
  findings.measures.push_back(scalar_measure("limit.departure", worst, 0, 1e-15, "1"));
  findings.profile.columns = {{"N", "1", "place of the point in its cell", at},
                              {"limit", "h/c", "largest stable step", predicted},
                              {"limit_reference", "h/c", "closed form", closed}};
  return findings;
}

Findings runs(const std::string& integrator) {
  const StabilityProblem& bar = find_stability_problem("bar");
  Findings findings;
  double worst = 0, brackets = 0;
  for (const double place : {0.05, 0.2, 0.35, 0.5}) {
    const Configuration found = examine(bar, "default", at_place(bar, integrator, place), true);
    const auto& seen = found.observed->brackets;
    brackets = larger(brackets, static_cast<double>(seen.size()));
    const double limit = seen.empty() ? std::nan("") : 0.5 * (seen.front().low + seen.front().high);
    worst = larger(worst, std::abs(limit / found.predicted.limit() - 1));
  }
  findings.measures.push_back(scalar_measure("observed.departure", worst, 0, 1e-15, "1"));
  findings.measures.push_back(finding("observed.brackets", brackets));
  return findings;
}

class StabilityBar final : public TrialCase {
 public:
  Statement statement() const override {
    Statement s;
    s.name = "stability-bar";
    s.sketch =
        R"svg(<svg viewBox="0 0 360 90" role="img" aria-label="A row of cells with one point in each, all at the same place N"><path d="M20 20h320v40h-320zM60 20v40M100 20v40M140 20v40M180 20v40M220 20v40M260 20v40M300 20v40" fill="none" stroke="currentColor" stroke-width="1.2"/><g fill="currentColor"><circle cx="32" cy="40" r="3"/><circle cx="72" cy="40" r="3"/><circle cx="112" cy="40" r="3"/><circle cx="152" cy="40" r="3"/><circle cx="192" cy="40" r="3"/><circle cx="232" cy="40" r="3"/><circle cx="272" cy="40" r="3"/><circle cx="312" cy="40" r="3"/></g><g fill="currentColor" font-size="12"><text x="20" y="80">N h</text><text x="120" y="80">one point a cell, for ever</text></g></svg>)svg";
    s.title = "Largest stable steps of an elastic bar";
    s.source = "York 1997, SAND97-1893, chapter 8, (8.36), (8.41)";
    s.claim =
        "Differentiating the step as a black box gives the limit of the time step to six digits, and runs meet it: 2 "
        "h/c with points at the centres of cells, h/c at their sides, for usf and musl; less for usl.";
    s.physics =
        "A linear elastic bar that goes on for ever, one point a cell at the local weight N, positions held. The "
        "amplification matrix of one period is found by changing each number of its state and taking a step; waves of "
        "every length follow from it by a Bloch sum, and the limit is the step at which the largest eigenvalue leaves "
        "the unit circle.\n\nRuns perturb 24 periods at random and look whether the perturbation grows.";
    s.equations = {"usf, musl: C = 4 √(N (1 − N)) where N (1 − N) ≥ 1/8, else 1 / |1 − 2N|",
                   "usl: C = 1 / √(1 + 4N (1 − N))"};
    s.cells_along = "nothing: trials are not refined";
    s.reference_name = "bar-stability";
    s.reference_text = "Closed forms of the von Neumann analysis, one point a cell, linear shapes, FLIP.";
    s.reference_bound = "Rounding.";
    s.theory_orders = {{"limit.departure", 0, "nothing is refined"}};
    return s;
  }

  std::vector<Trial> trials() const override {
    std::vector<Trial> all;
    for (const char* integrator : {"usf", "musl", "usl"}) {
      const std::string name = integrator;
      all.push_back({name + "-closed-form", name + ": limits at 50 places of the point in its cell",
                     "The closed form is exact for linear elasticity with positions held.",
                     [name] { return closed_forms(name); }});
      all.push_back({name + "-runs", name + ": limits that runs show, at four places",
                     "24 periods carry 24 of all wave numbers; the limit is flat there.",
                     [name] { return runs(name); }});
    }
    for (Trial& trial : table_trials()) all.push_back(std::move(trial));
    return all;
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    for (const std::string name : {"usf", "musl", "usl"}) {
      all.push_back(error_gate(name + "-closed-form", "limit.departure", trial_level,
                               declare(name + "-closed-form/limit", {{}, 1e-6}, Origin::target,
                                       "predicted limits equal the closed form to 1e-6")));
      all.push_back(error_gate(name + "-runs", "observed.departure", trial_level,
                               declare(name + "-runs/limit", {{}, 0.01}, Origin::target,
                                       "observed limits within 1 % of the predicted ones")));
      all.push_back(value_gate(name + "-runs", "observed.brackets", trial_level,
                               declare(name + "-runs/brackets", {1, 1}, Origin::theory,
                                       "below the limit all steps are stable, above it none")));
    }
    for (CaseGate& gate : table_gates()) all.push_back(std::move(gate));
    return all;
  }

  GateCount gate_count() const override { return {33, 105}; }
};

PLUMBLINE_CASE(StabilityBar);

}  // namespace
}  // namespace plumbline
