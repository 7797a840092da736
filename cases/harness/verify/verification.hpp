// Whole verifications.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/harness/judge/regressions.hpp"
#include "cases/harness/verify/study_runs.hpp"

namespace plumbline {

struct Verification {
  std::vector<JudgedGate> gates;
  std::vector<NotApplicable> not_applicable;
  int declared = 0;     // gates that cases and integrators have in this tier, and ranges recorded of them
  int regressions = 0;  // gates on recorded values among `gates`
  std::vector<RecordedValue::Key> unrecorded;  // gates of the cases' own studies that pass without a recorded value
  std::vector<RecordedValue::Key>
      lost;  // gates that a case declares or that were recorded of it, and that were not executed
  std::vector<const Case*> entries;
};

// Whether what was executed and what is not applicable is all that is declared: nothing was left out in silence.
bool complete(const Verification& verification);

// What to verify of a case: everything, or the studies of some schemes and the generic gates of some integrators. Keys
// that are set leave the generic gates alone to be judged: the declared numbers hold for the declared choices. `gates`: of all
// these those alone whose names match one of the patterns, on the levels that they need.
struct Selection {
  std::vector<std::string> schemes, integrators, settings;
  bool by_name = false;  // integrators that cannot work with the case are an error, and not merely listed
  const Regressions* recorded = nullptr;  // judged beside the gates, unless keys are set; null: none
  std::vector<std::string> gates = {};
  bool everything() const { return schemes.empty() && integrators.empty() && settings.empty() && gates.empty(); }
  bool takes(const std::string& gate) const;
};

// The names of all gates that a selection may judge, those on recorded values but for their ending.
std::vector<std::string> gate_names(const Case& entry, Tier tier, const Selection& selection);

// The studies of a selection in a tier, those of the integrators last. Throws UsageError for unknown names.
std::vector<StudyPlan> selected_studies(const Case& entry, Tier tier, const Selection& selection);

// All gates of one case in a tier, and those on recorded values; runs and studies go to the store and its folder, but no study
// of which some gates alone were selected. Adds to `verification`. Throws UsageError for unknown names.
void verify_case(const Case& entry, Tier tier, const Selection& selection, int threads, RunStore& store,
                 const Progress& progress, Verification& verification);

// The plan a generic study of an integrator follows: the case's default scheme with it, at the coarsest default level; under
// the transfer flip where the integrator needs rates of change. Throws MissingTraits where it can work with neither.
StudyPlan integrator_plan(const Case& entry, const std::string& integrator);

// "default", or "default+I" for the default scheme with another integrator; likewise for overrides of --set.
std::string integrator_scheme(const Case& entry, const std::string& integrator);

// What results call the scheme of a run with these settings: any scheme's own name but for integrator_scheme.
std::string result_scheme(const Case& entry, const std::string& scheme, const Settings& settings);

}  // namespace plumbline
