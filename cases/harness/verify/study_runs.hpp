// The runs of studies, side by side.
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <vector>

#include "cases/harness/judge/study.hpp"
#include "cases/harness/verify/run_store.hpp"

namespace plumbline {

// Called as runs finish: how many of how many, and which.
using Progress = std::function<void(std::size_t done, std::size_t of, const RunResult& last)>;

// A run of a study: what it gave, or what was thrown.
struct RunOutcome {
  std::optional<RunResult> run;
  std::exception_ptr failure;
};

// Those of several studies of a case, larger ones first; two studies that plan the same run share it. Runs come from the store where
// it has them, and go there as they finish. Throws what no other run would survive either: a signal, a folder that cannot be written,
// a wrong call.
std::vector<std::vector<RunOutcome>> make_runs(const Case& entry, const std::vector<StudyPlan>& plans,
                                               const std::vector<std::vector<PlannedRun>>& planned, int threads,
                                               const Progress& progress, RunStore* store);

// Throws what a run has thrown.
StudyResult study_of(const Case& entry, const StudyPlan& plan, const std::vector<PlannedRun>& planned,
                     std::vector<RunOutcome> outcomes);

// Runs a plan's levels and assembles the study.
StudyResult run_study(const Case& entry, const StudyPlan& plan, const std::vector<PlannedRun>& planned, int threads,
                      const Progress& progress = {}, RunStore* store = nullptr);

}  // namespace plumbline
