#include "cases/harness/compare/parts.hpp"

namespace plumbline {
namespace {

// Green first; a gate that is no longer judged is worse than a green one.
int severity(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return 0;
    case Verdict::xfail:
      return 1;
    case Verdict::none:
      return 2;
    case Verdict::inconclusive:
      return 3;
    case Verdict::xpass:
      return 4;
    case Verdict::fail:
      return 5;
    default:
      return 6;
  }
}

Finding finding_of(const GateRecord& gate, const std::string& kind) {
  Finding f;
  f.kind = kind;
  f.case_name = gate.case_name;
  f.scheme = gate.scheme;
  f.study = gate.study;
  f.quantity = gate_words(gate);
  return f;
}

Finding lone(const GateRecord& gate, Change change) {
  Finding f = finding_of(gate, "verdict");
  f.change = change;
  (change == Change::missing ? f.before : f.after) = name(gate.verdict);
  return f;
}

Finding verdict_finding(const GateRecord& before, const GateRecord& after) {
  Finding f = finding_of(before, "verdict");
  f.before = name(before.verdict);
  f.after = name(after.verdict);
  const int change = severity(after.verdict) - severity(before.verdict);
  f.change = change > 0 ? Change::worse : change < 0 ? Change::better : Change::same;
  if (after.verdict == Verdict::xpass && change > 0) f.note = "a known failure is gone: the gate has to say so";
  return f;
}

void compare_bounds(const GateRecord& before, const GateRecord& after, std::vector<Finding>& findings) {
  std::string why;
  const Shift found = shift(before.bounds, after.bounds, &why);
  if (found == Shift::same) return;
  Finding f = finding_of(before, "bound");
  f.before = range_json(before.bounds.expected);
  f.after = range_json(after.bounds.expected);
  f.change = found == Shift::widened ? Change::widened : Change::better;
  f.note = (found == Shift::widened ? "lets pass more (" + why + "): " : "narrowed: ") + bounds_words(before.bounds) +
           " became " + bounds_words(after.bounds);
  findings.push_back(std::move(f));
}

}  // namespace

std::string gate_words(const GateRecord& gate) { return gate.id + (gate.tier.empty() ? "" : " (" + gate.tier + ")"); }

void compare_gates(const Snapshot& before, const Snapshot& after, std::vector<Finding>& findings) {
  for (const auto& [key, gate] : before.gates) {
    const auto found = after.gates.find(key);
    if (found == after.gates.end()) {
      findings.push_back(lone(gate, Change::missing));
      continue;
    }
    findings.push_back(verdict_finding(gate, found->second));
    compare_bounds(gate, found->second, findings);
  }
  for (const auto& [key, gate] : after.gates) {
    if (before.gates.count(key) == 0) findings.push_back(lone(gate, Change::added));
  }
}

}  // namespace plumbline
