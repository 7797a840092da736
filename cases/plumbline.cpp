// The command line.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <malloc.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <clocale>
#include <filesystem>

#include "cases/harness/commands/command.hpp"
#include "cases/harness/commands/plugins.hpp"
#include "cases/harness/commands/standard_streams.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/signals.hpp"
#include "cases/harness/files/text_file.hpp"
#include "cases/harness/run/budget.hpp"
#include "cases/harness/run/guarded_integrator.hpp"
#include "kernel/engine/stage_queue.hpp"
#include "kernel/inadmissible.hpp"
#include "reference/parameter.hpp"

namespace plumbline {
namespace {

constexpr int kept_memory = 1 << 28;  // bytes

void report_error(const CommonOptions& options, const Json& document, const std::string& message) {
  print_text(stderr, fmt::format("plumbline: {}\n", message));
  if (options.json == "-") print_text(stdout, json_text(document, 1) + "\n");
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

void refuse_extras(CLI::App& app, const std::vector<Command>& commands) {
  const auto chosen = app.get_subcommands();
  if (chosen.empty() && !app.remaining().empty()) {
    std::vector<std::string> names;
    for (const Command& command : commands) names.push_back(command.arguments.app().get_name());
    throw unknown_name("command", app.remaining().front(), names);
  }
  for (CLI::App* sub : chosen) {
    auto extras = sub->remaining();
    if (extras.empty()) extras = app.remaining();
    if (!extras.empty())
      throw unknown_name("option or argument of " + sub->get_name(), extras.front(), option_names(*sub));
  }
}

std::string version_text() {
  const Provenance p = build_provenance();
  std::string libraries;
  for (const auto& [library, version] : p.libraries) libraries += fmt::format(" {} {}", library, version);
  return fmt::format("plumbline {} ({}{})\n{}, {}\n{}, {}\nlibraries:{}", p.version, p.git.empty() ? "no git" : p.git,
                     p.dirty ? ", modified" : "", p.compiler, p.flags, p.cpu, p.instruction_set, libraries);
}

// What is wrong with a call is said before any work.
void refuse_wrong_options(const Arguments& command, const CommonOptions& options) {
  require_agreement(command, options);
  const auto folder = std::filesystem::path(options.json).parent_path().lexically_normal();
  const bool made_by_it = folder == std::filesystem::path(options.results).lexically_normal();
  if (!options.json.empty() && options.json != "-" && !made_by_it) require_writable(options.json);
  limit_memory();
}

int execute(const std::vector<Command>& commands, const CommonOptions& options) {
  try {
    const auto chosen = std::find_if(commands.begin(), commands.end(),
                                     [](const Command& command) { return command.arguments.app().parsed(); });
    if (chosen == commands.end()) return exit_usage;
    refuse_wrong_options(chosen->arguments, options);
    fuses_stages() = !options.no_fusion;
    const auto watch = load_plugins(options);
    return chosen->execute();
  } catch (const UsageError& error) {
    report_error(options, error_document(error), error.what());
    return exit_usage;
  } catch (const reference::ParameterError& error) {
    report_error(options,
                 error_document(UsageError(error.key, fmt::format("{}", error.value), error.allowed, {}, error.what())),
                 error.what());
    return exit_usage;
  } catch (const FileError& error) {
    report_error(options, error_document(error.path, error.what()), error.what());
    return exit_files;
  } catch (const MisbehavingIntegrator& error) {
    Json document = error_document("integrator", error.what());
    document["error"]["value"] = error.integrator;
    report_error(options, document, error.what());
    return exit_stopped;
  } catch (const Interrupted& error) {
    print_text(stderr, "plumbline: interrupted, nothing is left half-written\n");
    return 128 + error.signal;
  } catch (const CannotWork& parts) {
    report_error(options, error_document("integrator", parts.what()), parts.what());
    return exit_usage;
  } catch (const InadmissibleState& state) {
    const std::string message = fmt::format("stopped at step {}: {}", state.step, state.what());
    report_error(options, error_document(state.field, message), message);
    return exit_stopped;
  } catch (const std::bad_alloc&) {
    const UsageError error = beyond_memory();
    report_error(options, error_document(error), error.what());
    return exit_usage;
  } catch (const std::logic_error& error) {  // of choices that are each within their range, and together no scene
    const std::string chosen = fmt::format("{}", fmt::join(options.settings, " "));
    const std::string message = chosen.empty() ? error.what() : fmt::format("{}: {}", chosen, error.what());
    report_error(options, error_document(UsageError("--set", chosen, "other values", {}, message)), message);
    return chosen.empty() ? exit_red : exit_usage;
  } catch (const std::exception& error) {
    report_error(options, error_document("", error.what()), error.what());
    return exit_red;
  }
}

// The options may not have been read when one of them is wrong.
bool wants_json(int argc, char** argv) {
  const std::vector<std::string> words(argv, argv + argc);
  for (std::size_t k = 1; k < words.size(); ++k) {
    if (words[k] == "--json=-" || (words[k - 1] == "--json" && words[k] == "-")) return true;
  }
  return false;
}

// A message of CLI11 in parts: "--cells: 'x' is not allowed: a whole number", "Could not convert: --at = x", "name is required".
UsageError call_error(const std::string& message) {
  const std::size_t option = message.find("--"), quoted = message.find('\''), equals = message.find(" = ");
  const std::size_t begin = option == std::string::npos ? 0 : option;
  const std::string key = message.substr(begin, message.find_first_of(": ", begin) - begin);
  const std::size_t last = message.rfind(": ");
  std::string value = "none", allowed = "as --help of the command says";
  if (equals != std::string::npos) value = message.substr(equals + 3);
  if (quoted != std::string::npos && last > quoted && last != std::string::npos) {
    value = message.substr(quoted + 1, message.rfind('\'') - quoted - 1);
    allowed = message.substr(last + 2);
  }
  return UsageError(key, value, allowed, {}, message);
}

int run(int argc, char** argv) {
  CLI::App app{"Plumbline: verification and validation of the Material Point Method"};
  app.set_version_flag("--version", version_text);
  app.footer(
      "Example: plumbline converge sod --cells 100,200,400,800,1600\nExit status: 0 all verdicts green, 1 red, 2 wrong "
      "call, 3 a run stopped, 4 files.");
  app.allow_extras();
  Invocation invocation;
  invocation.command = stored_command(argc, argv);
  const Arguments program(app);
  const std::vector<Command> commands{
      add_list(program, invocation),     add_explain(program, invocation),   add_run(program, invocation),
      add_converge(program, invocation), add_verify(program, invocation),    add_reference(program, invocation),
      add_bench(program, invocation),    add_stability(program, invocation), add_sweep(program, invocation),
      add_export(program, invocation),   add_score(program, invocation),     add_scoreboard(program, invocation),
      add_diff(program, invocation),     add_tolerances(program, invocation)};
  for (const Command& command : commands) command.arguments.app().allow_extras();
  try {
    app.parse(argc, argv);
    refuse_extras(app, commands);
    if (app.get_subcommands().empty()) {
      print_text(stderr, app.help());
      return exit_usage;
    }
  } catch (const CLI::Success& done) {
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    if (wants_json(argc, argv)) invocation.options.json = "-";
    report_error(invocation.options, error_document(call_error(error.what())), error.what());
    return exit_usage;
  } catch (const UsageError& error) {
    if (wants_json(argc, argv)) invocation.options.json = "-";
    report_error(invocation.options, error_document(error), error.what());
    return exit_usage;
  }
  return execute(commands, invocation.options);
}

}  // namespace
}  // namespace plumbline

int main(int argc, char** argv) {
#ifdef M_TRIM_THRESHOLD
  // What a step gives back the next asks for again: pages that the system takes meanwhile have to be found and cleared anew.
  mallopt(M_TRIM_THRESHOLD, plumbline::kept_memory);
  mallopt(M_MMAP_THRESHOLD, plumbline::kept_memory);
#endif
  plumbline::open_standard_streams();
  plumbline::end_runs_on_signals();
  return plumbline::after_output(plumbline::run(argc, argv));
}
