#include "cases/harness/exchange/score.hpp"
#include "cases/harness/commands/command.hpp"

namespace plumbline {
namespace {

struct ScoreOptions {
  std::string case_name;
  std::vector<std::string> results;
};

Json document_of(const Case& entry, const Score& score, const Provenance& provenance) {
  const Json study = study_document(score.study, score.gates, provenance);
  Json not_judged = Json::array();
  for (const NotJudged& gate : score.not_judged) not_judged.push_back({{"id", gate.id}, {"reason", gate.reason}});
  const auto all = verdicts(score.gates);
  Json document{{"case", entry.name},
                {"scheme", score.study.scheme},
                {"program", score.program},
                {"version", score.version},
                {"expectation", score.declared ? "declared" : "none"},
                {"verdict", name(overall(all))},
                {"results", score.files},
                {"levels", study.at("levels")},
                {"measures", study.at("measures")},
                {"gates", study.at("gates")},
                {"not_judged", not_judged}};
  document["study"] = score.declared ? Json(*score.declared) : Json(nullptr);
  document["provenance"] = to_json(provenance);
  return document;
}

void print(const Output& out, const Score& score) {
  for (std::size_t k = 0; k < score.study.levels.size(); ++k) {
    const RunResult& run = score.study.levels[k].run;
    out.line("{}: {} cells, {} points of {} {}", score.files[k], score.study.levels[k].value, run.points, score.program,
             score.version);
    for (const Measure& m : run.measures) {
      if (m.value) {
        out.line("  {:18} {:.8g} {} (reference {:.8g}, error {:.3g})", m.name, *m.value, m.unit,
                 m.reference.value_or(0), m.error);
      } else {
        out.line("  {:18} error {:.4g} {}, relative {:.3g}, reference bound {:.1e}", m.name, m.error, m.unit,
                 m.error / m.scale, m.reference_bound);
      }
    }
  }
  for (const auto& [measure, fit] : score.study.fits) {
    if (score.study.levels.size() < 2 || measure.ends_with(".L2") || measure.ends_with(".Linf")) continue;
    out.line("order of {:18} {:.3f}, 95 % interval {:.3f} ... {:.3f}{}{}", measure, fit.order, fit.low, fit.high,
             fit.asymptotic ? ", asymptotic" : "", fit.reason.empty() ? "" : ": " + fit.reason);
  }
  out.gates(score.gates);
  for (const NotJudged& gate : score.not_judged) out.line("not judged   {}: {}", gate.id, gate.reason);
  out.line("expectation: {}", score.declared ? "declared, study " + *score.declared : "none");
}

int execute(const Invocation& invocation, const ScoreOptions& options) {
  const Case& entry = find_case(options.case_name);
  const ResultsFolder folder(invocation.options.results);
  Score scored = score(entry, options.results, invocation.options.settings);
  const Provenance provenance = invocation.provenance();
  for (const StudyLevel& at : scored.study.levels) folder.write_run(at.run, gates_of_level(scored, at), provenance);
  if (scored.study.levels.size() > 1) folder.write_study(scored.study, scored.gates, provenance);
  print(Output(invocation.options), scored);
  write_json(invocation.options, document_of(entry, scored, provenance));
  return exit_of(false, scored.gates, invocation.options.allow_inconclusive);
}

}  // namespace

Command add_score(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command(
      "score", "judges final states of another program by a case's norms and gates",
      "Example: plumbline score sod --result my-100.h5 --result my-200.h5\nWhat such a file holds: "
      "reports/docs/how-to/score-another-code.md");
  auto options = std::make_shared<ScoreOptions>();
  sub.option("case", options->case_name, "the case").required();
  sub.option("--result", options->results, "a final state (repeatable: a refinement series of one program)")
      .required()
      .repeatable();
  add_json(sub, invocation.options);
  sub.option("--set", invocation.options.settings, "key=value as given to export (repeatable)").repeatable();
  sub.option("--results", invocation.options.results, "results folder").not_empty();
  add_limits(sub);
  sub.flag("--allow-inconclusive", invocation.options.allow_inconclusive,
           "INCONCLUSIVE does not make the exit status red");
  return {sub, [&invocation, options] { return execute(invocation, *options); }};
}

}  // namespace plumbline
