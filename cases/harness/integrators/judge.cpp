#include "cases/harness/integrators/judge.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/pool.hpp"
#include "cases/harness/files/signals.hpp"
#include "cases/harness/run/experiment.hpp"
#include "kernel/inadmissible.hpp"

namespace plumbline {
namespace {

constexpr const char* integrator_case = "integrator";  // where results name a case

// What a gate that is not applicable is about: the case of an identity, else the gate.
std::string thing_of(const std::string& id) {
  const std::string family = "identities/";
  const std::size_t end = id.find('/', family.size());
  return id.rfind(family, 0) == 0 ? id.substr(family.size(), end - family.size()) : id;
}

struct Outcome {
  std::optional<JudgedGate> judged;
  std::optional<NotApplicable> not_applicable;
};

Measured failed(const std::string& note) {
  Measured measured;
  measured.invalid = true;
  measured.note = note;
  return measured;
}

Outcome outcome_of(const Subject& subject, const IntegratorGate& row) {
  JudgedGate judged;
  judged.gate = row.gate;
  judged.case_name = integrator_case;
  judged.scheme = subject.name();
  judged.study = row.family;
  try {
    judged.measured = row.measure(subject);
  } catch (const CannotWork& parts) {
    return {{}, NotApplicable{row.gate.id, subject.name(), parts.lacks}};
  } catch (const MissingTraits& parts) {
    return {{}, NotApplicable{row.gate.id, subject.name(), parts.lacks}};
  } catch (const Interrupted&) {
    throw;
  } catch (const InadmissibleState& state) {
    judged.measured.stopped = Measured::Stop{state.step, state.field};
    judged.measured.note = state.what();
  } catch (const std::exception& error) {
    judged.measured = failed(error.what());
  }
  judged.judgement = judge(row.gate, judged.measured);
  if (is_red(judged)) judged.explanation = row.explanation;
  return {std::move(judged), {}};
}

}  // namespace

bool is_red(const JudgedGate& gate, bool allow_inconclusive) {
  const std::vector<Verdict> one{gate.judgement.verdict};
  return exit_status(one, allow_inconclusive || gate.case_name == integrator_case) != 0;
}

JudgedIntegrator judge_integrator(const Subject& subject, const JudgingOptions& options,
                                  const JudgingProgress& progress) {
  const std::vector<IntegratorGate> rows = integrator_gates(subject, options.effort);
  std::vector<std::size_t> order(rows.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return rows[a].effort < rows[b].effort; });
  std::vector<Outcome> outcomes(rows.size());
  std::atomic<bool> red = false;
  std::size_t done = 0;
  std::mutex guard;
  for_all(rows.size(), options.threads, [&](std::size_t k) {
    if (options.until_red && red) return;
    throw_if_interrupted();
    const std::size_t at = order[k];
    Outcome outcome = outcome_of(subject, rows[at]);
    if (outcome.judged && is_red(*outcome.judged)) red = true;
    const std::lock_guard lock(guard);
    outcomes[at] = std::move(outcome);
    if (progress) progress(++done, rows.size(), rows[at].gate.id);
  });
  JudgedIntegrator found;
  found.integrator = subject.name();
  found.declared = static_cast<int>(rows.size());
  for (Outcome& outcome : outcomes) {
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
