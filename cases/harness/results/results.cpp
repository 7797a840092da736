#include "cases/harness/results/results.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "cases/harness/files/hdf5_file.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/text_file.hpp"
#include "cases/harness/results/frames_file.hpp"

namespace plumbline {
namespace {

void begin(Hdf5Writer& file, const std::string& kind, const Provenance& provenance) {
  file.attribute("/", "plumbline_format", std::int64_t{results_format});
  file.attribute("/", "kind", kind);
  file.text("/provenance", json_text(to_json(provenance)));
}

// /comparator/<name>: a table of levels.
void write_comparator(Hdf5Writer& file, const Comparator& comparator) {
  const std::string group = "/comparator/" + comparator.name;
  const auto column = [&](const std::string& name, auto read) {
    std::vector<double> values;
    for (const Comparator::Level& at : comparator.levels) values.push_back(static_cast<double>(read(at)));
    file.numbers(group + "/" + name, values);
  };
  column("cells", [](const Comparator::Level& at) { return at.cells; });
  column("steps", [](const Comparator::Level& at) { return at.steps; });
  column("cell_steps", [](const Comparator::Level& at) { return at.cell_steps; });
  column("wall_s", [](const Comparator::Level& at) { return at.wall_s; });
  for (std::size_t k = 0; !comparator.levels.empty() && k < comparator.levels.front().errors.size(); ++k) {
    column(comparator.levels.front().errors[k].first, [k](const Comparator::Level& at) { return at.errors[k].second; });
  }
  file.attribute(group, "title", comparator.title);
}

// Of a study in cells of the default scheme as it is; other studies would repeat the same table.
std::vector<Comparator> comparators_of(const StudyResult& study) {
  const bool main = study.plan.vary == Vary::cells && study.plan.scheme == "default" && study.plan.overrides.empty();
  if (!main || study.levels.empty() || !study.entry->comparators) return {};
  std::vector<double> cells;
  for (const StudyLevel& at : study.levels) cells.push_back(at.value);
  return study.entry->comparators(study.levels.front().run.settings, cells);
}

}  // namespace

ResultsFolder::ResultsFolder(std::string path) : path_(std::move(path)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error || !std::filesystem::is_directory(path_)) {
    throw FileError(
        path_, fmt::format("{}: cannot be made a results folder: {}", path_, error ? error.message() : "it is a file"));
  }
  const std::string probe = temporary_name(path_ + "/probe");
  if (!std::ofstream(probe)) throw FileError(path_, fmt::format("{}: cannot be written to", path_));
  std::filesystem::remove(probe, error);
  remove_abandoned(path_);
}

std::string ResultsFolder::run_name(const RunResult& run) { return run_name(run.case_name, run.scheme, run.settings); }

std::string ResultsFolder::run_name(const std::string& case_name, const std::string& scheme, const Settings& settings) {
  const std::string which = settings.has("cells") ? std::to_string(settings.integer("cells")) : settings.text("trial");
  return fmt::format("{}-{}-{}-{}.h5", case_name, scheme, which,
                     short_hash(case_name + "\n" + scheme + "\n" + settings.canonical()));
}

std::string ResultsFolder::study_name(const StudyResult& study) {
  std::string content = study.entry->name + "\n" + study.scheme + "\n" + study.plan.id + "\n";
  for (const StudyLevel& at : study.levels) content += at.run.settings.canonical();
  return fmt::format("study-{}-{}-{}-{}.h5", study.entry->name, study.scheme, name(study.plan.vary),
                     short_hash(content));
}

void ResultsFolder::write_run(const RunResult& run, const std::vector<JudgedGate>& gates, const Provenance& provenance,
                              const Making& making) const {
  Hdf5Writer file(path_ + "/" + run.file);
  begin(file, "run", provenance);
  file.text("/run", json_text(run_document(run, gates, provenance)));
  file.text("/measures", json_text(to_json(run.measures)));
  file.text("/settings", json_text(to_json(run.settings)));
  file.text("/gates", json_text(to_json(gates)));
  std::string quantity;
  for (const LedgerHistory::Series& series : run.history.series) {
    if (series.quantity != quantity) {
      quantity = series.quantity;
      file.numbers("/ledger/" + quantity + "/time", run.history.time);
      file.numbers("/ledger/" + quantity + "/step", run.history.step);
    }
    file.numbers("/ledger/" + series.quantity + "/" + series.column, series.values);
  }
  file.group("/profile");
  file.attribute("/profile", "abscissa", run.profile.abscissa);
  file.attribute("/profile", "kind", run.profile.kind);
  for (const ProfileColumn& column : run.profile.columns) {
    const std::string path = "/profile/" + column.name;
    file.numbers(path, column.values);
    file.attribute(path, "unit", column.unit);
    file.attribute(path, "label", column.label);
  }
  write_frames(file, run.frames);
  write_restore(file, run, provenance.fingerprint, making);
  file.commit();
}

namespace {

void require_readable(const Hdf5Reader& file) {
  const std::int64_t format = file.attribute("/", "plumbline_format");
  if (format > results_format)
    throw FileError(file.name(), fmt::format("{}: of format {}, made by a newer version", file.name(), format));
}

}  // namespace

std::optional<Stored> ResultsFolder::read_stored(const std::string& file) const {
  const Hdf5Reader reader(path_ + "/" + file);
  require_readable(reader);
  return plumbline::read_stored(reader);
}

std::optional<RunResult> ResultsFolder::read_run(const std::string& file, const std::string& fingerprint) const {
  const Hdf5Reader reader(path_ + "/" + file);
  require_readable(reader);
  const std::optional<Stored> stored = plumbline::read_stored(reader);
  if (!stored || fingerprint.empty() || stored->fingerprint != fingerprint) return std::nullopt;
  RunResult run = read_restore(reader);
  if (run.file != file) throw FileError(reader.name(), fmt::format("{}: holds {}", reader.name(), run.file));
  return run;
}

void ResultsFolder::write_study(StudyResult& study, const std::vector<JudgedGate>& gates,
                                const Provenance& provenance) const {
  study.file = study_name(study);
  Hdf5Writer file(path_ + "/" + study.file);
  begin(file, "study", provenance);
  Json document = study_document(study, gates, provenance);
  document["case"] = study.entry->name;
  file.text("/study", json_text(document));
  file.text("/fit", json_text(document["measures"]));
  file.text("/gates", json_text(document["gates"]));
  file.text("/catalog", json_text(catalog_entry(*study.entry)));
  for (const Comparator& comparator : comparators_of(study)) write_comparator(file, comparator);
  file.commit();
}

void ResultsFolder::write_verdicts(const Json& document, const std::vector<const Case*>& entries,
                                   const std::string& tier, const Provenance& provenance) const {
  Json catalog = Json::object();
  std::string names;
  for (const Case* entry : entries) {
    catalog[entry->name] = catalog_entry(*entry);
    names += entry->name + "\n";
  }
  Hdf5Writer file(fmt::format("{}/verdicts-{}-{}.h5", path_, tier, short_hash(names)));
  begin(file, "verdicts", provenance);
  file.text("/verdicts", json_text(document));
  file.text("/gates", json_text(document.at("gates")));
  file.text("/catalog", json_text(catalog));
  file.commit();
}

}  // namespace plumbline
