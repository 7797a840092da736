// A run that is stopped on its way and taken up again from its file, everything made anew, must end with the same bits.
#pragma once

#include <string>

#include "cases/harness/judge/gates.hpp"

namespace plumbline {

// How a run that was taken up again differs from one that was not.
struct RestartDifference {
  // Of points, ledger and its rows, measures, profile, and what the problem and the integrator keep; none if the run ended
  // before its checkpoint.
  long compared = 0;
  long numbers = 0;   // of those, how many have other bits; where there are more or fewer of a kind, all of them
  std::string first;  // the name of the first; empty if there is none
};

// Runs it twice: to the end, with a checkpoint written to a file at the first step that reaches `share` (0 ... 1) of the end
// time, and from that file to the end. Throws FileError where temporary files cannot be written.
RestartDifference restart_difference(const Case& entry, const std::string& scheme, const Settings& settings,
                                     double share);

// No number of the study's first level, under further overrides, differs after a restart half-way. `what`: of which kind of
// run it is the proof. Its id is `study`/restart`suffix`.
CaseGate restart_gate(const std::string& study, const std::string& what, std::vector<Override> overrides = {},
                      const std::string& suffix = "");

}  // namespace plumbline
