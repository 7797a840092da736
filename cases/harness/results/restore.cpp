#include "cases/harness/results/restore.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <span>
#include <type_traits>

#include "cases/harness/files/json_text.hpp"
#include "cases/harness/results/documents.hpp"

namespace plumbline {
namespace {

constexpr int restore_format = 1;
// Read by the very program that wrote it: the fingerprint says so.
static_assert(std::is_trivially_copyable_v<Ledger>, "the ledger is stored as it stands in memory");

std::span<const std::uint8_t> bytes_of(const Ledger& ledger) {
  return {reinterpret_cast<const std::uint8_t*>(&ledger), sizeof(Ledger)};
}

// All numbers that are no table, in one order for writing and reading; JSON has no way to write NaN, nor infinities. Not
// the time that the run took, so that the same run gives the same bytes.
std::vector<double> loose_numbers(const RunResult& run) {
  std::vector<double> all{run.h, run.dt, run.courant, run.end_time};
  if (run.stop) all.insert(all.end(), {run.stop->time, run.stop->value});
  for (const Measure& m : run.measures) {
    all.insert(all.end(), {m.error, m.scale, m.value.value_or(0), m.reference.value_or(0), m.reference_bound});
  }
  return all;
}

class Numbers {
 public:
  explicit Numbers(std::vector<double> all) : all_(std::move(all)) {}
  double next() { return all_.at(at_++); }

 private:
  std::vector<double> all_;
  std::size_t at_ = 0;
};

// Of every bit that is restored: storage fails in silence, too.
class Check {
 public:
  void add(const void* data, std::size_t size) {
    for (std::size_t k = 0; k < size; ++k)
      hash_ = (hash_ ^ static_cast<const unsigned char*>(data)[k]) * 0x100000001b3ULL;
  }
  void add(const std::vector<double>& values) { add(values.data(), values.size() * sizeof(double)); }
  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

std::string check_of(const RunResult& run) {
  Check check;
  const std::string names = run.case_name + "\n" + run.scheme + "\n" + run.settings.canonical();
  check.add(names.data(), names.size());
  check.add(loose_numbers(run));
  check.add(&run.ledger, sizeof(Ledger));
  check.add(run.history.step);
  check.add(run.history.time);
  for (const LedgerHistory::Series& series : run.history.series) check.add(series.values);
  for (const ProfileColumn& column : run.profile.columns) check.add(column.values);
  return check.text();
}

Json named_parts(const RunResult& run) {
  Json measures = Json::array(), series = Json::array(), columns = Json::array();
  for (const Measure& m : run.measures)
    measures.push_back(Json::array({m.name, m.unit, m.value.has_value(), m.reference.has_value()}));
  for (const LedgerHistory::Series& s : run.history.series) series.push_back(Json::array({s.quantity, s.column}));
  for (const ProfileColumn& c : run.profile.columns) columns.push_back(Json::array({c.name, c.unit, c.label}));
  return {{"measures", measures},
          {"series", series},
          {"profile", {{"kind", run.profile.kind}, {"abscissa", run.profile.abscissa}, {"columns", columns}}}};
}

Json stop_parts(const RunResult& run) {
  if (!run.stop) return nullptr;
  const Stop& s = *run.stop;
  return {{"reason", s.reason}, {"body", s.body}, {"field", s.field}, {"step", s.step}, {"point", s.point}};
}

void restore_tables(const Hdf5Reader& file, const Json& names, RunResult& run) {
  for (const Json& s : names.at("series")) {
    const std::string quantity = s.at(0), column = s.at(1), group = "/ledger/" + quantity + "/";
    if (run.history.series.empty()) {
      run.history.step = file.numbers(group + "step");
      run.history.time = file.numbers(group + "time");
    }
    run.history.series.push_back({quantity, column, file.numbers(group + column)});
  }
  const Json& profile = names.at("profile");
  run.profile.kind = profile.at("kind");
  run.profile.abscissa = profile.at("abscissa");
  for (const Json& c : profile.at("columns")) {
    const std::string column = c.at(0);
    run.profile.columns.push_back({column, c.at(1), c.at(2), file.numbers("/profile/" + column)});
  }
}

void restore_numbers(const Json& document, Numbers numbers, RunResult& run) {
  for (double* value : {&run.h, &run.dt, &run.courant, &run.end_time}) *value = numbers.next();
  if (const Json& stop = document.at("stop"); !stop.is_null()) {
    const double time = numbers.next(), value = numbers.next();
    run.stop = Stop{
        stop.at("reason"), stop.at("body"), stop.at("field"), stop.at("step"), time, stop.at("point"), value};
  }
  for (const Json& m : document.at("names").at("measures")) {
    Measure measure;
    measure.name = m.at(0);
    measure.unit = m.at(1);
    measure.error = numbers.next();
    measure.scale = numbers.next();
    const double value = numbers.next(), reference = numbers.next();
    if (m.at(2).get<bool>()) measure.value = value;
    if (m.at(3).get<bool>()) measure.reference = reference;
    measure.reference_bound = numbers.next();
    run.measures.push_back(std::move(measure));
  }
}

void restore_whole(const Hdf5Reader& file, const Json& document, RunResult& run) {
  run.dim = document.at("dim");
  run.axisymmetric = document.at("axisymmetric");
  run.finished = document.at("finished");
  run.wall_s = document.at("wall_s");
  run.steps = document.at("steps");
  run.points = document.at("points");
  run.doubles_per_point = document.at("doubles_per_point");
  run.file = document.at("file");
  restore_numbers(document, Numbers(file.numbers("/restore/numbers")), run);
  const std::vector<std::uint8_t> image = file.bytes("/restore/ledger");
  if (image.size() != sizeof(Ledger)) throw std::out_of_range("the ledger's size");
  std::memcpy(&run.ledger, image.data(), sizeof(Ledger));
  restore_tables(file, document.at("names"), run);
}

}  // namespace

Settings restored_settings(const std::string& case_name, const std::string& canonical) {
  Settings settings = find_case(case_name).settings("default", {});
  for (std::size_t start = 0; start < canonical.size();) {
    const std::size_t end = canonical.find('\n', start);
    settings.set_text(canonical.substr(start, end - start), case_name);
    start = end + 1;
  }
  return settings;
}

bool serves(const FrameRequest& kept, const FrameRequest& wanted) {
  if (wanted.count == 0) return true;
  const bool enough_points = kept.most_points == 0 ||
                             (wanted.most_points > 0 && kept.most_points >= wanted.most_points);
  return kept.count >= wanted.count && enough_points;
}

void write_restore(Hdf5Writer& file, const RunResult& run, const std::string& fingerprint, const Making& making) {
  file.group("/restore");
  const Json document{{"restore", restore_format},
                      {"fingerprint", fingerprint},
                      {"frames", {making.frames.count, making.frames.most_points}},
                      {"elapsed_s", making.elapsed_s},
                      {"wall_s", run.wall_s},
                      {"case", run.case_name},
                      {"scheme", run.scheme},
                      {"settings", run.settings.canonical()},
                      {"dim", run.dim},
                      {"axisymmetric", run.axisymmetric},
                      {"finished", run.finished},
                      {"stop", stop_parts(run)},
                      {"steps", run.steps},
                      {"points", run.points},
                      {"doubles_per_point", run.doubles_per_point},
                      {"file", run.file},
                      {"names", named_parts(run)},
                      {"check", check_of(run)}};
  file.text("/restore/run", json_text(document));
  file.numbers("/restore/numbers", loose_numbers(run));
  file.array("/restore/ledger", bytes_of(run.ledger));
}

std::optional<Stored> read_stored(const Hdf5Reader& file) {
  if (!file.has("/restore")) return std::nullopt;
  try {
    const Json document = Json::parse(file.text("/restore/run"));
    if (document.at("restore") != restore_format) return std::nullopt;
    const Json& frames = document.at("frames");
    return Stored{document.at("fingerprint"), {{frames.at(0), frames.at(1)}, document.at("elapsed_s")}};
  } catch (const Json::exception& error) {
    throw FileError(file.name(), fmt::format("{}: /restore/run is damaged: {}", file.name(), fault_of(error)));
  }
}

RunResult read_restore(const Hdf5Reader& file) {
  try {
    const Json document = Json::parse(file.text("/restore/run"));
    const std::string case_name = document.at("case");
    RunResult run(case_name, document.at("scheme"), restored_settings(case_name, document.at("settings")));
    restore_whole(file, document, run);
    if (Json(check_of(run)) != document.at("check")) throw std::out_of_range("its check sum");
    return run;
  } catch (const FileError&) {
    throw;
  } catch (const Json::exception& error) {
    throw FileError(file.name(), fmt::format("{}: the stored run is damaged: {}", file.name(), fault_of(error)));
  } catch (const std::exception& error) {
    throw FileError(file.name(), fmt::format("{}: the stored run is damaged: {}", file.name(), error.what()));
  }
}

}  // namespace plumbline
