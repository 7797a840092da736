// Numbers that gates judge, taken from a study, and the generic gates that hold for every case and scheme.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/harness/judge/study.hpp"
#include "kernel/traits.hpp"

namespace plumbline {

// A gate with its verdict, as results carry it.
struct JudgedGate {
  Gate gate;
  std::string case_name, scheme, study;
  Measured measured;
  Judgement judgement;
  std::vector<std::string> run_ids;  // files of the runs it read
  std::string explanation = {};      // of a red gate, where its declaration has one: what usually causes it
};

// What could not be judged with an integrator, and what is missing for it.
struct NotApplicable {
  std::string what;  // a gate of an integrator, or a case
  std::string integrator;
  std::vector<Lack> lacks;
};

// A gate's declaration, its quantity to be named by the functions below.
Gate declare(std::string id, Range expected, Origin origin, std::string reason);
// The same as one that is expected to fail: why, the band of the wrong value, and date and commit if the band is our own.
Gate expected_failure(Gate gate, std::string cause, Range band, std::string measured_on = {});
// An earlier measurement of this program, within a share of it: a bug that makes an error smaller is a bug, too. stamp:
// date and commit.
Gate regression(std::string id, double value, double share, const std::string& stamp, std::string reason);

// The error of a measure at one level; its value; its ratio between two levels; its fitted order. A run that stopped or
// lacks the measure says so.
CaseGate error_gate(std::string study, const std::string& measure, double level, Gate gate, Tier tier = Tier::quick);
CaseGate value_gate(std::string study, const std::string& measure, double level, Gate gate, Tier tier = Tier::quick);
// Any number made of a measure and its run at one level.
CaseGate measure_gate(std::string study, Gate gate, const std::string& measure, double level,
                      std::function<Measured(const RunResult&, const Measure&)> read, Tier tier = Tier::quick);
CaseGate ratio_gate(std::string study, const std::string& measure, double level, double over, Gate gate,
                    Tier tier = Tier::quick);
CaseGate order_gate(std::string study, const std::string& measure, Gate gate, Tier tier = Tier::quick);
// The point estimate of the fitted order.
CaseGate fitted_order_gate(std::string study, const std::string& measure, Gate gate, Tier tier = Tier::quick);
// Largest relative drift of the energy ledger over all levels.
CaseGate drift_gate(std::string study, Gate gate, Tier tier = Tier::quick);
// Any number of a whole study.
CaseGate study_gate(std::string study, Gate gate, std::function<Measured(const StudyResult&)> measure,
                    std::vector<double> levels = {}, Tier tier = Tier::quick);

// finite, mass, momentum (and angular momentum from 2-D on, but for axisymmetric scenes), ledger residual: true of every scheme. INVALID on a study
// without runs.
std::vector<CaseGate> generic_gates(const std::string& study, int dim, bool axisymmetric = false);

// Judges the gates whose levels the study has. A gate that throws is INVALID.
std::vector<JudgedGate> judge_gates(const std::vector<CaseGate>& gates, const StudyResult& study);

}  // namespace plumbline
