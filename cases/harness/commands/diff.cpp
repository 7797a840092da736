#include <map>
#include <memory>
#include <set>

#include "cases/harness/commands/command.hpp"
#include "cases/harness/compare/comparison.hpp"

namespace plumbline {
namespace {

constexpr std::size_t most_lines = 25;  // of one kind of change

struct DiffOptions {
  std::string before, after, tolerances;
  std::vector<std::string> allowed;
  bool all = false;
};

std::set<Change> allowed_changes(const CommonOptions& common, const DiffOptions& options) {
  const std::map<std::string, Change> names{
      {"inconclusive", Change::inconclusive}, {"missing", Change::missing}, {"widened", Change::widened}};
  std::set<Change> allowed;
  if (common.allow_inconclusive) allowed.insert(Change::inconclusive);
  for (const std::string& name : options.allowed) {
    const auto found = names.find(name);
    if (found == names.end()) throw unknown_name("--allow", name, {"inconclusive", "missing", "widened"});
    allowed.insert(found->second);
  }
  return allowed;
}

int execute(const CommonOptions& common, const DiffOptions& options) {
  const std::set<Change> allowed = allowed_changes(common, options);
  const Snapshot before = read_snapshot(options.before), after = read_snapshot(options.after);
  Comparison comparison = compare(before, after);
  if (!options.tolerances.empty()) look_up_widenings(read_ledger(options.tolerances), before, after, comparison);
  const Output out(common);
  for (const std::string& text : table(comparison, before, after, options.all ? 0 : most_lines)) out.line("{}", text);
  write_json(common, document(comparison, before, after));
  return exit_status(comparison, before, after, allowed);
}

}  // namespace

Command add_diff(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command(
      "diff", "two results folders: verdicts, orders, errors, limits, costs",
      "Example: plumbline diff results-of-main results\nExit status: 0 nothing worse, missing or widened; 1 otherwise, "
      "or where it cannot be told; 2 wrong call; 4 damaged files.");
  auto options = std::make_shared<DiffOptions>();
  sub.option("baseline", options->before, "results folder to compare with").required();
  sub.option("results", options->after, "results folder that is judged").required();
  sub.option("--allow", options->allowed, "inconclusive, missing or widened do not make the exit status red")
      .repeatable();
  sub.flag("--allow-inconclusive", invocation.options.allow_inconclusive, "the same as --allow inconclusive");
  sub.option("--tolerances", options->tolerances,
             "the tolerance ledger of the results: a gate whose widening it records does not make the status red");
  sub.flag("--all", options->all, "a line for each finding");
  add_json(sub, invocation.options);
  return {sub, [&invocation, options] { return execute(invocation.options, *options); }};
}

}  // namespace plumbline
