// Judging an integrator: its gates measured side by side, with a verdict each.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/integrators/integrator_gates.hpp"
#include "cases/harness/verify/verification.hpp"

namespace plumbline {

struct JudgedIntegrator {
  std::string integrator;
  std::vector<JudgedGate> gates;  // in the order of the rows
  std::vector<NotApplicable> not_applicable;
  int declared = 0;  // gates and what is not applicable; more where judging ended at the first red one
};

struct JudgingOptions {
  Effort effort = Effort::whole;
  int threads = 1;         // no number depends on it
  bool until_red = false;  // no gate is begun after one that is red
};

// Core gates first. What a step throws is a failure of the gate that took the step; throws Interrupted alone.
JudgedIntegrator judge_integrator(const Subject& subject, const JudgingOptions& options,
                                  const JudgingProgress& progress = {});

// Whether a gate makes the exit status red. One of an integrator that is inconclusive does not.
bool is_red(const JudgedGate& gate, bool allow_inconclusive = false);

}  // namespace plumbline
