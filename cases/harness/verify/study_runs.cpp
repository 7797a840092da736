#include "cases/harness/verify/study_runs.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/pool.hpp"
#include "cases/harness/verify/verification.hpp"

namespace plumbline {
namespace {

// Rough cost for the order of starting: points times steps both grow with cells and with the inverse step.
double cost(const PlannedRun& run) {
  if (!run.settings.has("cells")) return 0;
  const double cells = run.settings.number("cells"), ppc = run.settings.number("ppc");
  const double step = run.settings.is_set("dt") ? run.settings.number("dt") : run.settings.number("cfl") / cells;
  return cells * ppc / step;
}

// What no other run would survive either: a signal, a folder that cannot be written, a wrong call.
bool ends_all(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const Interrupted&) {
    return true;
  } catch (const FileError&) {
    return true;
  } catch (const UsageError&) {
    return true;
  } catch (...) {
    return false;
  }
}

}  // namespace

std::vector<std::vector<RunOutcome>> make_runs(const Case& entry, const std::vector<StudyPlan>& plans,
                                               const std::vector<std::vector<PlannedRun>>& planned, int threads,
                                               const Progress& progress, RunStore* store) {
  struct Place {
    std::size_t study, run;
  };
  std::vector<std::vector<RunOutcome>> outcomes(plans.size());
  struct Missing {
    Place place;
    FrameRequest frames;
  };
  std::vector<Missing> missing;
  std::vector<std::pair<Place, Place>> shared;  // of which another is the same
  std::map<std::string, std::size_t> first;     // of those missing, by the name of its file
  std::size_t all = 0, done = 0;
  for (const auto& runs : planned) all += runs.size();
  const auto at = [&](const Place& p) -> RunOutcome& { return outcomes[p.study][p.run]; };
  const auto plan_of = [&](const Place& p) -> const PlannedRun& { return planned[p.study][p.run]; };
  const auto report = [&](const RunResult& run) {
    ++done;
    if (progress) progress(done, all, run);
  };
  for (std::size_t s = 0; s < plans.size(); ++s) {
    outcomes[s].resize(planned[s].size());
    for (std::size_t k = 0; k < planned[s].size(); ++k) {
      const Place here{s, k};
      const std::string scheme = result_scheme(entry, plans[s].scheme, planned[s][k].settings);
      const std::string file = ResultsFolder::run_name(entry.name, scheme, planned[s][k].settings);
      if (store) at(here).run = store->take(entry, file, planned[s][k].frames);
      if (at(here).run) {
        report(*at(here).run);
        continue;
      }
      const auto [earlier, is_new] = first.emplace(file, missing.size());
      if (is_new) {
        missing.push_back({here, planned[s][k].frames});
        continue;
      }
      Missing& there = missing[earlier->second];
      there.frames = of_both(there.frames, planned[s][k].frames);
      shared.emplace_back(here, there.place);
    }
  }
  std::stable_sort(missing.begin(), missing.end(),
                   [&](const Missing& a, const Missing& b) { return cost(plan_of(a.place)) > cost(plan_of(b.place)); });
  std::mutex guard;
  for_all(missing.size(), threads, [&](std::size_t k) {
    const auto& [place, frames] = missing[k];
    RunOutcome& outcome = at(place);
    try {
      Making making;
      RunResult made = make_run(entry, plans[place.study].scheme, plan_of(place).settings, frames, making);
      const std::lock_guard lock(guard);
      if (store) store->keep(entry, made, making);
      report(made);
      outcome.run = std::move(made);
    } catch (...) {
      outcome.failure = std::current_exception();
      if (ends_all(outcome.failure)) throw;
    }
  });
  for (const auto& [here, other] : shared) {
    at(here) = at(other);
    if (at(here).run) report(*at(here).run);
  }
  return outcomes;
}

StudyResult study_of(const Case& entry, const StudyPlan& plan, const std::vector<PlannedRun>& planned,
                     std::vector<RunOutcome> outcomes) {
  std::vector<RunResult> runs;
  for (RunOutcome& outcome : outcomes) {
    if (outcome.failure) std::rethrow_exception(outcome.failure);
    runs.push_back(std::move(*outcome.run));
  }
  StudyResult study = assemble_study(entry, plan, planned, std::move(runs));
  if (!study.levels.empty()) study.scheme = study.levels.front().run.scheme;
  return study;
}

StudyResult run_study(const Case& entry, const StudyPlan& plan, const std::vector<PlannedRun>& planned, int threads,
                      const Progress& progress, RunStore* store) {
  return study_of(entry, plan, planned, make_runs(entry, {plan}, {planned}, threads, progress, store).front());
}

}  // namespace plumbline
