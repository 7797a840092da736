// Numbers and gates that coupled cases have in common.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "cases/harness/description/settings.hpp"
#include "cases/harness/judge/gates.hpp"

namespace plumbline {

// The value of a measure. Throws std::runtime_error where the run has none.
inline double value_of(const RunResult& run, const std::string& measure) {
  const Measure* found = run.find(measure);
  if (!found || !found->value) throw std::runtime_error("a run has no " + measure);
  return *found->value;
}

// The value at a level over that of another study's run at the same level: for gates beside that study.
inline Number over_that_of(const std::string& other, const std::string& measure, double level, std::string quantity) {
  const auto ratio = [=](const StudyResult& s) {
    const StudyLevel* there = s.sibling(other)->level(level);
    if (!there) throw std::runtime_error("the study " + other + " has no level " + to_text(level));
    return Measured::of(value_of(s.level(level)->run, measure) / value_of(there->run, measure));
  };
  return number_of(std::move(quantity), ratio, {level});
}

inline CaseGate closed_ledger_gate(const std::string& study) {
  return gate(study + "/energy", energy_drift(), at_most(1e-10),
              identity("the step closes the energy ledger to rounding, which adds up over the steps"));
}

}  // namespace plumbline
