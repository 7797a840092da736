#include "cases/harness/exchange/score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "cases/harness/exchange/balance.hpp"
#include "cases/harness/exchange/result_file.hpp"
#include "cases/harness/files/errors.hpp"
#include "cases/harness/results/results.hpp"

namespace plumbline {
namespace {

constexpr double same_time = 1e-9;  // of the end time: rounding of a sum of steps

constexpr double kept = 1e-6;
constexpr const char* kept_reason =
    "the share of a number in single precision is 6e-8; a sum of such numbers is not off by more than ten times that "
    "unless something is lost";

constexpr const char* energy_reason =
    "the start's energy and the most that loads and pistons can have added, of all points, also where no field is "
    "judged; "
    "twice that, for programs that do not conserve it";

struct Judged {
  RunResult run;
  Balance balance;
  std::vector<Measure> idle;  // the measures of the start, had nothing been done
};

// Mass alone is booked; all else of the ledger is not known of a final state, and not a number.
Ledger ledger_of(double mass_at_start, double mass_at_end) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  Totals totals;
  totals.mass = mass_at_start;
  totals.grid_mass = mass_at_end;
  totals.momentum = totals.angular_momentum = {unknown, unknown, unknown};
  totals.momentum_scale = totals.angular_scale = unknown;
  totals.energy = {unknown, unknown, unknown};
  Ledger ledger;
  ledger.open(totals);
  ledger.close_step(totals);
  ledger.viscous = unknown;
  return ledger;
}

UsageError does_not_fit(const ResultFile& file, const std::string& what, const std::string& value,
                        const std::string& allowed) {
  return UsageError("--result", value, allowed, {},
                    fmt::format("{}: {} is {}; {} is wanted", file.path(), what, value, allowed));
}

// The choices that another program's run has: the case's own keys and the mesh.
Settings physics_of(const Case& entry, const Settings& settings) {
  std::vector<Key> keys;
  for (const Key& key : settings.keys()) {
    const auto own = entry.keys;
    const bool physical = key.name == "cells" ||
                          std::any_of(own.begin(), own.end(), [&](const Key& k) { return k.name == key.name; });
    if (physical) keys.push_back(key);
  }
  return Settings(std::move(keys));
}

void require_fit(const ResultFile& file, const Case& entry, const Settings& settings, double end_time) {
  if (file.case_name != entry.name) throw does_not_fit(file, "the case", file.case_name, entry.name);
  const std::string id = problem_id(entry, settings);
  if (!file.problem.empty() && file.problem != id) {
    throw does_not_fit(file, "problem", file.problem, id + ", that of the case's own keys with this --set");
  }
  if (const std::string start = start_id(entry, settings); file.start != start) {
    throw does_not_fit(file, "start", file.start, fmt::format("{}, that of the start at {} cells", start, file.cells));
  }
  if (!(std::abs(file.time - end_time) <= same_time * end_time)) {
    throw does_not_fit(file, "time", fmt::format("{} s", file.time), fmt::format("{} s", end_time));
  }
}

Judged judge_file(const Case& entry, const ResultFile& file, const std::vector<std::string>& typed) {
  const Settings settings = entry.settings("default", {{"cells", static_cast<double>(file.cells)}}, typed);
  const auto problem = entry.problem(settings);
  require_fit(file, entry, settings, problem->end_time());
  const Scene scene = problem->scene();
  const std::vector<HandedIn> bodies = file.points(scene);
  const Balanced found = balance_of(*problem, settings, bodies);
  const auto simulation = simulation_of(*problem, settings, bodies, problem->end_time());
  Judged judged{RunResult(entry.name, "foreign:" + file.program, physics_of(entry, settings)), {}, {}};
  RunResult& run = judged.run;
  run.dim = scene.grid.dim;
  run.axisymmetric = scene.grid.axisymmetric;
  run.h = scene.grid.h;
  run.end_time = problem->end_time();
  run.steps = file.steps;
  run.dt = file.steps > 0 ? file.time / static_cast<double>(file.steps) : 0;
  run.points = simulation->points();
  run.wall_s = file.wall_s;
  run.ledger = ledger_of(found.mass_at_start, found.mass_at_end);
  run.measures = measures_at_end(*problem, *simulation);
  run.profile = problem->profile(*simulation);
  if (run.profile.kind != "space") run.profile = {};
  run.finished = true;
  run.file = ResultsFolder::run_name(run);
  judged.idle = measures_of_start(*entry.problem(settings), settings);
  judged.balance = found.balance;
  return judged;
}

// The case's study of its default scheme over meshes whose problem this is, and the settings of its level.
std::optional<StudyPlan> declared_plan(const Case& entry, int cells, const std::vector<std::string>& typed) {
  const Settings wanted = entry.settings("default", {{"cells", static_cast<double>(cells)}}, typed);
  for (StudyPlan plan : entry.studies) {
    if (plan.vary != Vary::cells || plan.scheme != "default") continue;
    plan.values = {static_cast<double>(cells)};
    const Settings declared = planned_runs(entry, plan, Tier::quick).front().settings;
    if (physics_of(entry, declared) == physics_of(entry, wanted)) return plan;
  }
  return std::nullopt;
}

// A number that is known already.
Number known(std::string quantity, std::optional<double> value) {
  return number_of(std::move(quantity), [value](const StudyResult&) {
    Measured measured;
    measured.value = value;
    return measured;
  });
}

CaseGate kept_gate(std::string id, std::string what, std::optional<double> value) {
  return gate(std::move(id), known(std::move(what), value), at_most(kept), identity(kept_reason));
}

// Of a field's mean error, over the mean size of its reference: what any mesh that resolves the case at all stays below.
// Half of what doing nothing leaves is the least that a computation has to achieve; below 30 % that asks more of a field that
// hardly changes than a coarse mesh has, above 50 % a field of zeros would do.
constexpr double least_bound = 0.3, largest_bound = 0.5;
constexpr const char* computed_reason =
    "half of the error of the start handed back, at least 30 % and at most 50 % of the field's own size: more is left "
    "by doing nothing, by zeros and by wrong units";

// The largest mean error of a field over its bound, over all meshes; NaN if there is none to be had. Nothing: on some mesh the
// reference vanishes.
std::optional<double> error_over_bound(const std::string& name, const StudyResult& study,
                                       const std::vector<std::vector<Measure>>& idle) {
  double worst = 0;
  for (std::size_t k = 0; k < study.levels.size(); ++k) {
    const Measure* const own = study.levels[k].run.find(name);
    const auto start = std::find_if(idle[k].begin(), idle[k].end(), [&](const Measure& m) { return m.name == name; });
    if (!own || start == idle[k].end() || own->scale <= own->reference_bound) return std::nullopt;
    // The start may have no point where the end is judged, and then no error.
    const double far = std::isfinite(start->error) ? start->error / own->scale : HUGE_VAL;
    worst = larger(worst, own->error / (own->scale * std::clamp(far / 2, least_bound, largest_bound)));
  }
  return worst;
}

// A program that computed something: each field is nearer to its reference than the start is.
void judge_fields(const StudyResult& study, const std::vector<std::vector<Measure>>& idle, Score& score) {
  std::vector<CaseGate> gates;
  for (const Measure& measure : study.levels.front().run.measures) {
    if (!measure.name.ends_with(".L1")) continue;
    const std::string id = study.plan.id + "/foreign-" + measure.name;
    if (const auto value = error_over_bound(measure.name, study, idle)) {
      gates.push_back(gate(id, known("error of " + measure.name + " over its bound", value), at_most(1.0),
                           theory(computed_reason)));
    } else {
      score.not_judged.push_back({id, "the reference vanishes at the end"});
    }
  }
  for (JudgedGate& gate : judge_gates(gates, study)) score.gates.push_back(std::move(gate));
}

// Gates that hold for any program.
void judge_generic(const std::vector<Balance>& balances, const StudyResult& study, Score& score) {
  Balance worst;
  for (const Balance& b : balances) worst.take_worse(b);
  const std::string id = study.plan.id;
  std::vector<CaseGate> gates{
      kept_gate(id + "/foreign-mass", "relative difference of the points' mass to the start's", worst.mass)};
  gates.push_back(gate(id + "/foreign-energy",
                       known("energy of motion and heat over all that there can be", worst.energy), at_most(2.0),
                       theory(energy_reason)));
  if (worst.momentum) {
    gates.push_back(
        kept_gate(id + "/foreign-momentum", "difference of momentum to the start's over sum m |v|", worst.momentum));
  } else {
    score.not_judged.push_back({id + "/foreign-momentum", "something outside the bodies pushes in every direction"});
  }
  if (study.levels.back().run.find("coverage")) {
    gates.push_back(gate(id + "/foreign-coverage", value_at("coverage", study.levels.back().value), between(0.99, 1.01),
                         identity("gas fills its space: volumes of the points add up to it, within 1 %")));
  }
  for (JudgedGate& gate : judge_gates(gates, study)) score.gates.push_back(std::move(gate));
}

// Why a declared gate says nothing of another program; empty if it does.
std::string why_not(const CaseGate& gate, const StudyResult& study) {
  if (gate.gate.origin == Origin::regression) return "compares with a run of Plumbline's own scheme";
  if (gate.gate.expected_failure) {
    return "Plumbline's own scheme is expected to miss it: " + gate.gate.expected_failure->cause;
  }
  for (const std::string& other : gate.also) return "compares with the study " + other;
  for (const double level : gate.levels) {
    if (!study.level(level)) return fmt::format("asks for {} cells", level);
  }
  if (gate.levels.empty() && study.levels.size() < 2) return "asks for a refinement series";
  return "";
}

// An order that is required of Plumbline's own scheme binds others no further than theory does.
Gate for_any_program(Gate gate) {
  constexpr double least_order = 0.4;
  const bool of_order = gate.order || gate.quantity.starts_with("fitted order of ");  // see fitted_order_gate
  if (of_order && gate.origin == Origin::requirement && gate.expected.low) {
    gate.expected.low = std::min(*gate.expected.low, least_order);
    gate.origin = Origin::theory;
    gate.reason = "what converges is at least of order 1/2, as schemes of first order at a contact; 0.1 for the fit";
  }
  return gate;
}

bool all_measures_finite(const StudyResult& study) {
  for (const StudyLevel& at : study.levels) {
    for (const Measure& m : at.run.measures) {
      if (!std::isfinite(m.error)) return false;
    }
  }
  return true;
}

void judge_declared(const Case& entry, const StudyResult& study, Score& score) {
  const bool finite = all_measures_finite(study);
  for (CaseGate gate : entry.gates) {
    if (gate.study != study.plan.id) continue;
    gate.gate = for_any_program(std::move(gate.gate));
    std::string reason = why_not(gate, study);
    std::vector<JudgedGate> judged;
    if (reason.empty()) judged = judge_gates({gate}, study);
    // All that is not a measure is not a number here, and measures seen on the way are missing.
    const bool reads_more = finite && !judged.empty() &&
                            (judged.front().measured.invalid || std::isnan(judged.front().measured.value.value_or(0)));
    if (reads_more) reason = "reads what a final state does not have: the ledger, or what was seen on the way";
    if (reason.empty()) {
      score.gates.push_back(judged.front());
    } else {
      score.not_judged.push_back({gate.gate.id, reason});
    }
  }
}

void require_one_series(const std::vector<std::unique_ptr<ResultFile>>& files) {
  for (std::size_t k = 1; k < files.size(); ++k) {
    const ResultFile &file = *files[k], &first = *files.front();
    if (file.cells == files[k - 1]->cells) {
      throw does_not_fit(file, "cells", std::to_string(file.cells), "each mesh once in a series");
    }
    if (file.program != first.program || file.version != first.version) {
      throw does_not_fit(file, "program", file.program + " " + file.version, first.program + " " + first.version);
    }
  }
}

}  // namespace

Score score(const Case& entry, const std::vector<std::string>& names, const std::vector<std::string>& typed,
            double patience) {
  const std::string refused = why_not_scored(entry, entry.settings("default", {}, typed));
  if (!refused.empty()) {
    throw UsageError("case", entry.name, "a case that `plumbline list` shows as scored", {},
                     entry.name + " cannot be scored: " + refused);
  }
  std::vector<std::unique_ptr<ResultFile>> files;
  for (const std::string& name : names) files.push_back(std::make_unique<ResultFile>(name, patience));
  std::stable_sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a->cells < b->cells; });
  require_one_series(files);

  Score score;
  score.program = files.front()->program;
  score.version = files.front()->version;
  std::vector<PlannedRun> planned;
  std::vector<RunResult> runs;
  std::vector<Balance> balances;
  std::vector<std::vector<Measure>> idle;
  for (const auto& file : files) {
    Judged judged = judge_file(entry, *file, typed);
    idle.push_back(std::move(judged.idle));
    planned.push_back({static_cast<double>(file->cells), judged.run.settings});
    balances.push_back(judged.balance);
    runs.push_back(std::move(judged.run));
    score.files.push_back(file->path());
  }
  StudyPlan plan{.id = "foreign", .title = "final states of another program", .why = "No study of the case is this."};
  if (const auto declared = declared_plan(entry, files.front()->cells, typed)) {
    plan = *declared;
    score.declared = plan.id;
  }
  plan.scheme = runs.front().scheme;
  plan.overrides = {};
  plan.values.clear();
  for (const auto& file : files) plan.values.push_back(file->cells);
  score.study = assemble_study(entry, plan, planned, std::move(runs));
  judge_generic(balances, score.study, score);
  judge_fields(score.study, idle, score);
  judge_declared(entry, score.study, score);
  return score;
}

std::vector<JudgedGate> gates_of_level(const Score& score, const StudyLevel& at) {
  if (score.study.levels.size() == 1) return score.gates;
  std::vector<JudgedGate> gates;
  for (const JudgedGate& gate : score.gates) {
    if (gate.run_ids.size() == 1 && gate.run_ids.front() == at.run.file) gates.push_back(gate);
  }
  return gates;
}

}  // namespace plumbline
