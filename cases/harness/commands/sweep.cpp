#include <algorithm>
#include <filesystem>
#include <set>
#include <thread>

#include "cases/harness/commands/child_process.hpp"
#include "cases/harness/commands/command.hpp"
#include "cases/harness/commands/plugins.hpp"
#include "cases/harness/commands/sweep_pool.hpp"
#include "cases/harness/files/hdf5_file.hpp"
#include "cases/harness/files/json_text.hpp"
#include "cases/harness/files/text_file.hpp"
#include "cases/harness/run/budget.hpp"
#include "cases/harness/run/guarded_integrator.hpp"
#include "cases/harness/verify/plan.hpp"

namespace plumbline {
namespace {

struct SweepOptions {
  std::vector<std::string> patterns, batches;
  std::string tier = "quick", plan, from, only;
  int jobs = 0;
  int pool = 0;  // the process whose child this is
};

// What is to be made: all runs, those of them that are missing, and these in batches.
struct Work {
  std::vector<PlanRun> runs;
  Plan missing;
  std::size_t kept = 0;
};

Tier tier_of(const SweepOptions& options) {
  const std::vector<std::string> tiers{"quick", "full"};
  if (options.tier != tiers[0] && options.tier != tiers[1]) throw unknown_name("--tier", options.tier, tiers);
  return options.tier == "full" ? Tier::full : Tier::quick;
}

KnownTime time_from(RunStore* store) {
  return [store](const PlanRun& run) { return store ? store->known_seconds(run.file) : -1; };
}

// Batches without the runs that the store holds.
std::vector<Batch> missing_batches(std::vector<Batch> batches, const std::set<std::string>& missing) {
  std::vector<Batch> left;
  for (Batch& batch : batches) {
    std::vector<PlanRun> runs;
    for (PlanRun& run : batch.runs) {
      if (missing.count(run.file) > 0) runs.push_back(std::move(run));
    }
    batch.estimated_s *= batch.runs.empty() ? 1
                                            : static_cast<double>(runs.size()) / static_cast<double>(batch.runs.size());
    batch.runs = std::move(runs);
    if (!batch.runs.empty()) left.push_back(std::move(batch));
  }
  return left;
}

// `store`: of the results folder, where there is one.
Work work_of(const SweepOptions& options, RunStore* store) {
  std::optional<PlanDocument> document;
  if (!options.from.empty()) document.emplace(options.from);
  Work work;
  work.missing.tier = document ? document->tier() : options.tier;
  work.runs = document ? document->runs() : runs_of_tier(matching_cases(options.patterns), tier_of(options));
  std::vector<PlanRun> missing;
  std::set<std::string> names;
  for (const PlanRun& run : work.runs) {
    if (store && store->holds(*run.entry, run.file, run.frames)) {
      ++work.kept;
    } else {
      missing.push_back(run);
      names.insert(run.file);
    }
  }
  work.missing.batches = document && document->has_batches() ? missing_batches(document->batches(), names)
                                                             : batches_of(std::move(missing), time_from(store));
  return work;
}

int print_plan(const Invocation& invocation, const SweepOptions& options) {
  CommonOptions target = invocation.options;
  if (!target.json.empty()) {
    throw UsageError("--json", target.json, "without --plan", {},
                     "--json tells what became of runs, and --plan makes none: it writes the plan itself");
  }
  target.json = options.plan;
  std::optional<ResultsFolder> folder;
  std::optional<RunStore> store;
  if (std::error_code none; std::filesystem::is_directory(target.results, none)) {
    folder.emplace(target.results);
    store.emplace(*folder, invocation.provenance(), true);
  }
  Plan plan;
  std::vector<PlanRun> runs;
  if (options.from.empty()) {
    plan.tier = options.tier;
    runs = runs_of_tier(matching_cases(options.patterns), tier_of(options));
  } else {
    const PlanDocument document(options.from);
    plan.tier = document.tier();
    runs = document.runs();
  }
  plan.batches = batches_of(std::move(runs), time_from(store ? &*store : nullptr));
  write_json(target, to_json(plan));
  return 0;
}

// One run of a summary, from its file.
Json swept(const ResultsFolder& folder, const PlanRun& run) {
  const Json whole = Json::parse(read_hdf5_text(folder.path() + "/" + run.file, "/run"));
  Json kept = Json::object();
  kept["file"] = run.file;
  for (const char* key : {"case", "scheme", "settings", "steps", "points", "wall_s", "stop", "measures"})
    kept[key] = whole.at(key);
  return kept;
}

// What a sweep has come to.
struct Outcome {
  std::string tier;
  std::size_t made = 0, kept = 0;
  std::map<std::string, std::string> failed = {};
  bool files = false;       // a run failed for a file's sake
  bool misbehaved = false;  // in one an integrator of a plug-in did what none may
  int status() const {
    if (!failed.empty() && files) return exit_files;
    return misbehaved ? exit_stopped : failed.empty() ? 0 : exit_red;
  }
};

bool is_misbehaviour(const Json& stop) { return stop.is_object() && stop.at("field") == misbehaviour_field; }

// Looks at the runs that are there, too: what was made once is not made again.
Json document_of(Outcome& outcome, const std::vector<PlanRun>& runs, const ResultsFolder& folder,
                 const Provenance& provenance) {
  Json failed = Json::array(), made = Json::array();
  for (const PlanRun& run : runs) {
    if (const auto why = outcome.failed.find(run.file); why != outcome.failed.end()) {
      failed.push_back({{"file", run.file}, {"case", run.entry->name}, {"error", why->second}});
    } else {
      made.push_back(swept(folder, run));
      outcome.misbehaved = outcome.misbehaved || is_misbehaviour(made.back().at("stop"));
    }
  }
  return {{"tier", outcome.tier},
          {"wanted", runs.size()},
          {"made", outcome.made},
          {"kept", outcome.kept},
          {"failed", std::move(failed)},
          {"runs", std::move(made)},
          {"provenance", to_json(provenance)}};
}

void write_summary(const ResultsFolder& folder, const Json& document) {
  write_text_file(folder.path() + "/sweep.json", json_text(document, 1) + "\n");
}

// Makes the missing runs of some batches here and now. A run that fails does not keep the others from being made.
Outcome run_here(const std::vector<PlanRun>& runs, RunStore& store, const Output& out) {
  Outcome outcome;
  for (const PlanRun& run : runs) {
    try {
      if (store.holds(*run.entry, run.file, run.frames)) {
        ++outcome.kept;
        out.line("{}{}", kept_mark, run.file);
      } else {
        Making making;
        const RunResult result = make_run(*run.entry, run.scheme, run.settings, run.frames, making);
        store.keep(*run.entry, result, making);
        ++outcome.made;
        const bool misbehaved = result.stop && result.stop->field == misbehaviour_field;
        outcome.misbehaved = outcome.misbehaved || misbehaved;
        out.line("{}{} in {:.3g} s{}", made_mark, run.file, making.elapsed_s, result.stop ? ", stopped" : "");
      }
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception& error) {
      outcome.files = outcome.files || dynamic_cast<const FileError*>(&error);
      outcome.misbehaved = outcome.misbehaved || dynamic_cast<const MisbehavingIntegrator*>(&error);
      outcome.failed[run.file] = error.what();
      out.line("{}{}: {}", failed_mark, run.file, error.what());
    }
    std::fflush(nullptr);  // who reads may be waiting for the line, and this process may end any time
  }
  return outcome;
}

int sweep_batches(const Invocation& invocation, const SweepOptions& options) {
  if (options.from.empty()) {
    throw UsageError("--batch", options.batches.front(), "together with --from", {},
                     "--batch names a batch of a plan: --from says which plan");
  }
  const PlanDocument plan(options.from);
  std::vector<PlanRun> runs;
  for (const std::string& id : options.batches) {
    for (PlanRun& run : plan.batch(id).runs) {
      if (options.only.empty() || options.only == run.file) runs.push_back(std::move(run));
    }
  }
  const ResultsFolder folder(invocation.options.results);
  RunStore store(folder, invocation.provenance(), true);
  Outcome outcome = run_here(runs, store, Output(invocation.options));
  outcome.tier = plan.tier();
  if (!invocation.options.json.empty())
    write_json(invocation.options, document_of(outcome, runs, folder, invocation.provenance()));
  return outcome.status();
}

PoolOptions pool_options(const CommonOptions& common, const SweepOptions& options) {
  PoolOptions pool;
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  pool.jobs = options.jobs > 0 ? options.jobs : cores;
  pool.words = {"--results",    common.results,
                "--max-memory", fmt::format("{:.0f}", budget().memory),
                "--max-steps",  fmt::format("{}", budget().steps)};
  for (const std::string& word : plugin_words(common)) pool.words.push_back(word);
  return pool;
}

int sweep_all(const Invocation& invocation, const SweepOptions& options) {
  const CommonOptions& common = invocation.options;
  const Output out(common);
  const Provenance provenance = invocation.provenance();
  if (options.from.empty()) tier_of(options);  // a wrong call makes no folder
  const ResultsFolder folder(common.results);
  RunStore store(folder, provenance, true);
  const Work work = work_of(options, &store);
  Outcome outcome;
  outcome.tier = work.missing.tier;
  outcome.kept = work.kept;
  if (!work.missing.batches.empty()) {
    const PoolResult result = run_pool(work.missing, pool_options(common, options));
    outcome.made = result.made;
    outcome.failed = result.failed;
    outcome.files = result.files;
    outcome.misbehaved = result.misbehaved;
  }
  const Json document = document_of(outcome, work.runs, folder, provenance);
  write_summary(folder, document);
  out.line("{} runs: {} stored already, {} made, {} failed", work.runs.size(), outcome.kept, outcome.made,
           outcome.failed.size());
  for (const auto& [file, error] : outcome.failed) out.line("  {}: {}", file, error);
  write_json(common, document);
  return outcome.status();
}

int execute(const Invocation& invocation, const SweepOptions& options) {
  if (options.pool > 0) end_with_parent(options.pool);
  if (!options.plan.empty()) return print_plan(invocation, options);
  return options.batches.empty() ? sweep_all(invocation, options) : sweep_batches(invocation, options);
}

}  // namespace

Command add_sweep(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command(
      "sweep", "many runs: those that verify needs, or those of a plan",
      "Example: plumbline sweep 'sod*' --tier full --jobs 2, then plumbline verify 'sod*' --tier full --reuse\nA plan "
      "of "
      "one's own: {\"sweep\": {\"case\": [\"sod\"], \"cells\": [50, 100], \"ppc\": [4, 8]}}");
  auto options = std::make_shared<SweepOptions>();
  sub.option("pattern", options->patterns, "case names or patterns; all cases if none");
  sub.option("--tier", options->tier, "quick or full");
  sub.option("--jobs", options->jobs, "processes at once; one a core if not given").whole_number(1, 1024);
  sub.option("--plan", options->plan, "write the plan to a file, or - for standard output, and run nothing");
  sub.option("--from", options->from, "the runs of this plan (- for standard input) instead of a tier's");
  sub.option("--batch", options->batches, "this batch of the plan alone, in this process (repeatable)").repeatable();
  sub.option("--results", invocation.options.results, "results folder").not_empty();
  add_limits(sub);
  sub.option("--only", options->only, "of the batch this run alone").hidden();
  sub.option("--pool", options->pool, "the process that this one belongs to").hidden();
  add_json(sub, invocation.options);
  return {sub, [&invocation, options] { return execute(invocation, *options); }};
}

}  // namespace plumbline
