// A plan of many runs, in batches for a pool of processes or for a cluster; and its file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/harness/results/documents.hpp"
#include "cases/harness/verify/verification.hpp"

namespace plumbline {

inline constexpr int plan_format = 1;

// One run of a plan.
struct PlanRun {
  const Case* entry = nullptr;
  std::string scheme;  // as --scheme takes it
  std::string study;   // the first that needs it; empty if none does
  Settings settings;
  FrameRequest frames = {};
  std::string file;  // its name in a results folder
};

struct Batch {
  std::string id;      // "0001-small"
  bool large = false;  // one run that is long
  double estimated_s = 0, memory_mb = 0;
  std::vector<PlanRun> runs;
};

struct Plan {
  std::string tier = "none";  // quick, full, or none: somebody's own choice of runs
  std::vector<Batch> batches;
};

// The run of these choices, with its file's name.
PlanRun planned_run(const Case& entry, const std::string& scheme, Settings settings, FrameRequest frames = {});

// All runs that verifying the cases in the tier needs, each once.
std::vector<PlanRun> runs_of_tier(const std::vector<const Case*>& entries, Tier tier);

// The runs without those whose file is there already; of what the same run is asked for, the most.
std::vector<PlanRun> each_once(std::vector<PlanRun> runs);

// What a run is known to take, s; negative if unknown.
using KnownTime = std::function<double(const PlanRun&)>;

// Long runs alone and first, the others together to a few seconds a batch, in their order.
std::vector<Batch> batches_of(std::vector<PlanRun> runs, const KnownTime& known);

Json to_json(const Plan& plan);

// A plan as written: with batches, or as a list "runs", or as a product "sweep".
class PlanDocument {
 public:
  // `name` is "-" for standard input. Throws FileError for a file that cannot be read or of a newer version, UsageError
  // for what no plan is.
  explicit PlanDocument(const std::string& name);

  bool has_batches() const { return document_.contains("batches"); }
  std::string tier() const;
  std::vector<std::string> batch_ids() const;

  // Checks and resolves every run. Throws UsageError that names the place of the fault.
  std::vector<PlanRun> runs() const;  // of all kinds of plan, each once
  std::vector<Batch> batches() const;
  Batch batch(const std::string& id) const;  // UsageError with the nearest if there is none

 private:
  Json document_;
};

}  // namespace plumbline
