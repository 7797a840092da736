#include "cases/harness/verify/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cases/harness/results/results.hpp"
#include "cases/harness/run/estimate.hpp"
#include "cases/harness/run/guarded_integrator.hpp"
#include "kernel/inadmissible.hpp"

namespace plumbline {

PlanRun planned_run(const Case& entry, const std::string& scheme, Settings settings, FrameRequest frames) {
  const std::string shown = result_scheme(entry, scheme, settings);
  const std::string file = ResultsFolder::run_name(entry.name, shown, settings);
  return {&entry, scheme, {}, std::move(settings), frames, file};
}

namespace {

// Adds a run, or what it asks for beyond the same run that is there already.
void add_once(PlanRun run, std::vector<PlanRun>& runs, std::map<std::string, std::size_t>& places) {
  const auto [at, is_new] = places.emplace(run.file, runs.size());
  if (is_new) {
    runs.push_back(std::move(run));
    return;
  }
  FrameRequest& wanted = runs[at->second].frames;
  wanted = of_both(wanted, run.frames);
}

}  // namespace

std::vector<PlanRun> each_once(std::vector<PlanRun> runs) {
  std::vector<PlanRun> kept;
  std::map<std::string, std::size_t> places;
  for (PlanRun& run : runs) add_once(std::move(run), kept, places);
  return kept;
}

std::vector<PlanRun> runs_of_tier(const std::vector<const Case*>& entries, Tier tier) {
  std::vector<PlanRun> runs;
  for (const Case* entry : entries) {
    for (const StudyPlan& plan : selected_studies(*entry, tier, {})) {
      for (PlannedRun& planned : planned_runs(*entry, plan, tier)) {
        runs.push_back(planned_run(*entry, plan.scheme, std::move(planned.settings), planned.frames));
        runs.back().study = plan.id;
      }
    }
  }
  return each_once(std::move(runs));
}

namespace {

constexpr double long_run_s = 2, batch_s = 3;
constexpr std::size_t most_in_batch = 100;

struct Weighed {
  PlanRun run;
  double seconds, memory_mb;
};

Weighed weighed(PlanRun run, const KnownTime& known) {
  RunEstimate estimate;
  try {
    estimate = estimate_run(*run.entry, run.settings);
  } catch (const InadmissibleState&) {
    estimate.steps = 1;  // it stops at once
  } catch (const MisbehavingIntegrator&) {
    estimate.steps = 1;
  }
  const double measured = known ? known(run) : -1;
  return {std::move(run), measured >= 0 ? measured : estimate.seconds, estimate.bytes / 1e6};
}

void add_to_batch(Weighed item, Batch& batch) {
  batch.estimated_s += item.seconds;
  batch.memory_mb = std::max(batch.memory_mb, item.memory_mb);
  batch.runs.push_back(std::move(item.run));
}

}  // namespace

std::vector<Batch> batches_of(std::vector<PlanRun> runs, const KnownTime& known) {
  std::vector<Weighed> items;
  for (PlanRun& run : runs) items.push_back(weighed(std::move(run), known));
  std::vector<Batch> batches;
  Batch small;
  const auto put = [&](Batch& batch) {
    if (!batch.runs.empty()) batches.push_back(std::move(batch));
    batch = Batch{};
  };
  for (Weighed& item : items) {
    if (item.seconds >= long_run_s) {
      Batch alone;
      alone.large = true;
      add_to_batch(std::move(item), alone);
      put(alone);
      continue;
    }
    add_to_batch(std::move(item), small);
    if (small.estimated_s >= batch_s || small.runs.size() >= most_in_batch) put(small);
  }
  put(small);
  std::stable_sort(batches.begin(), batches.end(), [](const Batch& a, const Batch& b) {
    return a.large != b.large ? a.large : a.large && a.estimated_s > b.estimated_s;
  });
  for (std::size_t k = 0; k < batches.size(); ++k) {
    batches[k].id = fmt::format("{:04}-{}", k + 1, batches[k].large ? "large" : "small");
  }
  return batches;
}

namespace {

// The choices that lead from the scheme's own to these settings.
Json identifying(const PlanRun& run) {
  const Settings plain = run.entry->settings(run.scheme, {});
  Json chosen = Json::object();
  for (const Key& key : run.settings.keys()) {
    if (key.value == plain[key.name]) continue;
    chosen[key.name] = std::holds_alternative<std::monostate>(key.value) ? Json("none") : to_json(key.value);
  }
  return chosen;
}

Json to_json(const PlanRun& run) {
  Json document{{"case", run.entry->name}, {"scheme", run.scheme},         {"study", run.study},
                {"cells", nullptr},        {"settings", identifying(run)}, {"file", run.file}};
  if (run.settings.has("cells")) document["cells"] = run.settings.integer("cells");
  document["frames"] = run.frames.count == 0
                           ? Json(nullptr)
                           : Json{{"count", run.frames.count}, {"most_points", run.frames.most_points}};
  return document;
}

Json rounded(double value) { return std::round(value * 1e4) / 1e4; }

}  // namespace

Json to_json(const Plan& plan) {
  Json batches = Json::array();
  for (const Batch& batch : plan.batches) {
    Json runs = Json::array();
    for (const PlanRun& run : batch.runs) runs.push_back(to_json(run));
    batches.push_back({{"id", batch.id},
                       {"size", batch.large ? "large" : "small"},
                       {"estimated_s", rounded(batch.estimated_s)},
                       {"memory_mb", rounded(batch.memory_mb)},
                       {"runs", std::move(runs)}});
  }
  return {{"plan", plan_format}, {"tier", plan.tier}, {"batches", std::move(batches)}};
}

}  // namespace plumbline
