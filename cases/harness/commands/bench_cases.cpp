#include "cases/harness/commands/bench_cases.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <map>
#include <set>
#include <utility>

#include "cases/harness/description/prose.hpp"
#include "cases/harness/files/hdf5_file.hpp"
#include "cases/harness/files/signals.hpp"
#include "cases/harness/verify/verification.hpp"
#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

// Of this process, s. Other work on the machine must not decide what is measured.
double cpu_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

constexpr const char* york_levels = "levels/york1997";

void add_plan(const Case& entry, const StudyPlan& plan, Tier tier, std::vector<CostRun>& runs) {
  for (PlannedRun& planned : planned_runs(entry, plan, tier)) {
    if (planned.is_offset) continue;
    const std::string scheme = plan.scheme == "default" ? integrator_scheme(entry, planned.settings.text("integrator"))
                                                        : plan.scheme;
    runs.push_back({&entry, plan.scheme, scheme, plan.id, plan.vary, planned.value, std::move(planned.settings)});
  }
}

// The problem that the study `default` solves: what is compared with it must solve the same.
std::vector<Override> problem_of_default(const Case& entry) {
  std::vector<Override> chosen, problem;
  for (const StudyPlan& plan : entry.studies) {
    if (plan.id == "default") chosen = plan.overrides;
  }
  const Settings settings = entry.settings("default", chosen);
  for (const Key& key : entry.keys) {
    if (!is_numerical(entry, key.name)) problem.emplace_back(key.name, settings[key.name]);
  }
  return problem;
}

// Whatever a scheme costs at one level says little: York's own is compared at the levels of the default scheme.
void add_york_levels(const Case& entry, const std::vector<StudyPlan>& plans, Tier tier, std::vector<CostRun>& runs) {
  const bool is_compared = std::any_of(plans.begin(), plans.end(), [](const StudyPlan& plan) {
    return plan.scheme == "york1997" && plan.vary == Vary::cells;
  });
  if (!is_compared) return;
  StudyPlan plan{.id = york_levels, .title = "York 1997", .why = "His scheme at the levels of the default."};
  plan.scheme = "york1997";
  plan.overrides = problem_of_default(entry);
  plan.values = entry.levels;
  add_plan(entry, plan, tier, runs);
}

// Error over cell size and step: what a smaller step costs, and what it gives.
void add_surface(const Case& entry, std::vector<CostRun>& runs) {
  for (const char* scheme : {"default", "york1997"}) {
    for (const double cells : {50.0, 100.0, 200.0, 400.0}) {
      for (const double courant : {0.0125, 0.025, 0.05, 0.1, 0.2, 0.5, 0.9}) {
        Settings settings = entry.settings(scheme, {{"cells", cells}, {"cfl", courant}});
        runs.push_back({&entry, scheme, scheme, "surface", Vary::dt, courant, std::move(settings)});
      }
    }
  }
}

// s, from a few steps.
double estimate(const CostRun& run) {
  constexpr int tried = 3;
  const auto problem = run.entry->problem(run.settings);
  Simulation simulation(problem->scene(), run.settings.text("integrator"), step_control(run.settings));
  simulation.step(HUGE_VAL);
  const double start = cpu_time();
  for (int k = 0; k < tried; ++k) simulation.step(HUGE_VAL);
  return std::ceil(problem->end_time() / simulation.last_dt()) * (cpu_time() - start) / tried;
}

// The document of the run as an earlier verification stored it; null if there is none.
Json stored_run(const CostRun& run, const std::string& results) {
  const RunResult named(run.entry->name, run.scheme, run.settings);
  try {
    return Json::parse(read_hdf5_text(results + "/" + ResultsFolder::run_name(named), "/run"));
  } catch (const FileError&) {
    return nullptr;
  } catch (const Json::exception&) {
    return nullptr;
  }
}

constexpr double no_time = -1;

struct Timed {
  const CostRun* run;
  CostSample sample{};
  double expected = 0;         // s; no_time: too long
  double spent = 0, last = 0;  // s, setting up included; of the repeats

  void take() {
    const double start = cpu_time();
    RunResult result = run_experiment(*run->entry, run->called, run->settings);
    last = cpu_time() - start;
    if (!sample.wall_s.empty()) spent += last;
    sample.wall_s.push_back(result.wall_s);
    if (sample.wall_s.size() == 1) sample.document = run_document(result, {}, {});
  }
};

// From the stored run, else by trying a step. A run whose step cannot even be tried is left to its study to explain.
double expected_time(const CostRun& run, const Json& stored, double most) {
  double expected = 0;
  if (stored.is_object() && stored.value("wall_s", 0.0) > 0) {
    expected = stored["wall_s"].get<double>();
  } else {
    try {
      expected = estimate(run);
    } catch (const InadmissibleState&) {
      return no_time;
    }
  }
  return expected <= most ? expected : no_time;
}

// One round over the runs, the shortest first: what has no time is left out of repeats before it is left out of errors.
void take_round(std::vector<Timed>& timed, bool is_last, const CostBudget& budget, double end) {
  for (Timed& one : timed) {
    if (cpu_time() > end) return;
    const bool is_short = one.expected <= budget.of_run / 2;
    const bool has_time = one.sample.wall_s.empty() || one.spent + one.last <= budget.of_run;
    if (one.expected != no_time && has_time && (is_short || is_last)) one.take();
    throw_if_interrupted();
  }
}

Json errors_of(const Json& measures) {
  Json errors = Json::object();
  for (const auto& [name, measure] : measures.items()) {
    if (measure["error"].is_null() || measure["relative_error"].is_null()) continue;
    errors[name] = {{"error", measure["error"]}, {"relative_error", measure["relative_error"]}};
  }
  return errors;
}

// Of the case's own keys those that are not the default scheme's: where some that are not numerical differ, so does the problem.
Json own_choices(const CostRun& run) {
  const Settings usual = run.entry->settings("default", {});
  Json choices = Json::object();
  for (const Key& key : run.entry->keys) {
    if (run.settings[key.name] != usual[key.name]) choices[key.name] = to_json(run.settings[key.name]);
  }
  return choices;
}

}  // namespace

std::string CostRun::key() const { return entry->name + "\n" + called + "\n" + settings.canonical(); }

std::vector<CostRun> cost_runs(const Case& entry, Tier tier) {
  std::vector<CostRun> runs;
  if (!entry.trials.empty()) return runs;
  const std::vector<StudyPlan> plans = entry.studies;
  for (const StudyPlan& plan : plans) {
    if (plan.vary == Vary::cells && (plan.tier == Tier::quick || tier == Tier::full)) add_plan(entry, plan, tier, runs);
  }
  if (entry.any_integrator) {
    for (const IntegratorEntry& integrator : integrators()) {
      StudyPlan plan = integrator_plan(entry, integrator.name);
      for (Override& choice : problem_of_default(entry)) plan.overrides.push_back(std::move(choice));
      plan.values = entry.levels;
      add_plan(entry, plan, tier, runs);
    }
  }
  add_york_levels(entry, plans, tier, runs);
  if (entry.name == "sod") add_surface(entry, runs);
  return runs;
}

CostBudget cost_budget(Tier tier) { return tier == Tier::quick ? CostBudget{0.2, 0.04, 15} : CostBudget{20, 1.5, 180}; }

std::vector<CostSample> time_cost_runs(const std::vector<CostRun>& runs, int repeats, const CostBudget& budget,
                                       const std::string& results) {
  const double end = cpu_time() + budget.in_all;
  std::map<std::string, const Timed*> known;
  std::set<std::string> of_york;  // one level of what all others are compared with would not do
  for (const CostRun& run : runs) {
    if (run.study == york_levels) of_york.insert(run.key());
  }
  std::vector<Timed> timed;
  for (const CostRun& run : runs) {
    if (!known.try_emplace(run.key(), nullptr).second) continue;
    timed.push_back({&run});
    Json& stored = timed.back().sample.document;
    stored = stored_run(run, results);
    const double most = (of_york.count(run.key()) > 0 ? 6 : 1) * budget.longest_run;
    timed.back().expected = expected_time(run, stored, most);
    throw_if_interrupted();
  }
  std::stable_sort(timed.begin(), timed.end(), [](const Timed& a, const Timed& b) { return a.expected < b.expected; });
  for (int round = 1; round <= repeats; ++round) take_round(timed, round == repeats, budget, end);
  for (const Timed& one : timed) known[one.run->key()] = &one;
  std::vector<CostSample> samples;
  for (const CostRun& run : runs) samples.push_back(known[run.key()]->sample);
  return samples;
}

Json cost_run_name(const CostRun& run) {
  return {{"case", run.entry->name},
          {"scheme", run.scheme},
          {"study", run.study},
          {"vary", name(run.vary)},
          {"value", run.value}};
}

Json cost_entry(const CostRun& run, const CostSample& sample) {
  const Json& document = sample.document;
  if (!document.is_object() || document["steps"] == 0) return nullptr;
  const bool is_timed = !sample.wall_s.empty();
  const long points = document["points"].get<long>(), steps = document["steps"].get<long>();
  const double time = document["time"].get<double>();
  Json entry = cost_run_name(run);
  entry.update({{"kind", name(run.entry->kind)},
                {"differs", own_choices(run)},
                {"cells", run.settings.integer("cells")},
                {"h", document["h"]},
                {"dt", time / static_cast<double>(steps)},
                {"points", points},
                {"steps", steps},
                {"particle_steps", points * steps},
                {"finished", document["finished"]},
                {"source", is_timed ? "timed" : "stored"},
                {"wall_s", is_timed ? Json(sample.wall_s) : Json::array({document["wall_s"]})},
                {"instructions", nullptr},
                {"errors", errors_of(document["measures"])}});
  return entry;
}

}  // namespace plumbline
