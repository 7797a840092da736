#include "cases/harness/commands/plugins.hpp"

#include <filesystem>
#include <set>

#include "cases/harness/commands/plugin_file.hpp"
#include "cases/harness/commands/plugin_trial.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/results/fingerprint.hpp"
#include "cases/harness/run/guarded_integrator.hpp"

namespace plumbline {
namespace {

constexpr double shortest_step_limit = 1e-3;  // s

}  // namespace

std::unique_ptr<PluginWatch> load_plugins(const CommonOptions& options) {
  if (options.step_limit && !(*options.step_limit >= shortest_step_limit)) {
    throw UsageError(
        "--step-limit", fmt::format("{}", *options.step_limit), fmt::format(">= {} s", shortest_step_limit), {},
        fmt::format("--step-limit {}: seconds are wanted, at least {}", *options.step_limit, shortest_step_limit));
  }
  if (options.plugins.empty()) return nullptr;
  std::set<std::filesystem::path> known;
  for (const std::string& file : options.plugins) {
    // dlopen searches system folders for a bare name; a plug-in is a file.
    const std::string path = file.find('/') == std::string::npos ? "./" + file : file;
    std::error_code unknown;  // then check_plugin_file says why
    if (const auto place = std::filesystem::canonical(path, unknown); !unknown && !known.insert(place).second) continue;
    check_plugin_file(path, file);
    const Refusals refusals = try_plugin(path, file, options.step_limit.value_or(shortest_limit));
    const PluginEntries entries = load_entries(path, file);
    if (const std::string fault = find_fault(entries); !fault.empty())
      throw FileError(file, fmt::format("plug-in {}: {}", file, fault));
    for (const CollectedPart& part : entries.parts) part.add();
    for (const IntegratorEntry& entry : entries.integrators) {
      const auto refused = refusals.find(entry.name);
      RegisterIntegrator(guarded(entry, refused == refusals.end() ? "" : refused->second));
    }
    add_plugin_to_code(path);
  }
  return std::make_unique<PluginWatch>(options.step_limit, options.json == "-");
}

std::vector<std::string> plugin_words(const CommonOptions& options) {
  std::vector<std::string> words;
  for (const std::string& plugin : options.plugins) words.insert(words.end(), {"--plugin", plugin});
  if (options.step_limit) words.insert(words.end(), {"--step-limit", fmt::format("{}", *options.step_limit)});
  return words;
}

}  // namespace plumbline
