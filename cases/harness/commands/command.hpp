// What all commands share: options, output, plug-ins.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cases/harness/commands/arguments.hpp"
#include "cases/harness/commands/standard_streams.hpp"
#include "cases/harness/results/documents.hpp"
#include "cases/harness/verify/verification.hpp"

namespace plumbline {

struct CommonOptions {
  std::vector<std::string> schemes, integrators, settings, plugins;
  int threads = 1;
  std::string results = "results", json;
  bool allow_inconclusive = false, reuse = false, no_fusion = false;
  std::optional<double> step_limit;  // s, of plug-ins
};

// One command: its arguments, and what it does; returns the exit status.
struct Command {
  Arguments arguments;
  std::function<int()> execute;
};

struct Invocation {
  CommonOptions options;
  std::string command;  // for provenance
  Provenance provenance() const;
};

Command add_list(const Arguments& program, Invocation& invocation);
Command add_explain(const Arguments& program, Invocation& invocation);
Command add_run(const Arguments& program, Invocation& invocation);
Command add_converge(const Arguments& program, Invocation& invocation);
Command add_verify(const Arguments& program, Invocation& invocation);
Command add_reference(const Arguments& program, Invocation& invocation);
Command add_bench(const Arguments& program, Invocation& invocation);
Command add_stability(const Arguments& program, Invocation& invocation);
Command add_sweep(const Arguments& program, Invocation& invocation);
Command add_export(const Arguments& program, Invocation& invocation);
Command add_score(const Arguments& program, Invocation& invocation);
Command add_scoreboard(const Arguments& program, Invocation& invocation);
Command add_diff(const Arguments& program, Invocation& invocation);
Command add_tolerances(const Arguments& program, Invocation& invocation);

// Throws UsageError where a key is given twice, or by an option and by --set, with two values or one.
void require_agreement(const Arguments& command, const CommonOptions& options);

// --no-fusion, of commands that make runs to be looked at.
void add_no_fusion(const Arguments& command, CommonOptions& options);

// --max-memory and --max-steps.
void add_limits(const Arguments& command);

// Adds --json (and, where asked, the options of commands that run something).
void add_json(const Arguments& command, CommonOptions& options);
void add_run_options(const Arguments& command, CommonOptions& options);
// --json, --scheme, --integrator and --set alone.
void add_scheme_options(const Arguments& command, CommonOptions& options);

// Adds --reuse to a command of many runs.
void add_reuse(const Arguments& command, CommonOptions& options);

// The schemes to run: --scheme, and default with each --integrator; `default` if neither is given. With the overrides
// that each means.
struct SchemeChoice {
  std::string scheme;
  std::vector<Override> overrides;
};
std::vector<SchemeChoice> chosen_schemes(const CommonOptions& options);

// Human text: standard output, or standard error while JSON goes to standard output.
class Output {
 public:
  explicit Output(const CommonOptions& options) : to_error_(options.json == "-") {}
  template <class... Args>
  void line(fmt::format_string<Args...> text, Args&&... args) const {
    print_text(to_error_ ? stderr : stdout, fmt::format(text, std::forward<Args>(args)...) + "\n");
  }
  void gates(const std::vector<JudgedGate>& gates) const;

 private:
  bool to_error_;
};

// The verdict's name, coloured on a terminal unless NO_COLOR is set.
std::string coloured(Verdict verdict);

// What of a command's runs was reused; nothing without --reuse.
void print_reused(const Output& out, const RunStore& store);

// Writes the document to the --json target, if any.
void write_json(const CommonOptions& options, const Json& document);

// A progress line on a terminal; nothing elsewhere.
Progress terminal_progress(const std::string& what);
void end_progress();

// The cases whose names match one of the patterns, all if there is none. Throws UsageError for a pattern without a match.
std::vector<const Case*> matching_cases(const std::vector<std::string>& patterns);

// Exit status of finished work: 3 if a run stopped, else by verdicts.
int exit_of(bool stopped, const std::vector<JudgedGate>& gates, bool allow_inconclusive);

}  // namespace plumbline
