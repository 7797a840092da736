// Other programs behind adapters: `adapter CASE.h5 RESULT.h5`, as reports/docs/how-to/score-another-code.md says.
#pragma once

#include <string>

#include "cases/harness/commands/command.hpp"
#include "cases/harness/exchange/score_folder.hpp"

namespace plumbline {

struct Adapter {
  std::string name;  // of the program: letters, digits and ._+-
  std::string path;  // of an executable file
};

// From "NAME=PATH". Throws UsageError for a name that is none and a path that cannot be executed.
Adapter adapter_from(const std::string& typed);

// Runs it on every start of the folder, one after another, and leaves beside each result what it printed and how it ended. What a
// failed or late adapter wrote is removed. `timeout` in s. Throws FileError, Interrupted.
void run_adapter(const Adapter& adapter, const ScoreFolder& folder, double timeout, const Output& out);

}  // namespace plumbline
