// Reading plans, which people write too: every fault is told with its place.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>

#include "cases/harness/files/input_file.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/nearest.hpp"
#include "cases/harness/verify/plan.hpp"

namespace plumbline {
namespace {

constexpr std::size_t most_runs = 100000;

std::string shown(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  const std::string text = json_text(value);
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

UsageError fault(const std::string& place, const Json& value, const std::string& allowed) {
  return {place, shown(value), allowed, {}, fmt::format("plan: {} is {}, wanted is {}", place, shown(value), allowed)};
}

// The same error, told with the place in the plan.
UsageError at(const std::string& place, const UsageError& error) {
  return {error.key, error.value, error.allowed, error.nearest, fmt::format("plan: {}: {}", place, error.what())};
}

void require_keys(const std::string& place, const Json& object, const std::vector<std::string>& known) {
  if (!object.is_object()) throw fault(place, object, "an object");
  for (const auto& [key, value] : object.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) throw at(place, unknown_name("key", key, known));
  }
}

const Json& list(const std::string& place, const Json& value) {
  if (!value.is_array() || value.empty()) throw fault(place, value, "a list of one or more");
  return value;
}

std::string text(const std::string& place, const Json& value) {
  if (!value.is_string()) throw fault(place, value, "a name");
  return value.get<std::string>();
}

int whole_number(const std::string& place, const Json& value, int low, int high) {
  const std::string allowed = fmt::format("a whole number in [{}, {}]", low, high);
  if (!value.is_number()) throw fault(place, value, allowed);
  const double number = value.get<double>();
  if (number != std::floor(number) || !(number >= low && number <= high)) throw fault(place, value, allowed);
  return static_cast<int>(number);
}

FrameRequest frames_from(const std::string& place, const Json& value) {
  if (value.is_null()) return {};
  if (!value.is_object()) return {whole_number(place, value, 2, most_frames), 0};
  require_keys(place, value, {"count", "most_points"});
  FrameRequest frames;
  frames.count = whole_number(place + ".count", value.value("count", Json()), 2, most_frames);
  frames.most_points = whole_number(place + ".most_points", value.value("most_points", Json(0)), 0, 1 << 30);
  return frames;
}

// Choices of a run, as --set takes them: names as typed, numbers with all their digits.
struct Choices {
  std::vector<Override> numbers;
  std::vector<std::string> typed;

  void add(const std::string& place, const std::string& key, const Json& value) {
    if (value.is_number()) {
      numbers.emplace_back(key, value.get<double>());
    } else if (value.is_string()) {
      typed.push_back(key + "=" + value.get<std::string>());
    } else {
      throw fault(place, value, "a number or a name");
    }
  }
};

PlanRun resolved(const std::string& place, const std::string& case_name, const std::string& scheme,
                 const Choices& choices, const FrameRequest& frames) {
  try {
    const Case& entry = find_case(case_name);
    return planned_run(entry, scheme, entry.settings(scheme, choices.numbers, choices.typed), frames);
  } catch (const UsageError& error) {
    throw at(place, error);
  }
}

PlanRun run_from(const std::string& place, const Json& run) {
  require_keys(place, run, {"case", "scheme", "study", "cells", "settings", "frames", "file"});
  if (!run.contains("case")) throw fault(place + ".case", nullptr, "the name of a case");
  const Json settings = run.value("settings", Json::object());
  if (!settings.is_object()) throw fault(place + ".settings", settings, "an object of keys and values");
  Choices choices;
  if (run.contains("cells") && !run["cells"].is_null()) {
    choices.add(place + ".cells", "cells", run["cells"]);
    if (settings.contains("cells") && settings["cells"] != run["cells"])
      throw fault(place + ".settings.cells", settings["cells"], "the same as cells, or left out");
  }
  for (const auto& [key, value] : settings.items()) choices.add(place + ".settings." + key, key, value);
  PlanRun made = resolved(place, text(place + ".case", run["case"]),
                          text(place + ".scheme", run.value("scheme", Json("default"))), choices,
                          frames_from(place + ".frames", run.value("frames", Json())));
  made.study = text(place + ".study", run.value("study", Json("")));
  if (run.contains("file") && text(place + ".file", run["file"]) != made.file) {
    throw UsageError("file", shown(run["file"]), made.file, {made.file},
                     fmt::format("plan: {}: these choices make {} here, not {}: the plan is of a version with other "
                                 "keys or defaults, make it anew",
                                 place, made.file, shown(run["file"])));
  }
  return made;
}

// One value of each key of a product, chosen by the digits of `index`.
PlanRun run_of_product(const std::string& place, const Json& product, std::size_t index) {
  std::string case_name, scheme = "default";
  FrameRequest frames;
  Choices choices;
  std::string chosen;
  for (const auto& [key, values] : product.items()) {
    const Json& value = values.is_array() ? values[index % values.size()] : values;
    index /= values.is_array() ? values.size() : 1;
    const std::string at_key = place + "." + key;
    chosen += fmt::format("{}{} {}", chosen.empty() ? "" : ", ", key, shown(value));
    if (key == "case") {
      case_name = text(at_key, value);
    } else if (key == "scheme") {
      scheme = text(at_key, value);
    } else if (key == "frames") {
      frames = frames_from(at_key, value);
    } else {
      choices.add(at_key, key, value);
    }
  }
  return resolved(fmt::format("{} ({})", place, chosen), case_name, scheme, choices, frames);
}

std::vector<PlanRun> runs_of_product(const std::string& place, const Json& product) {
  if (!product.is_object()) throw fault(place, product, "an object of keys with lists of values");
  if (!product.contains("case")) throw fault(place + ".case", nullptr, "one or more names of cases");
  std::size_t count = 1;
  for (const auto& [key, values] : product.items()) {
    if (values.is_array()) count *= list(place + "." + key, values).size();
    if (count > most_runs) {
      throw UsageError(place, "more", fmt::to_string(most_runs), {},
                       fmt::format("plan: {} makes more than {} runs", place, most_runs));
    }
  }
  std::vector<PlanRun> runs;
  for (std::size_t k = 0; k < count; ++k) runs.push_back(run_of_product(place, product, k));
  return runs;
}

std::vector<PlanRun> runs_of_list(const std::string& place, const Json& entries) {
  std::vector<PlanRun> runs;
  std::size_t k = 0;
  for (const Json& run : list(place, entries)) runs.push_back(run_from(fmt::format("{}[{}]", place, k++), run));
  return runs;
}

std::string read_all(const std::string& name) {
  if (name == "-") return read_text(std::cin, "standard input");
  std::error_code none;
  if (!std::filesystem::is_fifo(name, none)) return read_text_file(name);
  std::ifstream pipe(name, std::ios::binary);  // what a shell makes of `--from <(program)`
  if (!pipe) throw FileError(name, fmt::format("{}: cannot be read", name));
  return read_text(pipe, name);
}

Batch batch_from(const std::string& place, const Json& written) {
  require_keys(place, written, {"id", "size", "estimated_s", "memory_mb", "runs"});
  Batch batch;
  batch.id = text(place + ".id", written.value("id", Json()));
  const Json size = written.value("size", Json("small"));
  if (size != "small" && size != "large") throw at(place, unknown_name("size", shown(size), {"small", "large"}));
  batch.large = size == "large";
  const auto amount = [&](const char* key) {
    const Json value = written.value(key, Json(0));
    if (!value.is_number() || !(value.get<double>() >= 0)) throw fault(place + "." + key, value, "a number >= 0");
    return value.get<double>();
  };
  batch.estimated_s = amount("estimated_s");
  batch.memory_mb = amount("memory_mb");
  batch.runs = runs_of_list(place + ".runs", written.value("runs", Json()));
  return batch;
}

}  // namespace

PlanDocument::PlanDocument(const std::string& name) {
  try {
    document_ = parse_json(read_all(name));
  } catch (const Json::exception& error) {
    throw UsageError("--from", name, "JSON", {}, fmt::format("plan {}: no JSON: {}", name, fault_of(error)));
  }
  if (!document_.is_object()) throw fault("the document", document_, "an object");
  const Json format = document_.value("plan", Json(plan_format));
  if (format.is_number() && format.get<double>() > plan_format)
    throw FileError(name, fmt::format("{}: a plan of format {}, made by a newer version", name, shown(format)));
  if (format != plan_format) throw fault("plan", format, fmt::to_string(plan_format));
  require_keys("the document", document_, {"plan", "tier", "batches", "runs", "sweep"});
  const auto kinds = document_.contains("batches") + document_.contains("runs") + document_.contains("sweep");
  if (kinds != 1) throw fault("the document", document_, "an object with one of batches, runs, sweep");
  const std::vector<std::string> tiers{"quick", "full", "none"};
  if (const std::string given = tier(); std::find(tiers.begin(), tiers.end(), given) == tiers.end())
    throw unknown_name("tier", given, tiers);
  if (!has_batches()) return;
  std::set<std::string> seen;
  for (const std::string& id : batch_ids()) {
    if (!seen.insert(id).second) throw fault("batches", id, "batches with different ids");
  }
}

std::string PlanDocument::tier() const { return text("tier", document_.value("tier", Json("none"))); }

std::vector<std::string> PlanDocument::batch_ids() const {
  std::vector<std::string> ids;
  if (!has_batches()) return ids;
  std::size_t k = 0;
  for (const Json& written : list("batches", document_["batches"])) {
    const std::string place = fmt::format("batches[{}]", k++);
    if (!written.is_object()) throw fault(place, written, "an object");
    ids.push_back(text(place + ".id", written.value("id", Json())));
  }
  return ids;
}

std::vector<PlanRun> PlanDocument::runs() const {
  std::vector<PlanRun> runs;
  if (document_.contains("runs")) runs = runs_of_list("runs", document_["runs"]);
  if (document_.contains("sweep")) runs = runs_of_product("sweep", document_["sweep"]);
  for (Batch& batch : batches()) runs.insert(runs.end(), batch.runs.begin(), batch.runs.end());
  return each_once(std::move(runs));
}

std::vector<Batch> PlanDocument::batches() const {
  std::vector<Batch> batches;
  const std::vector<std::string> ids = batch_ids();
  for (std::size_t k = 0; k < ids.size(); ++k)
    batches.push_back(batch_from(fmt::format("batches[{}]", k), document_["batches"][k]));
  return batches;
}

Batch PlanDocument::batch(const std::string& id) const {
  const std::vector<std::string> ids = batch_ids();
  if (ids.empty()) {
    throw UsageError("--batch", id, "a plan with batches", {},
                     "this plan has no batches: `plumbline sweep --from FILE --plan FILE` makes them");
  }
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) throw unknown_name("batch", id, ids);
  const std::size_t k = static_cast<std::size_t>(found - ids.begin());
  return batch_from(fmt::format("batches[{}]", k), document_["batches"][k]);
}

}  // namespace plumbline
