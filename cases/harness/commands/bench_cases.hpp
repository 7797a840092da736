// What accuracy costs: the refinement studies of the cases, timed on one thread, repeated and interleaved.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/judge/study.hpp"
#include "cases/harness/results/documents.hpp"
#include "cases/harness/run/experiment.hpp"

namespace plumbline {

// A run to be timed. Runs of equal choices may belong to several studies and are timed for each.
struct CostRun {
  const Case* entry = nullptr;
  std::string called, scheme;  // as run_experiment takes it; as it is shown: "default+usl"
  std::string study;           // StudyPlan::id; "integrator/usl"; "levels/york1997"; "surface"
  Vary vary = Vary::cells;
  double value = 0;  // cells; of the surface the Courant number
  Settings settings;

  std::string key() const;  // the same for equal choices of the same case
};

// All runs of the case (none of the stability laboratory's, which take no steps of their own), coarse to fine within a study: its refinements in cells; every integrator where the case takes
// any, and York's scheme where it has one, at its default levels; for Sod's tube the surface over cells and Courant
// number under both schemes.
std::vector<CostRun> cost_runs(const Case& entry, Tier tier);

// Time that measuring may take, s of one core.
struct CostBudget {
  double longest_run;  // longer runs are not made (York's at other levels: six times as long): their time is that of
                       // the stored result, if there is one
  double of_run;       // all repeats of a run together, but for the first; a run of more than half of it is made once
  double in_all;
};
CostBudget cost_budget(Tier tier);

struct CostSample {
  std::vector<double> wall_s{};  // stepping alone, in the order in which they were taken; empty: not made
  Json document{};               // of the first run, or of the stored one; null: neither
};

// Round robin: each of `repeats` rounds makes every short run that still has time, the last one the longer ones too, so
// that a slow drift of the machine meets all. `results`: a folder that may hold stored runs. One sample for each of `runs`, in their order.
// Throws Interrupted.
std::vector<CostSample> time_cost_runs(const std::vector<CostRun>& runs, int repeats, const CostBudget& budget,
                                       const std::string& results);

// What a run is told by: case, scheme, study, what is varied and its value.
Json cost_run_name(const CostRun& run);

// The entry of "runs"; null where the run was neither made nor stored, or takes no step.
Json cost_entry(const CostRun& run, const CostSample& sample);

}  // namespace plumbline
