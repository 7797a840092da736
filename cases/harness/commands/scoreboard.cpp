#include "cases/harness/exchange/scoreboard.hpp"
#include "cases/harness/commands/adapters.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/text_file.hpp"

namespace plumbline {
namespace {

struct ScoreboardOptions {
  std::string folder;
  std::vector<std::string> adapters;
  double timeout = 600;
};

std::string number_text(const std::optional<double>& value) { return value ? fmt::format("{:.3g}", *value) : "-"; }

std::string order_text(const StudyResult& study, const std::string& measure) {
  const OrderFit* fit = study.levels.size() > 1 ? study.fit(measure) : nullptr;
  if (!fit) return "";
  return fmt::format("order {:.3f}, 95 % interval {:.3f} ... {:.3f}", fit->order, fit->low, fit->high);
}

void print_row(const Output& out, const std::string& program, const std::string& cells, const std::string& verdict,
               const std::string& ratio, const std::string& seconds, const std::string& words) {
  std::string row = fmt::format("  {:16} {:>7}  {} {:>14} {:>9}  {}", program, cells, verdict, ratio, seconds, words);
  row.erase(row.find_last_not_of(' ') + 1);
  out.line("{}", row);
}

void print_program(const Output& out, const ProblemScores& problem, const ProgramScore& scored) {
  for (std::size_t k = 0; k < scored.entries.size(); ++k) {
    const Entry& entry = scored.entries[k];
    const int cells = problem.starts[k].cells;
    const StudyLevel* level = scored.level(cells);
    const auto verdict = level ? coloured(overall(verdicts(gates_of_level(*scored.score, *level))))
                               : fmt::format("{:12}", name(entry.outcome));
    print_row(out, scored.program, std::to_string(cells), verdict,
              number_text(error_ratio(problem.measure, level, problem.own.level(cells))), number_text(entry.seconds),
              entry.reason);
  }
  if (scored.entries.size() > 1 && scored.score) {
    print_row(out, scored.program, "all", coloured(overall(verdicts(scored.score->gates))), "", "",
              order_text(scored.score->study, problem.measure));
  }
  if (!scored.reason.empty()) out.line("  {:16} not one series: {}", scored.program, scored.reason);
}

void print(const Output& out, const ProblemScores& problem) {
  std::string typed;
  for (const std::string& setting : problem.starts.front().typed) typed += " " + setting;
  out.line("{}{}: {}", problem.entry->name, typed, problem.measure);
  print_row(out, "program", "cells", fmt::format("{:12}", "verdict"), "error/default", "time/s", "");
  for (const StudyLevel& at : problem.own.levels) {
    const std::string stop = at.run.stop ? "STOPPED: " + at.run.stop->reason : "";
    print_row(out, "(default)", fmt::format("{}", at.value), std::string(12, ' '), "", number_text(at.run.wall_s),
              stop);
  }
  if (const std::string order = order_text(problem.own, problem.measure); !order.empty())
    print_row(out, "(default)", "all", std::string(12, ' '), "", "", order);
  for (const ProgramScore& scored : problem.programs) print_program(out, problem, scored);
  for (const ProgramScore& scored : problem.programs) {
    if (!scored.score) continue;
    std::vector<JudgedGate> missed = scored.score->gates;
    std::erase_if(missed, [](const JudgedGate& gate) {
      return exit_status(std::vector<Verdict>{gate.judgement.verdict}, false) == 0;
    });
    out.gates(missed);
  }
}

void print(const Output& out, const Scoreboard& board) {
  for (const ProblemScores& problem : board.problems) print(out, problem);
  for (const auto& [start, reason] : board.refused) out.line("start {}: {}", start, reason);
  for (const std::string& stray : board.strays) out.line("{}: there is no start of this name", stray);
}

int execute(const Invocation& invocation, const ScoreboardOptions& options) {
  const CommonOptions& common = invocation.options;
  const ScoreFolder folder(options.folder);
  std::vector<Adapter> adapters;
  for (const std::string& typed : options.adapters) adapters.push_back(adapter_from(typed));
  if (adapters.empty() && folder.programs().empty()) {
    throw UsageError("DIR", options.folder, "a folder with programs/NAME", {},
                     fmt::format("{0}: no programs in {0}/programs; put their results there, or have them made by "
                                 "--run NAME=ADAPTER",
                                 options.folder));
  }
  const Output out(common);
  for (const Adapter& adapter : adapters) run_adapter(adapter, folder, options.timeout, out);
  const ResultsFolder results(common.results);
  RunStore store(results, invocation.provenance(), true);
  const Scoreboard board = make_scoreboard(folder, options.timeout, common.threads, terminal_progress("default"),
                                           store);
  end_progress();
  print(out, board);
  const Json document = scoreboard_document(board, invocation.provenance());
  const std::string file = options.folder + "/scoreboard.json";
  write_text_file(file, json_text(document, 1) + "\n");
  out.line("{}; `python3 reports/scoreboard.py {}` makes a page of it", file, options.folder);
  write_json(common, document);
  return exit_status(verdicts(board), common.allow_inconclusive);
}

}  // namespace

Command add_scoreboard(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command(
      "scoreboard", "many programs' final states of many starts in one table",
      "Example: plumbline scoreboard DIR --run mine=./adapter\nDIR holds cases/*.h5 (of `plumbline export`) and "
      "programs/NAME/*.h5 under the same names: reports/docs/how-to/score-another-code.md\nExit status: 0 all green; 1 "
      "a verdict is red, or a result damaged, missing, late or failed; 2 wrong call; 4 DIR cannot be read or "
      "written.");
  auto options = std::make_shared<ScoreboardOptions>();
  add_json(sub, invocation.options);  // first: what is wrong with the others is said as JSON, too
  sub.option("DIR", options->folder, "starts and results").required();
  sub.option("--run", options->adapters, "NAME=ADAPTER: run this executable on every start first (repeatable)")
      .repeatable();
  sub.option("--timeout", options->timeout, "s that an adapter has for one start, and reading its result")
      .number_within(1e-3, 1e6);
  sub.option("--threads", invocation.options.threads, "runs of the default scheme side by side").whole_number(1, 1024);
  sub.option("--results", invocation.options.results, "results folder of the default scheme's runs");
  sub.flag("--allow-inconclusive", invocation.options.allow_inconclusive,
           "INCONCLUSIVE does not make the exit status red");
  return {sub, [&invocation, options] { return execute(invocation, *options); }};
}

}  // namespace plumbline
