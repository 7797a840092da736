#include <algorithm>
#include <filesystem>
#include <memory>

#include "cases/harness/commands/command.hpp"
#include "cases/harness/compare/bands.hpp"
#include "cases/harness/compare/recording.hpp"
#include "cases/harness/compare/tolerances.hpp"
#include "cases/harness/files/input_file.hpp"

namespace plumbline {
namespace {

struct TolerancesOptions {
  std::string file, against, why, record;
  bool update = false;
};

int ranges(const std::vector<RecordedValue>& values) {
  return static_cast<int>(std::count_if(values.begin(), values.end(), [](const RecordedValue& v) { return v.within; }));
}

std::string today() { return build_provenance().started.substr(0, 10); }

// Recorded values and ensembles stand in the ledger's folder.
std::string beside(const std::string& file, const char* name) {
  return (std::filesystem::path(file).parent_path() / name).string();
}
std::string regressions_beside(const std::string& file) { return beside(file, "regressions.json"); }

Json document(const std::string& file, const std::vector<LedgerLine>& recorded, std::size_t declared,
              const std::vector<RecordedValue>& values, const std::vector<Discrepancy>& found) {
  Json all = Json::array(), widened = Json::array();
  for (const Discrepancy& d : found) {
    const auto& [case_name, study, id] = d.gate;
    all.push_back({{"kind", d.kind}, {"case", case_name}, {"study", study}, {"id", id}, {"message", d.message}});
  }
  for (const LedgerLine& line : recorded) {
    if (line.widened) widened.push_back(to_json(line));
  }
  return {{"file", file},        {"recorded", recorded.size()}, {"declared", declared},
          {"widened", widened},  {"values", values.size()},     {"ranges", ranges(values)},
          {"discrepancies", all}};
}

// Brings the recorded values up to the results of a verification.
void record(const TolerancesOptions& options) {
  const std::string file = regressions_beside(options.file);
  std::vector<RecordedValue> before;
  if (is_there(file)) before = read_regressions(file);
  write_regressions(file, recorded_from(before, read_verification(options.record), options.record, options.why));
}

int execute(const CommonOptions& common, const TolerancesOptions& options) {
  if (!options.why.empty() && !options.update && options.record.empty()) {
    throw UsageError("--why", options.why, "with --update or --record", {"--update", "--record"},
                     "--why belongs to --update and --record");
  }
  const std::vector<LedgerLine> declared = declared_lines(cases(), today());
  if (options.update) {
    std::vector<LedgerLine> recorded;
    if (is_there(options.file)) recorded = read_ledger(options.file);
    write_ledger(options.file, updated(recorded, declared, options.why, today()));
  }
  if (!options.record.empty()) record(options);
  const std::vector<LedgerLine> recorded = read_ledger(options.file);
  std::vector<Discrepancy> found = discrepancies(recorded, declared);
  if (!options.against.empty()) {
    for (Discrepancy& d : unsigned_widenings(read_ledger(options.against), recorded)) found.push_back(std::move(d));
  }
  std::vector<RecordedValue> values;
  const Output out(common);
  if (const std::string file = regressions_beside(options.file); is_there(file)) {
    values = read_regressions(file);
    for (Discrepancy& d : unrecorded(cases(), values)) found.push_back(std::move(d));
    out.line("{}: values of {} gates recorded, {} of them with a range", file, values.size(), ranges(values));
  } else {
    out.line("{}: not there, so no recorded value is looked at; --record writes it", file);
  }
  if (const std::string file = beside(options.file, "ensembles.json"); is_there(file)) {
    for (Discrepancy& d : wide_bands(cases(), read_ensembles(file))) found.push_back(std::move(d));
  }
  for (const Discrepancy& d : found) out.line("{}", d.message);
  out.line("{}: {} gates recorded, {} declared, {}", options.file, recorded.size(), declared.size(),
           found.empty() ? "all as recorded" : fmt::format("{} not as recorded", found.size()));
  write_json(common, document(options.file, recorded, declared.size(), values, found));
  return found.empty() ? 0 : exit_red;
}

}  // namespace

Command add_tolerances(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command(
      "tolerances", "the ledger of all gates' bounds against what is declared",
      "Examples: plumbline tolerances cases/tolerances.json --update\n"
      "          plumbline tolerances cases/tolerances.json --record judged.json\nExit status: 0 all as recorded, 1 "
      "not, 2 a gate "
      "was widened or a value moved and --why is missing, 4 files.");
  auto options = std::make_shared<TolerancesOptions>();
  sub.option("file", options->file, "the ledger").required();
  sub.flag("--update", options->update, "write it as declared");
  sub.option("--record", options->record,
             "results of `plumbline verify --json`: what its gates measure goes to regressions.json beside the ledger");
  sub.option("--why", options->why, "why gates were widened, or values moved, for their lines");
  sub.option("--against", options->against, "an earlier ledger: what is wider than there needs a recorded reason");
  add_json(sub, invocation.options);
  return {sub, [&invocation, options] { return execute(invocation.options, *options); }};
}

}  // namespace plumbline
