// The command line.
#include <fmt/format.h>

#include <algorithm>
#include <clocale>

#include "cases/commands/command.hpp"
#include "cases/harness/json_text.hpp"
#include "reference/parameter.hpp"

namespace plumbline {
namespace {

void report_error(const CommonOptions& options, const Json& document, const std::string& message) {
  // Both may quote what the user gave, whatever bytes that is.
  fmt::print(stderr, "plumbline: {}\n", valid_utf8(message));
  if (options.json == "-") fmt::print("{}\n", document.dump(1, ' ', false, Json::error_handler_t::replace));
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
    for (const Command& command : commands) names.push_back(command.app->get_name());
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

int execute(const std::vector<Command>& commands, const CommonOptions& options) {
  try {
    load_plugins(options.plugins);
    for (const Command& command : commands) {
      if (command.app->parsed()) return command.execute();
    }
    return exit_usage;
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
  } catch (const Interrupted& error) {
    fmt::print(stderr, "plumbline: interrupted, nothing is left half-written\n");
    return 128 + error.signal;
  }
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
  const std::vector<Command> commands{
      add_list(app, invocation),     add_explain(app, invocation),   add_run(app, invocation),
      add_converge(app, invocation), add_verify(app, invocation),    add_reference(app, invocation),
      add_bench(app, invocation),    add_stability(app, invocation), add_sweep(app, invocation),
      add_export(app, invocation),   add_score(app, invocation),     add_scoreboard(app, invocation),
      add_diff(app, invocation),     add_tolerances(app, invocation)};
  for (const Command& command : commands) command.app->allow_extras();
  try {
    app.parse(argc, argv);
    refuse_extras(app, commands);
    if (app.get_subcommands().empty()) {
      fmt::print(stderr, "{}", app.help());
      return exit_usage;
    }
  } catch (const CLI::Success& done) {
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    report_error(invocation.options, error_document("", error.what()), error.what());
    return exit_usage;
  } catch (const UsageError& error) {
    report_error(invocation.options, error_document(error), error.what());
    return exit_usage;
  }
  return execute(commands, invocation.options);
}

}  // namespace
}  // namespace plumbline

int main(int argc, char** argv) {
  plumbline::end_runs_on_signals();
  try {
    return plumbline::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "plumbline: {}\n", error.what());
    return plumbline::exit_red;
  }
}
