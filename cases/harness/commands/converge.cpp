#include <algorithm>

#include "cases/harness/commands/command.hpp"
#include "cases/harness/judge/undeclared.hpp"

namespace plumbline {
namespace {

struct ConvergeOptions {
  std::string case_name, vary = "cells";
  std::vector<int> cells;
  std::vector<double> values;
};

std::vector<double> levels(const Case& entry, Vary vary, const ConvergeOptions& options) {
  if (!options.values.empty()) return options.values;
  switch (vary) {
    case Vary::cells:
      return options.cells.empty() ? entry.levels : std::vector<double>(options.cells.begin(), options.cells.end());
    case Vary::dt:
      return {1, 0.5, 0.25, 0.125, 0.0625};
    case Vary::ppc:
      return {8, 16, 32, 64, 128};
    default:
      return {0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875};
  }
}

// The plan of these choices: the declared one with the same settings, or one without expectations.
struct ChosenPlan {
  StudyPlan plan;
  bool declared = false;
};

ChosenPlan plan_for(const Case& entry, const SchemeChoice& choice, Vary vary, const ConvergeOptions& options,
                    const std::vector<std::string>& typed) {
  StudyPlan plan{.id = "study",
                 .title = "refinement in " + name(vary),
                 .why = "No order is claimed for these choices.",
                 .scheme = choice.scheme,
                 .overrides = choice.overrides,
                 .vary = vary,
                 .values = levels(entry, vary, options)};
  std::vector<double> sorted = plan.values;
  std::sort(sorted.begin(), sorted.end());
  const char* const option = options.values.empty() ? "--cells" : "--values";
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end()) {
    throw UsageError(option, fmt::format("{}", *twice), "each once", {},
                     fmt::format("{} names {} twice: each is wanted once", option, *twice));
  }
  if (vary == Vary::cells && !options.values.empty()) {
    throw UsageError("--values", fmt::format("{}", options.values.front()), "with --vary dt, ppc or offset",
                     {"--cells"}, "--values is of --vary dt, ppc or offset: --cells names meshes");
  }
  if (vary == Vary::dt && sorted.front() <= 0) {
    throw UsageError("--values", fmt::format("{}", sorted.front()), "(0, inf)", {},
                     fmt::format("--values names {}: a factor of the step must be positive", sorted.front()));
  }
  if (vary != Vary::cells && options.cells.size() > 1) {
    throw UsageError("--cells", fmt::format("{} meshes", options.cells.size()), "one mesh", {},
                     "--vary " + name(vary) + " refines on one mesh: give --cells one number");
  }
  if (vary != Vary::cells && !options.cells.empty())
    plan.overrides.emplace_back("cells", static_cast<double>(options.cells.front()));
  const Settings wanted = planned_runs(entry, plan, Tier::quick, typed).front().settings;
  for (StudyPlan declared : entry.studies) {
    if (declared.vary != vary || declared.scheme != choice.scheme) continue;
    declared.values = plan.values;
    if (!(planned_runs(entry, declared, Tier::quick).front().settings == wanted)) continue;
    return {std::move(declared), true};
  }
  return {std::move(plan), false};
}

// The measures a person reads first: no L2, no Linf.
std::vector<std::string> leading_measures(const StudyResult& study) {
  std::vector<std::string> names;
  for (const Measure& m : study.levels.front().run.measures) {
    if (!m.name.ends_with(".L2") && !m.name.ends_with(".Linf")) names.push_back(m.name);
  }
  return names;
}

void print_levels(const Output& out, const StudyResult& study, const std::vector<std::string>& measures) {
  std::string header = fmt::format("{:>8} {:>10} {:>8} {:>9}", name(study.plan.vary), "h", "steps", "time/s");
  for (const std::string& measure : measures) header += fmt::format(" {:>15}", measure);
  out.line("{}", header);
  for (const StudyLevel& at : study.levels) {
    std::string row = fmt::format("{:>8.5g} {:>10.5g} {:>8} {:>9.3g}", at.value, at.h, at.run.steps, at.run.wall_s);
    for (const std::string& measure : measures) {
      const Measure* m = at.run.find(measure);
      row += fmt::format(" {:>15}", m ? fmt::format("{:.4g}", m->error) : "-");
    }
    out.line("{}{}", row, at.run.stop ? "  STOPPED: " + at.run.stop->reason : "");
  }
}

void print(const Output& out, const StudyResult& study, const std::vector<JudgedGate>& gates, bool declared) {
  out.line("{} under {}: {}. {}\nErrors against the reference:", study.entry->name, study.scheme, study.plan.title,
           study.plan.why);
  const std::vector<std::string> measures = leading_measures(study);
  print_levels(out, study, measures);
  out.line("{:>24} {:>8} {:>20} {:>10}", "order of", "fit", "95 % interval", "constant");
  for (const std::string& measure : measures) {
    const OrderFit* fit = study.fit(measure);
    if (!fit) continue;
    out.line("{:>24} {:>8.3f} {:>20} {:>10.3g}  {}{}", measure, fit->order,
             fmt::format("{:.3f} ... {:.3f}", fit->low, fit->high), fit->constant,
             fit->asymptotic ? "asymptotic" : "not asymptotic", fit->reason.empty() ? "" : ": " + fit->reason);
  }
  double drift = 0;
  for (const StudyLevel& at : study.levels) drift = larger(drift, at.run.ledger.energy.relative_drift(false));
  out.line("Largest relative drift of energy {:.1e}; expectation: {}", drift, declared ? "declared" : "none");
  out.gates(gates);
}

int execute(const Invocation& invocation, const ConvergeOptions& options) {
  const Case& entry = find_case(options.case_name);
  const Vary vary = vary_from(options.vary);
  if (!entry.trials.empty()) {
    throw UsageError("case", entry.name, "a case of runs", {},
                     "converge: " + entry.name + " has trials, in which nothing is refined");
  }
  const CommonOptions& common = invocation.options;
  std::vector<ChosenPlan> plans;
  for (const SchemeChoice& choice : chosen_schemes(common))
    plans.push_back(plan_for(entry, choice, vary, options, common.settings));
  const ResultsFolder folder(common.results);
  const Output out(common);
  const Provenance provenance = provenance_of(entry, invocation.provenance());
  RunStore store(folder, provenance, common.reuse);
  Json document{{"case", entry.name}, {"studies", Json::array()}};
  std::vector<JudgedGate> all;
  bool stopped = false;
  for (const auto& [plan, declared] : plans) {
    const auto planned = planned_runs(entry, plan, Tier::quick,
                                      declared ? std::vector<std::string>{} : common.settings);
    StudyResult study = run_study(entry, plan, planned, common.threads, terminal_progress(entry.name + " " + plan.id),
                                  &store);
    end_progress();
    for (const StudyLevel& at : study.levels) stopped = stopped || at.run.stop;
    std::vector<CaseGate> gates;
    for (CaseGate gate : entry.gates) {
      if (declared && gate.study == plan.id) gates.push_back(std::move(gate));
    }
    for (CaseGate& gate : generic_gates(plan.id, study.levels.front().run.dim, study.levels.front().run.axisymmetric))
      gates.push_back(std::move(gate));
    if (!declared) {
      for (CaseGate& gate : undeclared_gates(study)) gates.push_back(std::move(gate));
    }
    const auto judged = judge_gates(gates, study);
    folder.write_study(study, judged, provenance);
    print(out, study, judged, declared);
    document["studies"].push_back(study_document(study, judged, provenance));
    document["studies"].back()["expectation"] = declared ? "declared" : "none";
    all.insert(all.end(), judged.begin(), judged.end());
  }
  print_reused(out, store);
  write_json(common, document);
  return exit_of(stopped, all, common.allow_inconclusive);
}

}  // namespace

Command add_converge(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command(
      "converge", "a refinement study: errors, fitted order with interval, cost",
      "Example: plumbline converge sod --cells 100,200,400,800,1600 --scheme default --scheme york1997");
  auto options = std::make_shared<ConvergeOptions>();
  sub.option("case", options->case_name, "the case").required();
  sub.option("--cells", options->cells, "meshes, separated by commas").separated_by_commas().whole_number();
  sub.option("--vary", options->vary, "what is refined: cells, dt, ppc or offset");
  sub.option("--values", options->values,
             "of what is refined, separated by commas: factors of the step, points per cell, or offsets in cells")
      .separated_by_commas();
  add_run_options(sub, invocation.options);
  add_reuse(sub, invocation.options);
  return {sub, [&invocation, options] { return execute(invocation, *options); }};
}

}  // namespace plumbline
