#include "cases/harness/commands/command.hpp"
#include "cases/harness/exchange/final_state.hpp"

namespace plumbline {
namespace {

void print(const Output& out, const Case& entry) {
  const Statement s = entry.statement();
  out.line("{}: {}\n{}\n\nClaim: {}\n\n{}\n", s.name, s.title, s.source, s.claim, s.physics);
  for (const std::string& equation : s.equations) out.line("    {}", equation);
  out.line("\nReference `{}`: {}\n  Bound: {}\n\nKeys{}", s.reference_name, s.reference_text, s.reference_bound,
           s.cells_along.empty() ? "" : " (cells count along " + s.cells_along + ")");
  const Settings settings = entry.settings("default", {});
  for (const Key& key : settings.keys()) {
    out.line("  {:22} {:12} {:34} {}", key.name, to_text(key.value), key.allowed(), key.description);
  }
  for (const StudyPlan& plan : entry.studies) {
    out.line("\nStudy {}: {} (varies {}, scheme {})\n  {}", plan.id, plan.title, name(plan.vary), plan.scheme,
             plan.why);
    for (const CaseGate& g : entry.gates) {
      if (g.study != plan.id) continue;
      const auto end = [](const std::optional<double>& x) { return x ? fmt::format("{:.6g}", *x) : std::string(); };
      out.line("  gate {}: {} in [{}, {}] ({}): {}", g.gate.id, g.gate.quantity, end(g.gate.expected.low),
               end(g.gate.expected.high), name(g.gate.origin), g.gate.reason);
      if (g.gate.expected_failure) out.line("    expected to fail: {}", g.gate.expected_failure->cause);
    }
  }
  out.line("\nEvery study also passes the generic gates: {}.\nKnown limits",
           entry.trials.empty() ? "finite, mass, momentum, energy ledger" : "finite");
  for (const std::string& limit : s.known_limits) out.line("  {}", limit);
  const std::string why_not = why_not_scored(entry, settings);
  out.line("\nFinal states of other programs (`plumbline score`): {}",
           why_not.empty() ? "can be judged" : "cannot be judged, " + why_not);
}

}  // namespace

Command add_explain(const Arguments& program, Invocation& invocation) {
  const Arguments sub = program.command("explain", "a case: statement, parameters, reference, gates with reasons",
                                        "Example: plumbline explain sod");
  auto name = std::make_shared<std::string>();
  sub.option("case", *name, "the case").required();
  add_json(sub, invocation.options);
  return {sub, [&invocation, name] {
            const Case& entry = find_case(*name);
            print(Output(invocation.options), entry);
            write_json(invocation.options, catalog_entry(entry));
            return 0;
          }};
}

}  // namespace plumbline
