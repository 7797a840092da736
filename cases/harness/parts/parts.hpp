// Parts of a scheme that are chosen by name and judged by gates of their own kind, which need nothing from their authors.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "cases/harness/judge/measured_gates.hpp"
#include "kernel/scene.hpp"

namespace plumbline {

struct PartKind {
  std::string name;  // "shape": the option of `verify`, and where results name a case
  std::function<std::vector<std::string>()> names;
  // shape: with which transfers are judged.
  std::function<std::vector<MeasuredGate>(const std::string& part, const std::string& shape)> gates;
};
const std::vector<PartKind>& part_kinds();

struct JudgedPart {
  std::vector<JudgedGate> gates;  // in the order of the rows
  std::vector<NotApplicable> not_applicable;
  int declared = 0;  // more than both where judging ended at the first red one
};

struct PartJudging {
  int threads = 1;         // no number depends on it
  bool until_red = false;  // no gate is begun after one that is red
  JudgingProgress progress = {};
  std::string shape = Scene().shape;  // with which transfers are judged
};

// Of sums of a few hundred terms of order one: a few thousand roundings.
inline constexpr double rounding_of_parts = 1e-12;
// The larger of what two probes missed, NaN before all.
inline double worse(double a, double b) { return std::isnan(a) || a > b ? a : b; }

// Throws UsageError for an unknown name, and Interrupted; what the part throws is a failure of the gate that asked it.
JudgedPart judge_part(const PartKind& kind, const std::string& name, const PartJudging& how = {});

}  // namespace plumbline
