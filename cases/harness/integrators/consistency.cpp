// Whether the scheme approaches the right solution.
#include <vector>

#include "cases/harness/integrators/integrator_gates.hpp"
#include "cases/harness/integrators/measured_limit.hpp"
#include "cases/harness/integrators/oscillators.hpp"
#include "cases/harness/integrators/pairs.hpp"

namespace plumbline {
namespace {

constexpr const char* causes_of_inconsistency =
    "a force, strain or motion of the step is not dt times its rate: a factor, a missing or doubled stage, or a value "
    "of "
    "another instant";

const std::string smallest_seen = "1e-5: a hundredth of one per mille in a force, strain or motion";
const std::string filter = "(pi/32)^4: what a filter takes in one step from half a wave of 32 cells";

Gate limit_gate(const std::string& name, const std::string& quantity, double bound, const std::string& why) {
  Gate gate = gate_row("consistency", name, quantity, {{}, bound}, Origin::theory, why);
  gate.order = true;  // the extrapolation's interval is judged
  return gate;
}

}  // namespace

std::vector<IntegratorGate> consistency_gates() {
  std::vector<IntegratorGate> all;
  for (const OscillatorScene& scene : oscillator_scenes()) {
    all.push_back(
        {"consistency",
         limit_gate(scene.name, "error for dt -> 0 on " + scene.what, most_left_over,
                    "a consistent scheme converges to the exact motion; " + smallest_seen),
         causes_of_inconsistency,
         [&scene](const Subject& subject) {
           return measured_limit({16, 7, 11}, [&](int steps) { return oscillator_errors(subject, scene, steps); });
         },
         Effort::core});
  }
  for (const SmallScene& scene : small_scenes()) {
    all.push_back({"consistency",
                   limit_gate("difference-" + scene.name,
                              "difference from a consistent integrator for dt -> 0: " + scene.what, scene.left_over,
                              "with the same maps and steps all consistent schemes have one limit; " +
                                  (scene.left_over > most_left_over ? filter : smallest_seen)),
                   causes_of_inconsistency,
                   [&scene](const Subject& subject) {
                     return measured_limit({8, 5, 8, scene.left_over},
                                           [&](int steps) { return difference_at(subject, scene, steps); });
                   },
                   scene.name == "bar" || scene.name == "bar-filtered" ? Effort::core : Effort::whole});
  }
  return all;
}

}  // namespace plumbline
