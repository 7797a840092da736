#include "cases/harness/verify/verification.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <set>

#include "cases/harness/files/errors.hpp"
#include "kernel/integrator_traits.hpp"

namespace plumbline {
namespace {

bool in_tier(Tier needed, Tier tier) { return tier == Tier::full || needed == Tier::quick; }

}  // namespace

std::string integrator_scheme(const Case& entry, const std::string& integrator) {
  const Settings settings = entry.settings("default", {});
  return settings.text("integrator") == integrator ? "default" : "default+" + integrator;
}

std::string result_scheme(const Case& entry, const std::string& scheme, const Settings& settings) {
  return scheme == "default" && entry.trials.empty() ? integrator_scheme(entry, settings.text("integrator")) : scheme;
}

namespace {

// What is missing for an integrator in the scene of a plan's first level.
std::vector<Lack> lacks_of(const Case& entry, const IntegratorEntry& integrator, const StudyPlan& plan) {
  try {
    const PlannedRun first = planned_runs(entry, plan, Tier::quick).front();
    return lacks(integrator, entry.problem(first.settings)->unprepared());
  } catch (const MissingTraits& parts) {
    return parts.lacks;
  }
}

}  // namespace

StudyPlan integrator_plan(const Case& entry, const std::string& integrator) {
  StudyPlan plan{.id = "integrator/" + integrator,
                 .title = "default scheme with integrator " + integrator,
                 .why = "No expectation: identities only.",
                 .overrides = {{"integrator", integrator}},
                 .values = {entry.levels.front()}};
  const IntegratorEntry* found = find_integrator(integrator);
  if (!found) return plan;  // settings() will name the nearest
  std::vector<Lack> missing = lacks_of(entry, *found, plan);
  if (missing.empty()) return plan;
  StudyPlan unfiltered = plan;
  unfiltered.title += " and transfer flip";
  unfiltered.overrides.emplace_back("transfer", "flip");
  if (entry.settings("default", {}).has("split")) unfiltered.overrides.emplace_back("split", 0.0);
  if (lacks_of(entry, *found, unfiltered).empty()) return unfiltered;
  throw MissingTraits("integrator", integrator, "another integrator", "case=" + entry.name, std::move(missing));
}

namespace {

// The plans of a tier, with those of the integrators last; `own` counts the case's.
struct Plans {
  std::vector<StudyPlan> all;
  std::size_t own = 0;
  std::vector<NotApplicable> not_applicable = {};
};

Plans selected_plans(const Case& entry, Tier tier, const Selection& selection) {
  Plans plans;
  const auto wanted = [&](const StudyPlan& plan) {
    if (selection.schemes.empty()) return selection.integrators.empty();
    return std::find(selection.schemes.begin(), selection.schemes.end(), plan.scheme) != selection.schemes.end();
  };
  for (const std::string& scheme : selection.schemes) entry.settings(scheme, {});
  for (StudyPlan plan : entry.studies) {
    if (in_tier(plan.tier, tier) && wanted(plan)) plans.all.push_back(std::move(plan));
  }
  plans.own = plans.all.size();
  if (!entry.trials.empty()) return plans;
  std::vector<std::string> chosen = selection.integrators;
  if (chosen.empty() && selection.schemes.empty() && entry.any_integrator) {
    for (const IntegratorEntry& integrator : integrators()) chosen.push_back(integrator.name);
  }
  for (const std::string& integrator : chosen) {
    try {
      plans.all.push_back(integrator_plan(entry, integrator));
    } catch (const MissingTraits& parts) {
      if (selection.by_name) throw;
      plans.not_applicable.push_back({entry.name, integrator, parts.lacks});
    }
  }
  return plans;
}

// Dimension, and whether it is axisymmetric. Of a study that failed, those of its first scene, which may be what failed.
std::pair<int, bool> geometry_of(const StudyResult& study) {
  if (!study.entry->trials.empty()) return {0, false};
  if (!study.levels.empty()) return {study.levels.front().run.dim, study.levels.front().run.axisymmetric};
  try {
    const PlannedRun first = planned_runs(*study.entry, study.plan, Tier::quick).front();
    const GridSpec grid = study.entry->problem(first.settings)->unprepared().grid;
    return {grid.dim, grid.axisymmetric};
  } catch (const std::exception&) {
    return {1, false};
  }
}

// The gates on one study: the case's own, then the generic ones that it does not declare itself as expected to fail.
std::vector<CaseGate> gates_on(const StudyResult& study, const std::vector<CaseGate>& declared) {
  std::vector<CaseGate> gates;
  for (const CaseGate& gate : declared) {
    if (gate.study == study.plan.id) gates.push_back(gate);
  }
  const std::size_t own = gates.size();
  const auto [dim, axisymmetric] = geometry_of(study);
  for (CaseGate& gate : generic_gates(study.plan.id, dim, axisymmetric)) {
    const bool declared_already = std::any_of(gates.begin(), gates.begin() + static_cast<std::ptrdiff_t>(own),
                                              [&](const CaseGate& g) { return g.gate.id == gate.gate.id; });
    if (!declared_already) gates.push_back(std::move(gate));
  }
  return gates;
}

// Studies fail alone: one with a run that throws is left without levels, and its gates are all invalid.
StudyResult study_or_failure(const Case& entry, const StudyPlan& plan, const std::vector<PlannedRun>& planned,
                             std::vector<RunOutcome> outcomes) {
  try {
    return study_of(entry, plan, planned, std::move(outcomes));
  } catch (const std::exception& error) {
    StudyResult study;
    study.entry = &entry;
    study.plan = plan;
    study.scheme = result_scheme(entry, plan.scheme, planned.front().settings);
    study.failure = error.what();
    return study;
  }
}

std::string tier_name(Tier tier) { return tier == Tier::full ? "full" : "quick"; }

// Adds the gates on recorded values after those that they stand beside. `own`: a study of the case's, of which each gate is to
// be recorded.
void add_regressions(const Selection& selection, Tier tier, bool own, std::vector<JudgedGate>& judged,
                     Verification& verification) {
  if (!selection.recorded || !selection.settings.empty()) return;
  std::vector<JudgedGate> added;
  for (const JudgedGate& gate : judged) {
    const RecordedValue::Key key{gate.case_name, gate.study, gate.gate.id, tier_name(tier)};
    const RecordedValue* recorded = selection.recorded->find(key);
    if (recorded && recorded->within) added.push_back(judge_regression(gate, *recorded));
    if (!recorded && own && gate.judgement.verdict == Verdict::pass) verification.unrecorded.push_back(key);
  }
  verification.regressions += static_cast<int>(added.size());
  std::move(added.begin(), added.end(), std::back_inserter(judged));
}

// What should have been executed and was not: a gate that names no study or no level that is run, and one that was recorded and
// is there no more.
std::vector<RecordedValue::Key> lost_gates(const Case& entry, Tier tier, const Selection& selection,
                                           const std::vector<CaseGate>& declared, const StudySet& studies,
                                           const std::set<RecordedValue::Key>& executed) {
  std::set<RecordedValue::Key> wanted;
  for (const CaseGate& gate : declared) {
    if (!selection.takes(gate.gate.id)) continue;
    const bool selected = selection.everything() || std::any_of(studies.begin(), studies.end(), [&](const auto& study) {
                            return study.plan.id == gate.study;
                          });
    if (selected) wanted.emplace(entry.name, gate.study, gate.gate.id, tier_name(tier));
  }
  if (selection.recorded && selection.everything()) {
    for (const RecordedValue::Key& key : selection.recorded->of_case(entry.name, tier_name(tier))) wanted.insert(key);
  }
  std::vector<RecordedValue::Key> lost;
  std::set_difference(wanted.begin(), wanted.end(), executed.begin(), executed.end(), std::back_inserter(lost));
  return lost;
}

}  // namespace

bool Selection::takes(const std::string& gate) const {
  return gates.empty() || std::any_of(gates.begin(), gates.end(), [&](const std::string& pattern) {
           return ::fnmatch(pattern.c_str(), gate.c_str(), 0) == 0;
         });
}

bool complete(const Verification& verification) {
  return static_cast<int>(verification.gates.size() + verification.not_applicable.size()) == verification.declared;
}

std::vector<StudyPlan> selected_studies(const Case& entry, Tier tier, const Selection& selection) {
  return selected_plans(entry, tier, selection).all;
}

namespace {

std::vector<CaseGate> declared_gates(const Case& entry, Tier tier, const Selection& selection) {
  std::vector<CaseGate> declared;
  for (const CaseGate& gate : entry.gates) {
    if (in_tier(gate.tier, tier) && selection.settings.empty()) declared.push_back(gate);
  }
  return declared;
}

// Whether a gate is selected, or the one on its recorded value.
bool takes_either(const Selection& selection, const std::string& gate) {
  return selection.takes(gate) || selection.takes(regression_of(gate));
}

// Of the plans those that the selected gates need, and of these the levels. A study that another's gate compares with is needed
// whole.
void keep_needed(const Case& entry, Tier tier, const Selection& selection, Plans& plans) {
  if (selection.gates.empty()) return;
  const std::vector<CaseGate> declared = declared_gates(entry, tier, selection);
  std::map<std::string, std::set<double>> needed;  // by study; no levels: all
  std::set<std::string> whole;
  for (const StudyPlan& plan : plans.all) {
    StudyResult study;
    study.entry = &entry;
    study.plan = plan;
    for (const CaseGate& gate : gates_on(study, declared)) {
      if (!takes_either(selection, gate.gate.id)) continue;
      needed[plan.id].insert(gate.levels.begin(), gate.levels.end());
      if (gate.levels.empty()) whole.insert(plan.id);
      for (const std::string& other : gate.also) whole.insert(other);
    }
  }
  const auto is_needed = [&](const StudyPlan& plan) { return whole.count(plan.id) + needed.count(plan.id) > 0; };
  const auto own_end = plans.all.begin() + static_cast<std::ptrdiff_t>(plans.own);
  plans.own = static_cast<std::size_t>(std::count_if(plans.all.begin(), own_end, is_needed));
  std::erase_if(plans.all, [&](const StudyPlan& plan) { return !is_needed(plan); });
  for (StudyPlan& plan : plans.all) {
    if (whole.count(plan.id) > 0) continue;
    const std::set<double>& levels = needed[plan.id];
    for (std::vector<double>* values : {&plan.values, &plan.full_values})
      std::erase_if(*values, [&](double value) { return levels.count(value) == 0; });
  }
  plans.not_applicable.clear();
}

}  // namespace

std::vector<std::string> gate_names(const Case& entry, Tier tier, const Selection& selection) {
  std::vector<std::string> names;
  const std::vector<CaseGate> declared = declared_gates(entry, tier, selection);
  for (const StudyPlan& plan : selected_plans(entry, tier, selection).all) {
    StudyResult study;
    study.entry = &entry;
    study.plan = plan;
    for (const CaseGate& gate : gates_on(study, declared)) names.push_back(gate.gate.id);
  }
  return names;
}

void verify_case(const Case& entry, Tier tier, const Selection& selection, int threads, RunStore& store,
                 const Progress& progress, Verification& verification) {
  Plans plans = selected_plans(entry, tier, selection);
  keep_needed(entry, tier, selection, plans);
  std::vector<std::vector<PlannedRun>> planned;  // all of them before the first run: a wrong call must not cost time
  for (const StudyPlan& plan : plans.all) planned.push_back(planned_runs(entry, plan, tier, selection.settings));
  StudySet studies;
  auto outcomes = make_runs(entry, plans.all, planned, threads, progress, &store);
  for (std::size_t k = 0; k < plans.all.size(); ++k)
    studies.push_back(study_or_failure(entry, plans.all[k], planned[k], std::move(outcomes[k])));
  const std::vector<CaseGate> declared = declared_gates(entry, tier, selection);
  std::set<RecordedValue::Key> executed;
  const std::size_t before = verification.gates.size();
  for (std::size_t k = 0; k < studies.size(); ++k) {
    StudyResult& study = studies[k];
    study.siblings = &studies;
    std::vector<JudgedGate> judged = judge_gates(gates_on(study, declared), study);
    for (const JudgedGate& gate : judged) executed.emplace(gate.case_name, gate.study, gate.gate.id, tier_name(tier));
    std::erase_if(judged, [&](const JudgedGate& gate) { return !takes_either(selection, gate.gate.id); });
    add_regressions(selection, tier, k < plans.own, judged, verification);
    std::erase_if(judged, [&](const JudgedGate& gate) { return !selection.takes(gate.gate.id); });
    if (study.failure.empty() && selection.gates.empty())
      store.folder().write_study(study, judged, store.provenance(entry));
    verification.gates.insert(verification.gates.end(), judged.begin(), judged.end());
  }
  const auto lost = lost_gates(entry, tier, selection, declared, studies, executed);
  verification.declared += static_cast<int>(verification.gates.size() - before + lost.size() +
                                            plans.not_applicable.size());
  verification.lost.insert(verification.lost.end(), lost.begin(), lost.end());
  verification.not_applicable.insert(verification.not_applicable.end(), plans.not_applicable.begin(),
                                     plans.not_applicable.end());
  verification.entries.push_back(&entry);
}

}  // namespace plumbline
