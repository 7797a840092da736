// What a results folder holds that can be compared with another: verdicts, studies, limits of the step, costs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "cases/harness/compare/bounds.hpp"
#include "cases/harness/results/documents.hpp"

namespace plumbline {

struct GateRecord {
  std::string tier, case_name, scheme, study, id, quantity;
  Verdict verdict = Verdict::invalid;
  Bounds bounds;  // what stops a run is not in results, nor whether the interval is judged
  std::optional<double> measured;
  std::string started;
  using Key = std::tuple<std::string, std::string, std::string, std::string, std::string>;
  Key key() const { return {case_name, scheme, study, id, tier}; }
};

struct ErrorRecord {
  double error = 0;            // in the unit of the measure; NaN where not known
  double scale = 0;            // of the reference; 0 where not known
  double reference_bound = 0;  // 0 where not known
};

struct LevelRecord {
  double value = 0, h = 0;  // of what is varied; what orders are fitted against
  bool finished = true;
  std::string stop;  // why it is not
  std::map<std::string, ErrorRecord> errors;
};

struct FitRecord {
  std::optional<double> order, low, high, constant;
  std::vector<bool> used;  // by level; empty: all
};

struct StudyRecord {
  std::string case_name, scheme, id, vary, started, file;
  std::map<std::string, std::string> settings;  // but for what is refined
  std::vector<LevelRecord> levels;
  std::map<std::string, FitRecord> fits;
  std::vector<double> values() const;
  // What tells studies apart; a study that nobody declared also by its settings.
  using Key = std::tuple<std::string, std::string, std::string, std::string, std::string>;
  Key key() const;
};

struct LimitRecord {
  std::string problem, integrator, scheme, settings, unit, always;
  std::vector<Range> predicted, observed;
  std::map<std::string, FitRecord> orders;
  using Key = std::tuple<std::string, std::string, std::string, std::string, std::string>;
  Key key() const { return {problem, integrator, scheme, settings, unit}; }
};

struct CostRecord {
  std::string case_name, scheme, study, vary;
  double value = 0, cells = 0;
  std::vector<double> wall_s;  // samples
  std::optional<double> instructions;
  std::optional<double> particle_steps;
  using Key = std::tuple<std::string, std::string, std::string, std::string>;
  Key key() const { return {case_name, scheme, study, vary}; }
};

struct Snapshot {
  std::string folder;
  std::map<GateRecord::Key, GateRecord> gates;                   // the newest of each
  std::map<StudyRecord::Key, std::vector<StudyRecord>> studies;  // of equal levels the newest
  std::map<LimitRecord::Key, LimitRecord> limits;
  std::map<CostRecord::Key, std::vector<CostRecord>> costs;
  std::map<std::string, std::string> machine;        // cpu, instruction_set, compiler, flags: of the newest file
  std::string started, version, git;                 // likewise
  std::map<std::string, std::string> timed_machine;  // the same of the costs
  std::vector<std::pair<std::string, std::string>> damaged;  // file, why
  bool empty() const { return gates.empty() && studies.empty() && limits.empty() && costs.empty(); }
};

// Reads the folder's study and verdict files, stability.json and cost.json. A file that cannot be used is listed as
// damaged. Throws UsageError with the nearest names if there is no such folder, or if nothing in it can be compared.
Snapshot read_snapshot(const std::string& folder);

// The records of one document, added to a snapshot; throw what nlohmann::json throws on a document of another shape.
void take_verdicts(const Json& verdicts, const Json& provenance, Snapshot& snapshot);
void take_study(const Json& study, const std::string& file, Snapshot& snapshot);
void take_stability(const Json& document, Snapshot& snapshot);
void take_costs(const Json& document, Snapshot& snapshot);

}  // namespace plumbline
