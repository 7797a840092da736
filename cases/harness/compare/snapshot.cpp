#include "cases/harness/compare/snapshot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>

#include "cases/harness/files/hdf5_file.hpp"
#include "cases/harness/files/input_file.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/nearest.hpp"
#include "cases/harness/results/results.hpp"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

const Json& member(const Json& object, const char* key) {
  static const Json nothing = nullptr;
  const auto found = object.find(key);
  return found == object.end() ? nothing : *found;
}

std::optional<double> number(const Json& object, const char* key) {
  const Json& value = member(object, key);
  return value.is_null() ? std::nullopt : std::optional<double>(value.get<double>());
}

std::string text(const Json& object, const char* key) {
  const Json& value = member(object, key);
  return value.is_null() ? std::string() : value.get<std::string>();
}

Range range(const Json& value) { return {number(value, "low"), number(value, "high")}; }

std::vector<Range> ranges(const Json& list) {
  std::vector<Range> all;
  for (const Json& item : list) all.push_back(range(item));
  return all;
}

// What orders, limits and costs may hang on beside the sources.
std::map<std::string, std::string> machine_of(const Json& provenance) {
  std::map<std::string, std::string> machine;
  for (const char* key : {"cpu", "instruction_set", "compiler", "flags"}) {
    if (const std::string value = text(provenance, key); !value.empty()) machine[key] = value;
  }
  return machine;
}

void take_provenance(const Json& provenance, Snapshot& snapshot) {
  const std::string started = text(provenance, "started");
  if (provenance.is_null() || (started <= snapshot.started && !snapshot.started.empty())) return;
  snapshot.started = started;
  snapshot.machine = machine_of(provenance);
  snapshot.version = text(provenance, "version");
  snapshot.git = text(provenance, "git") + (member(provenance, "dirty") == Json(true) ? ", modified" : "");
}

FitRecord fit_record(const Json& fit) {
  FitRecord record{
      number(fit, "order"), number(fit, "order_low"), number(fit, "order_high"), number(fit, "constant"), {}};
  for (const Json& used : member(fit, "levels_used")) record.used.push_back(used.get<bool>());
  return record;
}

LevelRecord level_record(const Json& level) {
  LevelRecord record;
  record.value = number(level, "value").value_or(unknown);
  record.h = number(level, "h").value_or(unknown);
  record.finished = level.at("finished").get<bool>();
  if (const Json& stop = member(level, "stop"); !stop.is_null())
    record.stop = fmt::format("stopped at step {}: {}", stop.at("step").get<long>(), text(stop, "reason"));
  for (const auto& [name, measure] : level.at("measures").items()) {
    ErrorRecord error;
    error.error = number(measure, "error").value_or(unknown);
    const double relative = number(measure, "relative_error").value_or(0);
    error.scale = relative > 0 ? error.error / relative : 0;
    error.reference_bound = number(measure, "reference_bound").value_or(0);
    record.errors[name] = error;
  }
  return record;
}

bool same_values(const StudyRecord& a, const StudyRecord& b) { return a.values() == b.values(); }

Json parsed(const std::string& file, const std::string& content) {
  try {
    return parse_json(content);
  } catch (const nlohmann::json::exception& error) {
    throw FileError(file, "not JSON: " + fault_of(error));
  }
}

Json part(const std::string& file, const std::string& path) { return parsed(file, read_hdf5_text(file, path)); }

Json json_file(const std::string& file) { return parsed(file, read_text_file(file)); }

void require_known_format(const std::string& file) {
  const std::int64_t format = read_hdf5_integer(file, "/", "plumbline_format");
  if (format > results_format)
    throw FileError(file,
                    fmt::format("format {}, made by a newer version; this one reads up to {}", format, results_format));
}

// The names of the folders beside the one that is not there.
std::vector<std::string> neighbours(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code ignored;
  const fs::path parent = folder.parent_path();
  for (const auto& entry : fs::directory_iterator(parent.empty() ? fs::path(".") : parent, ignored)) {
    if (entry.is_directory(ignored)) names.push_back((parent / entry.path().filename()).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Calls read(); what goes wrong makes the file a damaged one.
void attempt(const fs::path& file, Snapshot& snapshot, const std::function<void()>& read) {
  const std::string name = file.filename().string();
  try {
    read();
  } catch (const FileError& error) {
    std::string why = error.what();
    if (why.rfind(file.string() + ": ", 0) == 0) why.erase(0, file.string().size() + 2);
    snapshot.damaged.emplace_back(name, why);
  } catch (const nlohmann::json::exception& error) {
    snapshot.damaged.emplace_back(name, fmt::format("not of the shape expected: {}", error.what()));
  }
}

void read_file(const fs::path& file, Snapshot& snapshot) {
  const std::string name = file.filename().string(), path = file.string();
  if (name.rfind("study-", 0) == 0 && file.extension() == ".h5") {
    attempt(file, snapshot, [&] {
      require_known_format(path);
      Json study = part(path, "/study");
      study["provenance"] = part(path, "/provenance");
      take_study(study, name, snapshot);
    });
  } else if (name.rfind("verdicts-", 0) == 0 && file.extension() == ".h5") {
    attempt(file, snapshot, [&] {
      require_known_format(path);
      take_verdicts(part(path, "/verdicts"), part(path, "/provenance"), snapshot);
    });
  } else if (name == "stability.json") {
    attempt(file, snapshot, [&] { take_stability(json_file(path), snapshot); });
  } else if (name == "cost.json") {
    attempt(file, snapshot, [&] { take_costs(json_file(path), snapshot); });
  }
}

}  // namespace

std::vector<double> StudyRecord::values() const {
  std::vector<double> all;
  for (const LevelRecord& level : levels) all.push_back(level.value);
  return all;
}

StudyRecord::Key StudyRecord::key() const {
  std::string choices;
  if (id.empty() || id == "study") {
    for (const auto& [key, value] : settings) choices += key + "=" + value + " ";
  }
  return {case_name, scheme, id, vary, choices};
}

void take_verdicts(const Json& verdicts, const Json& provenance, Snapshot& snapshot) {
  const std::string started = text(provenance, "started"), tier = text(verdicts, "tier");
  for (const Json& gate : verdicts.at("gates")) {
    GateRecord record;
    record.tier = tier;
    record.case_name = gate.at("case").get<std::string>();
    record.scheme = text(gate, "scheme");
    record.study = text(gate, "study");
    record.id = gate.at("id").get<std::string>();
    record.quantity = text(gate, "quantity");
    record.verdict = verdict_from(text(gate, "verdict")).value_or(Verdict::invalid);
    record.bounds.expected = range(gate.at("expected"));
    if (const Json& band = member(gate, "band"); !band.is_null()) record.bounds.band = range(band);
    record.measured = number(gate, "measured");
    record.started = started;
    const auto [place, is_new] = snapshot.gates.try_emplace(record.key(), record);
    if (!is_new && place->second.started <= started) place->second = std::move(record);
  }
  take_provenance(provenance, snapshot);
}

void take_study(const Json& study, const std::string& file, Snapshot& snapshot) {
  StudyRecord record;
  record.case_name = study.at("case").get<std::string>();
  record.scheme = study.at("scheme").get<std::string>();
  record.id = text(study, "id");
  record.vary = study.at("vary").get<std::string>();
  record.file = file;
  record.started = text(member(study, "provenance"), "started");
  for (const auto& [key, value] : study.at("settings").items()) {
    if (key != "cells" && key != "h" && key != record.vary) record.settings[key] = json_text(value);
  }
  for (const Json& level : study.at("levels")) record.levels.push_back(level_record(level));
  for (const auto& [measure, fit] : study.at("measures").items()) record.fits[measure] = fit_record(fit);
  take_provenance(member(study, "provenance"), snapshot);
  std::vector<StudyRecord>& rivals = snapshot.studies[record.key()];
  for (StudyRecord& rival : rivals) {
    if (!same_values(rival, record)) continue;
    if (std::tie(rival.started, rival.file) < std::tie(record.started, record.file)) rival = std::move(record);
    return;
  }
  rivals.push_back(std::move(record));
}

void take_stability(const Json& document, Snapshot& snapshot) {
  if (!document.contains("problems")) {
    take_stability(Json{{"problems", Json::array({document})}}, snapshot);
    return;
  }
  for (const Json& problem : document.at("problems")) {
    for (const Json& found : problem.at("configurations")) {
      LimitRecord record;
      record.problem = problem.at("problem").get<std::string>();
      record.integrator = found.at("integrator").get<std::string>();
      record.scheme = text(found, "scheme");
      for (const auto& [key, value] : found.at("settings").items())
        record.settings += (record.settings.empty() ? "" : " ") + key + "=" +
                           (value.is_string() ? value.get<std::string>() : json_text(value));
      record.unit = text(found, "unit");
      record.always = text(found, "always");
      record.predicted = ranges(found.at("predicted"));
      record.observed = ranges(found.at("observed"));
      for (const auto& [quantity, fit] : member(found, "orders").items())
        record.orders[quantity] = {number(fit, "order"), number(fit, "low"), number(fit, "high"), {}, {}};
      snapshot.limits[record.key()] = std::move(record);
    }
  }
}

void take_costs(const Json& document, Snapshot& snapshot) {
  for (const Json& run : document.at("runs")) {
    if (text(run, "source") == "stored") continue;  // its time is of another run than the repeated ones
    CostRecord record;
    record.case_name = run.at("case").get<std::string>();
    record.scheme = run.at("scheme").get<std::string>();
    record.study = text(run, "study");
    record.vary = text(run, "vary");
    record.value = number(run, "value").value_or(0);
    record.cells = number(run, "cells").value_or(0);
    record.wall_s = run.at("wall_s").get<std::vector<double>>();
    record.instructions = number(run, "instructions");
    record.particle_steps = number(
        run, run.contains("particle_steps") ? "particle_steps" : "point_steps");  // its name to 0.6.0
    snapshot.costs[record.key()].push_back(std::move(record));
  }
  snapshot.timed_machine = machine_of(document.at("machine"));
}

Snapshot read_snapshot(const std::string& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    const std::string trimmed = fs::path(folder + "/").parent_path().string();  // without the separator at its end
    const std::vector<std::string> offers = nearest(trimmed, neighbours(trimmed));
    throw UsageError("results folder", trimmed, "an existing folder", offers,
                     trimmed + ": no such results folder" +
                         (offers.empty() ? "" : fmt::format("; did you mean {}?", fmt::join(offers, ", "))));
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Snapshot snapshot;
  snapshot.folder = folder;
  for (const fs::path& file : files) read_file(file, snapshot);
  if (snapshot.empty() && snapshot.damaged.empty()) {
    throw UsageError("results folder", folder, "a folder that verify, converge, stability or bench wrote to", {},
                     folder +
                         ": nothing in this folder can be compared (no study or verdict file, no stability.json, "
                         "no cost.json)");
  }
  return snapshot;
}

}  // namespace plumbline
