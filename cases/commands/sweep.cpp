#include <filesystem>

#include "cases/commands/command.hpp"
#include "cases/harness/plan.hpp"

namespace plumbline {
namespace {

struct SweepOptions {
  std::vector<std::string> patterns, batches;
  std::string tier = "quick", plan, from;
};

Plan plan_from(const SweepOptions& options) {
  if (!options.from.empty()) {
    const PlanDocument document(options.from);
    if (document.has_batches()) return {document.tier(), document.batches()};
    return {document.tier(), batches_of(document.runs(), {})};
  }
  const std::vector<std::string> tiers{"quick", "full"};
  if (options.tier != tiers[0] && options.tier != tiers[1]) throw unknown_name("--tier", options.tier, tiers);
  const Tier tier = options.tier == "full" ? Tier::full : Tier::quick;
  return {options.tier, batches_of(runs_of_tier(matching_cases(options.patterns), tier), {})};
}

std::vector<Batch> chosen_batches(const SweepOptions& options) {
  if (options.batches.empty()) return plan_from(options).batches;
  if (options.from.empty()) {
    throw UsageError("--batch", options.batches.front(), "together with --from", {},
                     "--batch names a batch of a plan: --from says which plan");
  }
  const PlanDocument document(options.from);
  std::vector<Batch> chosen;
  for (const std::string& id : options.batches) chosen.push_back(document.batch(id));
  return chosen;
}

void print_plan(const Invocation& invocation, const SweepOptions& options) {
  CommonOptions target = invocation.options;
  target.json = options.plan;
  write_json(target, to_json(plan_from(options)));
}

int execute(const Invocation& invocation, const SweepOptions& options) {
  if (!options.plan.empty()) {
    print_plan(invocation, options);
    return 0;
  }
  const std::vector<Batch> batches = chosen_batches(options);
  const ResultsFolder folder(invocation.options.results);
  const Provenance provenance = invocation.provenance();
  const Output out(invocation.options);
  for (const Batch& batch : batches) {
    for (const PlanRun& run : batch.runs) {
      if (std::filesystem::exists(folder.path() + "/" + run.file)) {
        out.line("kept {}", run.file);
        continue;
      }
      RunResult result = run_experiment(*run.entry, run.scheme, run.settings, 1, run.frames);
      result.scheme = result_scheme(*run.entry, run.scheme, run.settings);
      result.file = run.file;
      folder.write_run(result, {}, provenance);
      out.line("made {}", run.file);
    }
  }
  return 0;
}

}  // namespace

Command add_sweep(CLI::App& app, Invocation& invocation) {
  CLI::App* sub = app.add_subcommand("sweep", "many runs: those that verify needs, or those of a plan");
  sub->footer("Example: plumbline sweep 'sod*' --tier full --jobs 2, then plumbline verify 'sod*' --tier full --reuse");
  auto options = std::make_shared<SweepOptions>();
  sub->add_option("pattern", options->patterns, "case names or patterns; all cases if none");
  sub->add_option("--tier", options->tier, "quick or full");
  sub->add_option("--plan", options->plan, "write the plan to a file, or - for standard output, and run nothing");
  sub->add_option("--from", options->from, "the runs of this plan (- for standard input) instead of a tier's");
  sub->add_option("--batch", options->batches, "this batch of the plan alone, in this process (repeatable)")
      ->allow_extra_args(false);
  sub->add_option("--results", invocation.options.results, "results folder");
  add_json(*sub, invocation.options);
  return {sub, [&invocation, options] { return execute(invocation, *options); }};
}

}  // namespace plumbline
