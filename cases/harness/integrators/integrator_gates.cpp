#include "cases/harness/integrators/integrator_gates.hpp"

#include <algorithm>
#include <utility>

namespace plumbline {

const std::vector<std::string>& gate_families() {
  static const std::vector<std::string> all{"consistency", "order", "stability", "energy",
                                            "invariance",  "jumps", "identities"};
  return all;
}

std::vector<IntegratorGate> integrator_gates(const Subject& subject, Effort effort) {
  std::vector<IntegratorGate> all;
  const auto add = [&](std::vector<IntegratorGate> rows) {
    std::move(rows.begin(), rows.end(), std::back_inserter(all));
  };
  add(consistency_gates());
  add(order_gates(subject));
  add(stability_gates(subject));
  add(energy_gates(subject));
  add(invariance_gates(subject));
  if (effort == Effort::whole) {
    add(jump_gates());
    add(identity_gates(subject));
  }
  all.erase(std::remove_if(all.begin(), all.end(), [&](const IntegratorGate& row) { return row.effort > effort; }),
            all.end());
  for (IntegratorGate& row : all) {
    for (const KnownFailure& known : subject.claims().known_failures) {
      if (known.gate != row.gate.id) continue;
      row.gate.expected_failure = ExpectedFailure{known.cause, {known.low, known.high}, {}, {}};
    }
  }
  return all;
}

}  // namespace plumbline
