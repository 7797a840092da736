// Where a result comes from.
#pragma once

#include <map>
#include <string>

namespace plumbline {

struct Provenance {
  std::string version, git;
  bool dirty = false;
  std::string fingerprint;  // of the code that made the numbers; cases/harness/results/fingerprint.hpp
  std::string compiler, flags, cpu, instruction_set;
  int threads = 1;
  bool fused = true;  // several stages of a step in one pass over the points
  std::map<std::string, std::string> libraries;
  std::string command;  // as typed, without what only says where results go
  std::string started;  // UTC, ISO 8601
};

// Fills everything but threads and command.
Provenance build_provenance();

// The command line with "plumbline" for the program and without --results and --json: relative, and fit for the report.
std::string stored_command(int argc, const char* const* argv);

}  // namespace plumbline
