// Loading of plug-ins.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cases/harness/commands/command.hpp"
#include "cases/harness/commands/plugin_watch.hpp"

namespace plumbline {

// Loads the plug-ins named among the options, adds their parts and registers their integrators behind a guard: each file is checked
// before anything of it runs (cases/harness/commands/plugin_file.hpp), tried in another process
// (cases/harness/commands/plugin_trial.hpp), and its integrators are watched for as long as the returned object lives; null without
// plug-ins. A file named twice is loaded once. Throws FileError for a file that
// cannot be loaded or is not ours, UsageError for a limit that is none.
std::unique_ptr<PluginWatch> load_plugins(const CommonOptions& options);

// The options by which another process of this program loads the same plug-ins.
std::vector<std::string> plugin_words(const CommonOptions& options);

}  // namespace plumbline
