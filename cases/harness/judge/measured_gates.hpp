// Gates on parts of a scheme, whose numbers come from no study: measured side by side, with a verdict each.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cases/harness/judge/gates.hpp"

namespace plumbline {

struct MeasuredGate {
  std::string family;
  Gate gate;                          // its id begins with the family
  std::string explanation;            // what usually causes a miss
  std::function<Measured()> measure;  // the number; throws CannotWork where the part cannot be judged so
};

// A gate of the family `family` with the id family/name; `plain`: a number without more.
Gate gate_row(const std::string& family, const std::string& name, const std::string& quantity, Range expected,
              Origin origin, const std::string& reason);
Measured plain(double value, std::string note = {});

// Neither, where judging ended before.
struct GateOutcome {
  std::optional<JudgedGate> judged;
  std::optional<NotApplicable> not_applicable;
};

// Called as gates are judged: how many of how many, and which.
using JudgingProgress = std::function<void(std::size_t done, std::size_t of, const std::string& gate)>;

struct SideBySide {
  int threads = 1;         // no number depends on it
  bool until_red = false;  // no gate is begun after one that is red
  std::function<bool(const JudgedGate&)> is_red;
  std::vector<std::size_t> order = {};  // in which gates are begun; empty: as they stand
  JudgingProgress progress = {};
};

// The outcome of each row, under `kind` (where results name a case: "integrator", "shape") and `name` (where they name a
// scheme). What a measurement throws is a failure of its gate; throws Interrupted alone.
std::vector<GateOutcome> judge_side_by_side(const std::string& kind, const std::string& name,
                                            const std::vector<MeasuredGate>& rows, const SideBySide& how);

}  // namespace plumbline
