#include "cases/harness/verification.hpp"

#include <algorithm>
#include <mutex>
#include <numeric>

#include "cases/harness/pool.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

// Rough cost for the order of starting: points times steps both grow with cells and with the inverse step.
double cost(const PlannedRun& run) {
  const double cells = run.settings.number("cells"), ppc = run.settings.number("ppc");
  const double step = run.settings.is_set("dt") ? run.settings.number("dt") : run.settings.number("cfl") / cells;
  return cells * ppc / step;
}

bool in_tier(Tier needed, Tier tier) { return tier == Tier::full || needed == Tier::quick; }

}  // namespace

StudyResult run_study(const Case& entry, const StudyPlan& plan, const std::vector<PlannedRun>& planned, int threads,
                      const Progress& progress) {
  std::vector<std::size_t> order(planned.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return cost(planned[a]) > cost(planned[b]); });
  std::vector<std::optional<RunResult>> results(planned.size());
  std::size_t done = 0;
  std::mutex guard;
  for_all(planned.size(), threads, [&](std::size_t k) {
    const std::size_t at = order[k];
    results[at] = run_experiment(entry, plan.scheme, planned[at].settings);
    results[at]->scheme = plan.scheme == "default" ? integrator_scheme(entry, planned[at].settings.text("integrator")) : plan.scheme;
    const std::lock_guard lock(guard);
    if (progress) progress(++done, planned.size(), *results[at]);
  });
  std::vector<RunResult> runs;
  for (auto& result : results) runs.push_back(std::move(*result));
  StudyResult study = assemble_study(entry, plan, planned, std::move(runs));
  if (!study.levels.empty()) study.scheme = study.levels.front().run.scheme;
  return study;
}

std::string integrator_scheme(const Case& entry, const std::string& integrator) {
  const Settings settings = entry.settings("default", {});
  return settings.text("integrator") == integrator ? "default" : "default+" + integrator;
}

StudyPlan integrator_plan(const Case& entry, const std::string& integrator) {
  return {.id = "integrator/" + integrator, .title = "default scheme with integrator " + integrator,
          .why = "No expectation: identities only.", .overrides = {{"integrator", integrator}},
          .values = {entry.default_levels().front()}};
}

void verify_case(const Case& entry, Tier tier, int threads, const ResultsFolder& folder, const Provenance& provenance,
                 const Progress& progress, Verification& verification) {
  std::vector<StudyPlan> plans;
  for (StudyPlan& plan : entry.studies()) {
    if (in_tier(plan.tier, tier)) plans.push_back(std::move(plan));
  }
  const std::size_t own = plans.size();
  int generic_of_integrators = 0;
  if (entry.any_integrator()) {
    for (const IntegratorEntry& integrator : integrators()) plans.push_back(integrator_plan(entry, integrator.name));
  }
  StudySet studies;
  for (const StudyPlan& plan : plans) studies.push_back(run_study(entry, plan, planned_runs(entry, plan, tier), threads, progress));
  std::vector<CaseGate> declared;
  for (CaseGate& gate : entry.gates()) {
    if (in_tier(gate.tier, tier)) declared.push_back(std::move(gate));
  }
  for (std::size_t k = 0; k < studies.size(); ++k) {
    StudyResult& study = studies[k];
    for (StudyLevel& at : study.levels) {
      folder.write_run(at.run, {}, provenance);
      for (RunResult& other : at.offsets) folder.write_run(other, {}, provenance);
    }
  }
  for (std::size_t k = 0; k < studies.size(); ++k) {
    StudyResult& study = studies[k];
    study.siblings = &studies;
    const int dim = study.levels.empty() ? 1 : study.levels.front().run.dim;
    std::vector<CaseGate> gates;
    for (const CaseGate& gate : declared) {
      if (gate.study == study.plan.id) gates.push_back(gate);
    }
    const std::size_t declared_here = gates.size();
    for (CaseGate& gate : generic_gates(study.plan.id, dim)) {
      // A case may declare a generic gate itself, as one that is expected to fail.
      const bool declared_already = std::any_of(gates.begin(), gates.begin() + static_cast<std::ptrdiff_t>(declared_here),
                                                [&](const CaseGate& g) { return g.gate.id == gate.gate.id; });
      if (!declared_already) gates.push_back(std::move(gate));
    }
    if (k >= own) generic_of_integrators += static_cast<int>(gates.size());
    const std::vector<JudgedGate> judged = judge_gates(gates, study);
    folder.write_study(study, judged, provenance);
    verification.gates.insert(verification.gates.end(), judged.begin(), judged.end());
  }
  const GateCount count = entry.gate_count();
  verification.declared += (tier == Tier::full ? count.full : count.quick) + generic_of_integrators;
  verification.entries.push_back(&entry);
}

}  // namespace plumbline
