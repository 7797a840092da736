#include <filesystem>

#include "cases/harness/commands/command.hpp"
#include "cases/harness/commands/run_checkpoints.hpp"
#include "cases/harness/judge/undeclared.hpp"
#include "cases/harness/results/paraview_files.hpp"
#include "cases/harness/run/estimate.hpp"

namespace plumbline {
namespace {

struct RunOptions {
  std::optional<std::string> case_name;
  std::optional<int> cells, frames;
  bool dry = false;
  CheckpointOptions checkpoints = {};
};

// The declared study and level that these choices are one run of, if any.
struct Declared {
  StudyPlan plan;
  double value = 0;
};

std::optional<Declared> declared_run(const Case& entry, const std::string& scheme, const Settings& settings) {
  for (const StudyPlan& plan : entry.studies) {
    if (plan.scheme != scheme || plan.vary == Vary::dt) continue;
    for (const Tier tier : {Tier::quick, Tier::full}) {
      for (const PlannedRun& planned : planned_runs(entry, plan, tier)) {
        if (!planned.is_offset && planned.settings == settings) return Declared{plan, planned.value};
      }
    }
  }
  return std::nullopt;
}

std::vector<JudgedGate> judge_run(const Case& entry, const RunResult& run, const std::optional<Declared>& declared) {
  StudyPlan plan = declared ? declared->plan : StudyPlan{.id = "run", .title = "one run", .why = {}};
  StudyResult study{&entry, plan, run.scheme, {}, {}, {}, nullptr};
  study.levels.push_back({declared ? declared->value : run.settings.number("cells"), run.h, run, {}});
  std::vector<CaseGate> gates;
  for (CaseGate gate : entry.gates) {
    if (declared && gate.study == plan.id && gate.levels.size() == 1 && gate.also.empty())
      gates.push_back(std::move(gate));
  }
  for (CaseGate& gate : generic_gates(plan.id, run.dim, run.axisymmetric)) gates.push_back(std::move(gate));
  if (!declared) {
    for (CaseGate& gate : undeclared_gates(study)) gates.push_back(std::move(gate));
  }
  return judge_gates(gates, study);
}

void print_ledger(const Output& out, const Ledger& l) {
  out.line(
      "  ledger             energy {:.8g} -> {:.8g} J (kinetic {:.4g}, internal {:.4g}, elastic {:.4g}), relative "
      "drift {:.1e}",
      l.energy.initial(), l.energy.store(), l.stores.kinetic, l.stores.internal, l.stores.elastic,
      l.energy.relative_drift(false));
  for (int f = 0; f < flow_count; ++f) {
    const double amount = l.energy.flow(static_cast<Flow>(f));
    if (amount != 0) out.line("    {:16} {:+.6e} J", flow_names[static_cast<std::size_t>(f)], amount);
  }
  out.line("  momentum drift {:.1e}, mass drift {:.1e}", l.momentum[0].relative_drift(true),
           l.mass.relative_drift(false));
}

void print(const Output& out, const RunResult& run, const std::vector<JudgedGate>& gates, bool expected) {
  const bool is_trial = run.dim == 0;
  if (is_trial) {
    out.line("{}, trial {}: {:.4g} s", run.case_name, run.settings.text("trial"), run.wall_s);
  } else {
    out.line("{} under {}: {} points, {} steps to t = {:.6g} s in {:.4g} s, {:.3g} particle-steps/s", run.case_name,
             run.scheme, run.points, run.steps, run.end_time, run.wall_s, run.particle_steps_per_s());
  }
  if (run.stop) {
    out.line("STOPPED at step {} (t = {:.6g} s): {}; point {}, field {}, value {:.6g}", run.stop->step, run.stop->time,
             run.stop->reason, run.stop->point, run.stop->field, run.stop->value);
  }
  for (const Measure& m : run.measures) {
    if (m.value) {
      out.line("  {:18} {:.8g} {} (reference {:.8g}, error {:.3g})", m.name, *m.value, m.unit, m.reference.value_or(0),
               m.error);
    } else {
      out.line("  {:18} error {:.4g} {}, relative {:.3g}, reference bound {:.1e}", m.name, m.error, m.unit,
               m.error / m.scale, m.reference_bound);
    }
  }
  if (!is_trial) print_ledger(out, run.ledger);
  out.line("  expectation: {}", expected ? "declared" : "none");
  out.gates(gates);
}

int dry_run(const Output& out, const Invocation& invocation, const Case& entry, const std::string& scheme,
            const Settings& settings) {
  const RunEstimate estimate = estimate_run(entry, settings);
  out.line("{} under {}: {} points, {} cells, about {} steps, {:.3g} MB, about {:.2g} s", entry.name, scheme,
           estimate.points, estimate.cells, estimate.steps, estimate.bytes / 1e6, estimate.seconds);
  write_json(invocation.options, {{"case", entry.name},
                                  {"scheme", scheme},
                                  {"settings", to_json(settings)},
                                  {"dry_run", true},
                                  {"points", estimate.points},
                                  {"cells", static_cast<long>(estimate.cells)},
                                  {"steps", static_cast<long>(estimate.steps)},
                                  {"bytes", estimate.bytes},
                                  {"estimated_s", estimate.seconds}});
  return 0;
}

FrameRequest frames_of(const RunOptions& options) {
  if (!options.frames) return {};
  if (*options.frames < 2 || *options.frames > most_frames) {
    const std::string given = std::to_string(*options.frames), allowed = fmt::format("[2, {}]", most_frames);
    throw UsageError("--frames", given, allowed, {},
                     fmt::format("--frames {}: a number of snapshots in {} is wanted, the first and the last instant "
                                 "being two of them",
                                 given, allowed));
  }
  return {*options.frames, 0};
}

// The files for ParaView beside the run's own, and what its document says of them; nothing for a run without frames.
Json write_films(const Output& out, const ResultsFolder& folder, const RunResult& run) {
  const std::string name = std::filesystem::path(run.file).stem(), films = name + "-frames";
  const std::string list = write_paraview_files(folder.path() + "/" + films, name, run.frames);
  if (list.empty()) return nullptr;
  out.line("  {} frames for ParaView: {}", run.frames.frames.size(), list);
  return {{"count", run.frames.frames.size()}, {"series", fmt::format("{}/{}.hdf.series", films, name)}};
}

RunChoice chosen_run(const Invocation& invocation, const RunOptions& options) {
  if (!options.case_name) {
    throw UsageError("case", "", "a case, or --resume FILE", {},
                     "run wants a case, as in `plumbline run sod`, or --resume FILE; `plumbline list` names the cases");
  }
  const Case& entry = find_case(*options.case_name);
  const auto chosen = chosen_schemes(invocation.options);
  if (chosen.size() > 1)
    throw UsageError("--scheme", chosen[1].scheme, "one scheme or integrator", {},
                     "run takes one scheme or integrator; converge takes several");
  std::vector<Override> overrides = chosen[0].overrides;
  if (options.cells) overrides.emplace_back("cells", static_cast<double>(*options.cells));
  Settings settings = entry.settings(chosen[0].scheme, overrides, invocation.options.settings);
  if (!entry.trials.empty() && (options.frames || options.checkpoints.file || options.checkpoints.every)) {
    const char* key = options.frames ? "--frames" : "--checkpoint";
    throw UsageError(key, entry.name, "a case of runs", {},
                     fmt::format("{}: {} has trials, without steps", key, entry.name));
  }
  return {&entry, chosen[0].scheme, std::move(settings), frames_of(options)};
}

RunChoice resumed_run(const Invocation& invocation, const RunOptions& options, const RunCheckpoints& checkpoints,
                      RunChoice kept) {
  if (options.dry) {
    throw UsageError("--dry-run", "", "without --resume", {},
                     "--dry-run estimates a whole run: it cannot be asked together with --resume");
  }
  checkpoints.refuse_other_choices(invocation.options, kept, options.case_name, options.cells, options.frames);
  return kept;
}

// A state that is whole, but none of this run: files are sealed, so somebody has made it so.
RunResult made_run(const RunChoice& choice, RunCheckpoints& checkpoints, Making& making, int threads) {
  try {
    return make_run(*choice.entry, choice.scheme, choice.settings, choice.frames, making, threads,
                    checkpoints.states(choice));
  } catch (const ArchiveError& error) {
    const std::string& file = checkpoints.resumed_file();
    throw FileError(file, fmt::format("{}: the state in it is damaged: {}", file, error.what()));
  }
}

int execute(const Invocation& invocation, const RunOptions& options) {
  RunCheckpoints checkpoints(options.checkpoints);
  std::optional<RunChoice> kept = checkpoints.resumed();
  const RunChoice choice = kept ? resumed_run(invocation, options, checkpoints, std::move(*kept))
                                : chosen_run(invocation, options);
  const Case& entry = *choice.entry;
  const Output out(invocation.options);
  if (options.dry) return dry_run(out, invocation, entry, choice.scheme, choice.settings);
  const ResultsFolder folder(invocation.options.results);
  if (const RunState* from = checkpoints.from())
    out.line("{} goes on from step {}, t = {:.6g} s", entry.name, from->step, from->time);
  Making making;
  const RunResult run = made_run(choice, checkpoints, making, invocation.options.threads);
  const auto declared = declared_run(entry, choice.scheme, choice.settings);
  const std::vector<JudgedGate> gates = judge_run(entry, run, declared);
  const Provenance provenance = provenance_of(entry, invocation.provenance());
  folder.write_run(run, gates, provenance, making);
  print(out, run, gates, declared.has_value());
  Json document = run_document(run, gates, provenance);
  document["expectation"] = declared ? "declared" : "none";
  if (Json films = write_films(out, folder, run); !films.is_null()) document["frames"] = std::move(films);
  write_json(invocation.options, document);
  return exit_of(run.stop.has_value(), gates, invocation.options.allow_inconclusive);
}

}  // namespace

Command add_run(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command("run", "one run: measures, ledger, speed, and one result file",
                                        "Example: plumbline run sod --cells 200 --scheme york1997 --set gamma=1.67");
  auto options = std::make_shared<RunOptions>();
  sub.option("case", options->case_name, "the case; not with --resume");
  sub.option("--cells", options->cells, "cells along the case's reference length").whole_number();
  sub.option("--frames", options->frames,
             "keep so many snapshots of all points, evenly spaced in time: in the result file, and as files that "
             "ParaView opens, in the folder named after it")
      .whole_number();
  sub.flag("--dry-run", options->dry, "print points, cells, steps, memory and estimated time only");
  add_checkpoint_options(sub, options->checkpoints);
  add_run_options(sub, invocation.options);
  add_no_fusion(sub, invocation.options);
  return {sub, [&invocation, options] { return execute(invocation, *options); }};
}

}  // namespace plumbline
