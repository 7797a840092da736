#include "cases/harness/judge/measured_gates.hpp"

#include <atomic>
#include <mutex>
#include <numeric>
#include <utility>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/pool.hpp"
#include "cases/harness/files/signals.hpp"
#include "kernel/inadmissible.hpp"

namespace plumbline {
namespace {

GateOutcome outcome_of(const std::string& kind, const std::string& name, const MeasuredGate& row,
                       const SideBySide& how) {
  JudgedGate judged;
  judged.gate = row.gate;
  judged.case_name = kind;
  judged.scheme = name;
  judged.study = row.family;
  try {
    judged.measured = row.measure();
  } catch (const CannotWork& parts) {
    return {{}, NotApplicable{row.gate.id, name, parts.lacks}};
  } catch (const MissingTraits& parts) {
    return {{}, NotApplicable{row.gate.id, name, parts.lacks}};
  } catch (const Interrupted&) {
    throw;
  } catch (const InadmissibleState& state) {
    judged.measured.stopped = Measured::Stop{state.step, state.field};
    judged.measured.note = state.what();
  } catch (const std::exception& error) {
    judged.measured = Measured::failed(error.what());
  }
  judged.judgement = judge(row.gate, judged.measured);
  if (how.is_red(judged)) judged.explanation = row.explanation;
  return {std::move(judged), {}};
}

}  // namespace

Gate gate_row(const std::string& family, const std::string& name, const std::string& quantity, Range expected,
              Origin origin, const std::string& reason) {
  return gate(family + "/" + name, {quantity, {}}, expected, {origin, reason}).gate;
}

Measured plain(double value, std::string note) {
  Measured measured;
  measured.value = value;
  measured.scale = 1;
  measured.note = std::move(note);
  return measured;
}

std::vector<GateOutcome> judge_side_by_side(const std::string& kind, const std::string& name,
                                            const std::vector<MeasuredGate>& rows, const SideBySide& how) {
  std::vector<std::size_t> order = how.order;
  if (order.empty()) {
    order.resize(rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
  }
  std::vector<GateOutcome> outcomes(rows.size());
  std::atomic<bool> red = false;
  std::size_t done = 0;
  std::mutex guard;
  for_all(rows.size(), how.threads, [&](std::size_t k) {
    if (how.until_red && red) return;
    throw_if_interrupted();
    const std::size_t at = order[k];
    GateOutcome outcome = outcome_of(kind, name, rows[at], how);
    if (outcome.judged && how.is_red(*outcome.judged)) red = true;
    const std::lock_guard lock(guard);
    outcomes[at] = std::move(outcome);
    if (how.progress) how.progress(++done, rows.size(), rows[at].gate.id);
  });
  return outcomes;
}

}  // namespace plumbline
