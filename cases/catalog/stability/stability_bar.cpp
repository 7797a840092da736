// What the laboratory says of an elastic bar, against closed forms and against runs.
#include <cmath>

#include "cases/catalog/stability/bar_dispersion.hpp"
#include "cases/catalog/stability/bar_table.hpp"
#include "cases/catalog/stability/trial_case.hpp"
#include "cases/harness/judge/gates.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline::stability_bar {
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

const std::vector<std::string> integrators{"usf", "musl", "usl"};

std::vector<Trial> trials() {
  std::vector<Trial> all;
  for (const std::string& name : integrators) {
    all.push_back({name + "-closed-form", name + ": limits at 50 places of the point in its cell",
                   "The closed form is exact for linear elasticity with positions held.",
                   [name] { return closed_forms(name); }});
    all.push_back({name + "-runs", name + ": limits that runs show, at four places",
                   "24 periods carry 24 of all wave numbers; the limit is flat there.", [name] { return runs(name); }});
  }
  for (Trial& trial : dispersion_trials()) all.push_back(std::move(trial));
  for (Trial& trial : table_trials()) all.push_back(std::move(trial));
  return all;
}

std::vector<CaseGate> gates() {
  std::vector<CaseGate> all;
  for (const std::string& name : integrators) {
    all.push_back(
        gate(name + "-closed-form/limit", error_of("limit.departure"), at_most(1e-6),
             theory("predicted limits equal the closed form; 1e-6 for finding the step at which a radius leaves 1")));
    all.push_back(
        gate(name + "-runs/limit", error_of("observed.departure"), at_most(0.01), requirement(observed_limits)));
    all.push_back(gate(name + "-runs/brackets", value_of("observed.brackets"), exactly(1),
                       theory("below the limit all steps are stable, above it none")));
  }
  for (CaseGate& gate : dispersion_gates()) all.push_back(std::move(gate));
  for (CaseGate& gate : table_gates()) all.push_back(std::move(gate));
  return all;
}

Case stability_bar() { return trial_case("stability-bar", trials(), gates()); }
PLUMBLINE_CASE(stability_bar);

}  // namespace
}  // namespace plumbline::stability_bar
