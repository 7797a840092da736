#include <memory>

#include "cases/commands/command.hpp"
#include "cases/comparison/tolerances.hpp"
#include "cases/harness/input_file.hpp"

namespace plumbline {
namespace {

struct TolerancesOptions {
  std::string file, against, why;
  bool update = false;
};

std::string today() { return build_provenance().started.substr(0, 10); }

Json document(const std::string& file, const std::vector<LedgerLine>& recorded, std::size_t declared,
              const std::vector<Discrepancy>& found) {
  Json all = Json::array(), widened = Json::array();
  for (const Discrepancy& d : found) {
    const auto& [case_name, study, id] = d.gate;
    all.push_back({{"kind", d.kind}, {"case", case_name}, {"study", study}, {"id", id}, {"message", d.message}});
  }
  for (const LedgerLine& line : recorded) {
    if (line.widened) widened.push_back(to_json(line));
  }
  return {{"file", file},
          {"recorded", recorded.size()},
          {"declared", declared},
          {"widened", widened},
          {"discrepancies", all}};
}

int execute(const CommonOptions& common, const TolerancesOptions& options) {
  if (!options.why.empty() && !options.update)
    throw UsageError("--why", options.why, "with --update", {"--update"}, "--why belongs to --update");
  const std::vector<LedgerLine> declared = declared_lines(cases(), today());
  if (options.update) {
    std::vector<LedgerLine> recorded;
    if (is_there(options.file)) recorded = read_ledger(options.file);
    write_ledger(options.file, updated(recorded, declared, options.why, today()));
  }
  const std::vector<LedgerLine> recorded = read_ledger(options.file);
  std::vector<Discrepancy> found = discrepancies(recorded, declared);
  if (!options.against.empty()) {
    for (Discrepancy& d : unsigned_widenings(read_ledger(options.against), recorded)) found.push_back(std::move(d));
  }
  const Output out(common);
  for (const Discrepancy& d : found) out.line("{}", d.message);
  out.line("{}: {} gates recorded, {} declared, {}", options.file, recorded.size(), declared.size(),
           found.empty() ? "all as recorded" : fmt::format("{} not as recorded", found.size()));
  write_json(common, document(options.file, recorded, declared.size(), found));
  return found.empty() ? 0 : exit_red;
}

}  // namespace

Command add_tolerances(CLI::App& app, Invocation& invocation) {
  CLI::App* sub = app.add_subcommand("tolerances", "the ledger of all gates' bounds against what is declared");
  sub->footer(
      "Example: plumbline tolerances cases/tolerances.json --update\nExit status: 0 all as recorded, 1 not, 2 a gate "
      "was "
      "widened and --why is missing, 4 files.");
  auto options = std::make_shared<TolerancesOptions>();
  sub->add_option("file", options->file, "the ledger")->required();
  sub->add_flag("--update", options->update, "write it as declared");
  sub->add_option("--why", options->why, "why gates were widened, for their lines");
  sub->add_option("--against", options->against, "an earlier ledger: what is wider than there needs a recorded reason");
  add_json(*sub, invocation.options);
  return {sub, [&invocation, options] { return execute(invocation.options, *options); }};
}

}  // namespace plumbline
