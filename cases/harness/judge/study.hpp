// A refinement study: levels, and the order that each measure shows.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cases/harness/run/experiment.hpp"
#include "cases/harness/verdict/order.hpp"

namespace plumbline {

struct StudyLevel {
  double value = 0;  // of what is varied: cells, factor of the step, points per cell, offset
  double h = 0;      // what the order is fitted against: cell size, step, point spacing
  RunResult run;
  std::vector<RunResult> offsets;  // the same level at further sub-cell offsets
};

struct StudyResult;
using StudySet = std::vector<StudyResult>;

struct StudyResult {
  const Case* entry = nullptr;
  StudyPlan plan;
  std::string scheme;
  std::vector<StudyLevel> levels;
  std::vector<std::pair<std::string, OrderFit>> fits;  // by measure
  std::string file;
  const StudySet* siblings = nullptr;  // the studies of the same case, while gates are judged
  std::string failure = {};            // what an exception said that left the study without levels

  const StudyResult* sibling(const std::string& id) const;
  const StudyLevel* level(double value) const;
  const OrderFit* fit(const std::string& measure) const;
};

// The settings of each run of a plan: its values (full_values in the full tier if given), and for each the offsets.
struct PlannedRun {
  double value;
  Settings settings;
  bool is_offset = false;  // a further sub-cell offset of the level before
  FrameRequest frames = {};
};
std::vector<PlannedRun> planned_runs(const Case& entry, const StudyPlan& plan, Tier tier,
                                     const std::vector<std::string>& typed = {});

// Assembles levels and fits from the runs, in the order of `planned`.
StudyResult assemble_study(const Case& entry, const StudyPlan& plan, const std::vector<PlannedRun>& planned,
                           std::vector<RunResult> runs);

// Sub-cell offsets of the full tier, beside the case's own.
inline constexpr double further_offsets[] = {0.25, 0.5, 0.75};

}  // namespace plumbline
