// The batches of a sweep on a pool of child processes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cases/harness/verify/plan.hpp"

namespace plumbline {

// Lines that a process with --batch prints of each run.
inline constexpr const char *made_mark = "made ", *kept_mark = "kept ", *failed_mark = "failed ";

struct PoolOptions {
  int jobs = 1;                    // processes at once, >= 1
  std::vector<std::string> words;  // of each process, after --from and --batch
};

struct PoolResult {
  std::size_t made = 0;                       // runs that processes made, or found that others had made
  std::map<std::string, std::string> failed;  // why, by file
  bool files = false;                         // a process ended for a file's sake
  bool misbehaved = false;                    // one ended by what an integrator of a plug-in did
};

// Runs all of them; runs that are missing after their batch has ended are tried once more, each alone. Shows progress on
// standard error. Throws Interrupted after ending the processes.
PoolResult run_pool(const Plan& plan, const PoolOptions& options);

}  // namespace plumbline
