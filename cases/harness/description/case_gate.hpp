// What a case demands of its studies, beside the gates that hold for every case.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/harness/description/study_plan.hpp"
#include "cases/harness/verdict/verdict.hpp"

namespace plumbline {

struct StudyResult;

// A gate on a study: which number, and what it must be. Made by gate() and recorded(): judge/gates.hpp.
struct CaseGate {
  std::string study;  // StudyPlan::id
  Gate gate;
  std::vector<double> levels;  // the levels that the number needs; empty: the whole study
  std::function<Measured(const StudyResult&)> measure;
  Tier tier = Tier::quick;
  std::vector<std::string> also = {};  // further studies it compares with, by StudyResult::sibling

  // The same gate on another study than its id says; one that compares with further studies; in this tier and above.
  CaseGate on(std::string other_study) &&;
  CaseGate beside(std::vector<std::string> studies) &&;
  CaseGate in(Tier lowest) &&;
  // The same as one that is expected to fail: why, the band of the wrong value, and date and commit if the band is our own;
  // and, of one that fails, the steps at which a run may stop instead.
  CaseGate fails(std::string cause, Range band, std::string measured_on = {}) &&;
  CaseGate or_stops(StopBand band) &&;
};

}  // namespace plumbline
