// Numbers that gates judge, taken from a study, and the generic gates that hold for every case and scheme.
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
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

// A gate is one row: what it is called, which number of its study it judges, what that must be, and why.
//
//   gate("default/density-100", error_at("density.L1", 100), at_most(0.0060), literature("York, Fig. 14")),
//   gate("york1997/converges", ratio_of("density.L1", 800, 400), at_most(0.6), theory("first order gives 0.5"))
//       .fails("more cells mean more crossings", {1.03, 1.15}, "2026-11-23 5825b24"),

// Which number of a study. A run that stopped, and a level or measure that is not there, say so.
struct Number {
  std::string quantity;  // in words
  std::function<Measured(const StudyResult&)> measure;
  std::vector<double> levels = {};  // those it needs; empty: the whole study
  bool interval = false;            // its interval is judged, not the value
};

Number error_at(const std::string& measure, double level);  // of a measure against its reference
Number value_at(const std::string& measure, double level);
Number ratio_of(const std::string& measure, double level, double over);  // of the errors at two levels
Number order_of(const std::string& measure);                             // the interval of the fitted order
Number fitted_order_of(const std::string& measure);                      // its estimate
Number energy_drift();                                                   // the largest relative one over all levels
Number stopped_run();  // whether the study's first run stopped, and where it did, for CaseGate::or_stops
// Made of a measure and its run at one level.
Number number_at(std::string quantity, const std::string& measure, double level,
                 std::function<Measured(const RunResult&, const Measure&)> read);
// Of the whole study, or of these levels.
Number number_of(std::string quantity, std::function<Measured(const StudyResult&)> read,
                 std::vector<double> levels = {});

// Largest difference(here, in the study `as`) of the norms L1, L2 and Linf of these fields at a level; not a number where one
// lacks a norm or the level. The gate runs beside that study, see CaseGate::beside.
Number largest_difference(const std::string& quantity, const std::string& as, double level,
                          const std::vector<std::string>& fields,
                          double (*difference)(const Measure& here, const Measure& there));

// What such a number says of a run that stopped: where, and why. Empty of one that did not.
std::optional<Measured> stop_of(const RunResult& run);

// What it must be.
Range at_most(double high);
Range at_least(double low);
Range between(double low, double high);
Range exactly(double value);

// Why. A recorded value (Origin::regression) has a function of its own below.
struct Because {
  Origin origin;
  std::string reason;
};
Because theory(std::string reason);
Because literature(std::string reason);
Because reference_bound(std::string reason);
Because identity(std::string reason);
Because requirement(std::string reason);
Because reference_run(std::string reason);  // the yardstick is a run of this program made beside it

// `id`: STUDY/NAME, by which it is recorded; on another study by CaseGate::on.
CaseGate gate(std::string id, Number number, Range expected, Because because);

// An earlier measurement of this program, within a share of it: a bug that makes an error smaller is a bug, too. stamp:
// date and commit.
CaseGate recorded(std::string id, Number number, double value, double share, std::string stamp, std::string reason);

// One list after another.
std::vector<CaseGate> joined(std::initializer_list<std::vector<CaseGate>> lists);

// finite, mass, momentum (and angular momentum from 2-D on, but for axisymmetric scenes), ledger residual: true of every
// scheme. INVALID on a study without runs. Of trials, for which dim is 0, finite alone.
std::vector<CaseGate> generic_gates(const std::string& study, int dim, bool axisymmetric = false);

// Judges the gates whose levels the study has. A gate that throws is INVALID.
std::vector<JudgedGate> judge_gates(const std::vector<CaseGate>& gates, const StudyResult& study);

}  // namespace plumbline
