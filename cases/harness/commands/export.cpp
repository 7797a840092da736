#include "cases/harness/commands/command.hpp"
#include "cases/harness/exchange/initial_state.hpp"

namespace plumbline {
namespace {

struct ExportOptions {
  std::string case_name, output;
  std::optional<int> cells;
};

int execute(const Invocation& invocation, const ExportOptions& options) {
  const Case& entry = find_case(options.case_name);
  const auto chosen = chosen_schemes(invocation.options);
  if (chosen.size() > 1) {
    throw UsageError("--scheme", chosen[1].scheme, "one scheme or integrator", {}, "export takes one scheme");
  }
  if (description_beside(options.output) == options.output) {
    throw UsageError("--output", options.output, "a name that does not end in .json", {},
                     "--output " + options.output + ": the description stands beside the file under that name");
  }
  std::vector<Override> overrides = chosen[0].overrides;
  if (options.cells) overrides.emplace_back("cells", static_cast<double>(*options.cells));
  const Settings settings = entry.settings(chosen[0].scheme, overrides, invocation.options.settings);
  const Json description = write_initial_state(entry, chosen[0].scheme, settings, options.output,
                                               invocation.provenance());
  const Output out(invocation.options);
  for (const Json& body : description.at("bodies")) {
    out.line("{}: {} points of {}, {}", body.at("group").get<std::string>(), body.at("points").get<int>(),
             body.at("material").at("name").get<std::string>(), body.at("final_state").at("points").get<std::string>());
  }
  out.line("{} and {}: the start of {}, to t = {:.6g} s", options.output, description_beside(options.output),
           entry.name, description.at("end_time").get<double>());
  if (!description.at("scored").get<bool>()) {
    out.line("`plumbline score` cannot judge it: {}", description.at("why_not_scored").get<std::string>());
  }
  write_json(invocation.options, description);
  return 0;
}

}  // namespace

Command add_export(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command("export", "the start of a case for other programs: HDF5 with a description",
                                        "Example: plumbline export sod --cells 100 --output sod.h5\nWhat the file "
                                        "holds: reports/docs/how-to/score-another-code.md");
  auto options = std::make_shared<ExportOptions>();
  sub.option("case", options->case_name, "the case").required();
  sub.option("--cells", options->cells, "cells along the case's reference length").whole_number();
  sub.option("--output", options->output, "the file; its description stands beside it, ending in .json").required();
  add_scheme_options(sub, invocation.options);
  add_limits(sub);
  return {sub, [&invocation, options] { return execute(invocation, *options); }};
}

}  // namespace plumbline
