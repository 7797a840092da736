#include "cases/harness/integrators/judge.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace plumbline {
namespace {

constexpr const char* integrator_case = "integrator";  // where results name a case

// What a gate that is not applicable is about: the case of an identity, else the gate.
std::string thing_of(const std::string& id) {
  const std::string family = "identities/";
  const std::size_t end = id.find('/', family.size());
  return id.rfind(family, 0) == 0 ? id.substr(family.size(), end - family.size()) : id;
}

}  // namespace

bool is_red(const JudgedGate& gate, bool allow_inconclusive) {
  const std::vector<Verdict> one{gate.judgement.verdict};
  return exit_status(one, allow_inconclusive || gate.case_name == integrator_case) != 0;
}

JudgedIntegrator judge_integrator(const Subject& subject, const JudgingOptions& options,
                                  const JudgingProgress& progress) {
  const std::vector<IntegratorGate> gates = integrator_gates(subject, options.effort);
  std::vector<MeasuredGate> rows;
  for (const IntegratorGate& row : gates)
    rows.push_back({row.family, row.gate, row.explanation, [&] { return row.measure(subject); }});
  std::vector<std::size_t> order(rows.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return gates[a].effort < gates[b].effort; });
  std::vector<GateOutcome> outcomes = judge_side_by_side(
      integrator_case, subject.name(), rows,
      {options.threads, options.until_red, [](const JudgedGate& gate) { return is_red(gate); }, order, progress});
  JudgedIntegrator found;
  found.integrator = subject.name();
  found.declared = static_cast<int>(rows.size());
  for (GateOutcome& outcome : outcomes) {
    if (outcome.judged) found.gates.push_back(std::move(*outcome.judged));
    if (!outcome.not_applicable) continue;
    auto& all = found.not_applicable;
    const std::string what = thing_of(outcome.not_applicable->what);
    if (!all.empty() && all.back().what == what) {
      --found.declared;  // gates of a case that cannot be judged count as one
      continue;
    }
    all.push_back(std::move(*outcome.not_applicable));
    all.back().what = what;
  }
  return found;
}

}  // namespace plumbline
