#include "cases/harness/exchange/start_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "cases/harness/exchange/exchange.hpp"
#include "cases/harness/exchange/final_state.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/hdf5_file.hpp"
#include "cases/harness/files/json_text.hpp"

namespace plumbline {
namespace {

// Beside `cells` and the case's own keys: what places the points, whatever the scheme does with them.
constexpr std::array placing{"ppc", "points", "offset"};

bool belongs_to_start(const Case& entry, const std::string& key) {
  const auto own = entry.keys;
  return std::find(placing.begin(), placing.end(), key) != placing.end() ||
         std::any_of(own.begin(), own.end(), [&](const Key& k) { return k.name == key; });
}

std::string text_of(const Json& value) {
  if (value.is_null()) return to_text(Value());
  return value.is_number() ? to_text(Value(value.get<double>())) : value.get<std::string>();
}

std::vector<std::string> choices_of(const Case& entry, const Json& settings, int cells) {
  const Settings usual = entry.settings("default", {{"cells", static_cast<double>(cells)}});
  std::vector<std::string> typed;
  for (const Key& key : usual.keys()) {
    if (!belongs_to_start(entry, key.name) || !settings.contains(key.name)) continue;
    const std::string value = text_of(settings.at(key.name));
    if (value != to_text(key.value)) typed.push_back(key.name + "=" + value);
  }
  return typed;
}

void require_known_physics(const Start& start, const Json& description, const std::string& path) {
  const Settings settings = start.settings();
  if (const std::string refused = why_not_scored(*start.entry, settings); !refused.empty()) {
    throw UsageError("case", start.entry->name, "a case that `plumbline list` shows as scored", {},
                     fmt::format("{}: {} cannot be scored: {}", path, start.entry->name, refused));
  }
  const std::string id = problem_id(*start.entry, settings), stated = description.at("problem");
  if (stated != id) {
    throw UsageError(
        "problem", stated, id, {},
        fmt::format("{}: problem is {}, and {} here: the case has changed since; export it anew", path, stated, id));
  }
}

}  // namespace

Settings Start::settings() const { return entry->settings("default", {{"cells", static_cast<double>(cells)}}, typed); }

Start read_start(const std::string& path) {
  try {
    const Json description = parse_json(read_hdf5_text(path, "/description"));
    if (description.at("kind") != "initial-state" || description.at("exchange_format") != exchange_format) {
      throw FileError(path, fmt::format("{}: not a start of exchange_format {}", path, exchange_format));
    }
    Start start;
    start.name = std::filesystem::path(path).filename().string();
    start.entry = &find_case(description.at("case").get<std::string>());
    start.cells = description.at("cells");
    start.typed = choices_of(*start.entry, description.at("settings"), start.cells);
    require_known_physics(start, description, path);
    return start;
  } catch (const Json::exception& error) {
    throw FileError(path, fmt::format("{}: its description is damaged: {}", path, fault_of(error)));
  }
}

}  // namespace plumbline
