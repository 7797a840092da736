// One run of a case under one set of choices: what came of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/case.hpp"
#include "cases/harness/run/frames.hpp"

namespace plumbline {

// Rows of the ledger over the run, at most 2000 evenly spaced but for the last row and that of the
// largest energy residual.
struct LedgerHistory {
  std::vector<double> step, time;
  struct Series {
    std::string quantity, column;
    std::vector<double> values;
  };
  std::vector<Series> series;
};

struct Stop {
  std::string reason, body, field;
  long step = 0;
  double time = 0;
  int point = 0;
  double value = 0;
};

struct RunResult {
  RunResult(std::string of_case, std::string under_scheme, Settings with)
      : case_name(std::move(of_case)),
        scheme(std::move(under_scheme)),
        settings(std::move(with)) {}

  std::string case_name, scheme;
  Settings settings;
  int dim = 1;  // 0 of a trial, which has neither points nor steps
  bool axisymmetric = false;
  double h = 0;        // cell size, m
  double dt = 0;       // mean step, s
  double courant = 0;  // of the first step: dt over what cfl = 1 allows
  bool finished = false;
  std::optional<Stop> stop;
  long steps = 0, points = 0;
  int doubles_per_point = 0;
  double end_time = 0;  // s
  double wall_s = 0;    // stepping alone
  Ledger ledger;
  LedgerHistory history;
  std::vector<Measure> measures;  // empty if stopped
  Profile profile;
  FrameSet frames;   // as asked for
  std::string file;  // its name in a results folder

  const Measure* find(const std::string& measure) const;
  double particle_steps_per_s() const {
    return wall_s > 0 ? static_cast<double>(points) * static_cast<double>(steps) / wall_s : 0;
  }
};

// A run under way: all that makes it go on to the same bits, for the same settings under the same code.
struct RunState {
  long step = 0;
  double time = 0;    // s
  double wall_s = 0;  // stepping until then
  Archive::Table numbers;
};

// States that a run is asked for on its way, and the one from which it goes on.
struct RunStates {
  const RunState* from = nullptr;                      // null: the start
  std::function<bool(const Simulation&)> wanted = {};  // before the first step and after each one
  std::function<void(const RunState&)> keep = {};      // each that is wanted
};

// The step control that the settings ask for; one of dt and cfl is set.
StepControl step_control(const Settings& settings);

// Runs it, or makes the trial; the loops over points on `threads` threads. A stop on an inadmissible state is a result; throws Interrupted if
// a signal arrives, ArchiveError if it cannot go on from the state given. No number depends on the frames and states that
// are asked for.
RunResult run_experiment(const Case& entry, const std::string& scheme, const Settings& settings, int threads = 1,
                         const FrameRequest& frames = {}, const RunStates& states = {});

}  // namespace plumbline
