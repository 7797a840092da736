#include "cases/harness/commands/command.hpp"

#include <fmt/color.h>
#include <fnmatch.h>
#include <unistd.h>

#include <cstdlib>
#include <map>

#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/text_file.hpp"
#include "cases/harness/results/fingerprint.hpp"
#include "cases/harness/run/budget.hpp"

namespace plumbline {

Provenance Invocation::provenance() const {
  Provenance p = build_provenance();
  p.fingerprint = code_fingerprint();
  p.threads = options.threads;
  p.command = command;
  return p;
}

void require_agreement(const Arguments& command, const CommonOptions& options) {
  std::map<std::string, std::string> given;  // a key, and how it was given
  const auto take = [&](const std::string& key, const std::string& how) {
    const auto [at, is_new] = given.emplace(key, how);
    if (is_new) return;
    throw UsageError(key, how, "one of the two", {}, fmt::format("{} and {}: give {} once", at->second, how, key));
  };
  if (const std::string cells = command.first_value("--cells"); !cells.empty()) take("cells", "--cells " + cells);
  if (!options.integrators.empty()) take("integrator", "--integrator " + options.integrators.front());
  for (const std::string& assignment : options.settings) {
    take(assignment.substr(0, assignment.find('=')), "--set " + assignment);
  }
  // Either may be switched off beside the other.
  if (given.count("dt") > 0 && given.count("cfl") > 0 && given["dt"] != "--set dt=none" &&
      given["cfl"] != "--set cfl=none") {
    throw UsageError("dt", given["dt"], "dt or cfl", {}, given["cfl"] + " and " + given["dt"] + ": give one of them");
  }
}

void add_no_fusion(const Arguments& command, CommonOptions& options) {
  command.flag("--no-fusion", options.no_fusion,
               "every stage of a step by itself, not several in one pass over the points");
}

void add_limits(const Arguments& command) {
  // The program and its libraries alone take some tens of megabytes.
  command.size("--max-memory", budget().memory, 1e8, 0x1p50,
               "memory that may be used, as 500MB or 2GB; nine tenths of the machine's if not given");
  command.option("--max-steps", budget().steps, "steps that a run may take; 1e9 if not given").number_within(1, 1e15);
}

void add_json(const Arguments& command, CommonOptions& options) {
  command.option("--json", options.json, "write JSON to a file, or - for standard output").not_empty();
  command
      .option("--plugin", options.plugins,
              "shared library that registers integrators or other parts of a scheme (repeatable)")
      .repeatable()
      .not_empty();
  command.option("--step-limit", options.step_limit,
                 "of plug-ins: seconds that one step may take; by the size of the scene if not given");
}

void add_scheme_options(const Arguments& command, CommonOptions& options) {
  add_json(command, options);
  command.option("--scheme", options.schemes, "scheme (repeatable)").repeatable();
  command.option("--integrator", options.integrators, "the case's default scheme with this integrator (repeatable)")
      .repeatable();
  command.option("--set", options.settings, "key=value (repeatable); `plumbline explain CASE` lists the keys")
      .repeatable();
}

void add_run_options(const Arguments& command, CommonOptions& options) {
  add_scheme_options(command, options);
  command
      .option("--threads", options.threads,
              "threads: of the loops over points in run and bench, for runs side by side elsewhere; 1 if not given, in "
              "verify one a core")
      .whole_number(1, 1024);
  command.option("--results", options.results, "results folder").not_empty();
  add_limits(command);
  command.flag("--allow-inconclusive", options.allow_inconclusive, "INCONCLUSIVE does not make the exit status red");
}

void add_reuse(const Arguments& command, CommonOptions& options) {
  command.flag("--reuse", options.reuse, "take from the results folder the runs that the same code has made already");
}

std::vector<SchemeChoice> chosen_schemes(const CommonOptions& options) {
  std::vector<SchemeChoice> chosen;
  for (const std::string& scheme : options.schemes) chosen.push_back({scheme, {}});
  for (const std::string& integrator : options.integrators) chosen.push_back({"default", {{"integrator", integrator}}});
  if (chosen.empty()) chosen.push_back({"default", {}});
  return chosen;
}

namespace {

bool colours() { return ::isatty(STDOUT_FILENO) && !std::getenv("NO_COLOR"); }

fmt::color colour_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return fmt::color::green;
    case Verdict::xfail:
    case Verdict::none:
      return fmt::color::gray;
    case Verdict::inconclusive:
      return fmt::color::orange;
    default:
      return fmt::color::red;
  }
}

std::string range_text(const Range& range) {
  if (range.low && range.high) return fmt::format("{:.6g} ... {:.6g}", *range.low, *range.high);
  return range.low ? fmt::format(">= {:.6g}", *range.low) : fmt::format("<= {:.6g}", range.high.value_or(0));
}

}  // namespace

std::string coloured(Verdict verdict) {
  const std::string text = fmt::format("{:12}", name(verdict));
  return colours() ? fmt::format(fmt::fg(colour_of(verdict)), "{}", text) : text;
}

void Output::gates(const std::vector<JudgedGate>& gates) const {
  for (const JudgedGate& g : gates) {
    const std::string measured = g.measured.value ? fmt::format("{:.6g}", *g.measured.value) : "-";
    const std::string interval = g.measured.interval ? fmt::format(" [{:.4g}, {:.4g}]", g.measured.interval->first,
                                                                   g.measured.interval->second)
                                                     : "";
    const std::string note = g.judgement.note.empty() ? g.measured.note : g.judgement.note;
    line("{} {:11} {:36} {}{}, expected {}{}", coloured(g.judgement.verdict), g.case_name, g.gate.id, measured,
         interval, range_text(g.gate.expected), note.empty() ? "" : " (" + note + ")");
    if (!g.explanation.empty()) line("{:12} usual causes: {}", "", g.explanation);
  }
}

void print_reused(const Output& out, const RunStore& store) {
  if (store.reuses()) out.line("{} runs reused, {} made", store.reused(), store.made());
}

void write_json(const CommonOptions& options, const Json& document) {
  if (options.json.empty()) return;
  const std::string text = json_text(document, 1) + "\n";
  if (options.json == "-") {
    print_text(stdout, text);
    return;
  }
  write_text_file(options.json, text);
}

Progress terminal_progress(const std::string& what) {
  if (!::isatty(STDERR_FILENO)) return {};
  return [what](std::size_t done, std::size_t of, const RunResult& last) {
    const std::string which = last.settings.has("cells") ? to_text(last.settings["cells"]) + " cells"
                                                         : last.settings.text("trial");
    fmt::print(stderr, "\r\033[K{}: {} of {} runs, last {} in {:.2f} s", what, done, of, which, last.wall_s);
    std::fflush(stderr);
  };
}

void end_progress() {
  if (::isatty(STDERR_FILENO)) fmt::print(stderr, "\r\033[K");
}

std::vector<const Case*> matching_cases(const std::vector<std::string>& patterns) {
  if (patterns.empty()) return cases();
  std::vector<std::string> names;
  for (const Case* entry : cases()) names.push_back(entry->name);
  std::vector<bool> chosen(cases().size(), false);
  for (const std::string& pattern : patterns) {
    bool any = false;
    for (std::size_t k = 0; k < names.size(); ++k) {
      if (::fnmatch(pattern.c_str(), names[k].c_str(), 0) == 0) chosen[k] = any = true;
    }
    if (!any) throw unknown_name("case or pattern", pattern, names);
  }
  std::vector<const Case*> entries;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (chosen[k]) entries.push_back(cases()[k]);
  }
  return entries;
}

int exit_of(bool stopped, const std::vector<JudgedGate>& gates, bool allow_inconclusive) {
  if (stopped) return exit_stopped;
  return exit_status(verdicts(gates), allow_inconclusive);
}

}  // namespace plumbline
