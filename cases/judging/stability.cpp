// Whether there is a stable step, and where the limit lies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/judging/growth.hpp"
#include "cases/judging/integrator_gates.hpp"

namespace plumbline {
namespace {

constexpr const char* usual_causes =
    "energy comes in at every step, however small: forces of the step's start with motion of its end or the like. "
    "Consistent methods whose growth falls with a power of dt (Heun's, Adams-Bashforth's of order 2) are weakly "
    "unstable";

// The growth of the smallest step: if that is stable, some step and all smaller ones are.
Measured growth_of_smallest(const SmallSteps& steps) {
  Measured measured = plain(steps.growth.back());
  if (steps.power > 0) measured.note = fmt::format("grows with the power {:.2f} of dt", steps.power);
  return measured;
}

IntegratorGate growth_row(const std::string& problem, double most, const std::string& why,
                          std::function<SmallSteps(const Subject&)> find) {
  return {
      "stability",
      gate_row("stability", problem + "/growth", "logarithm of the spectral radius of a step of 1/32 of York's limit",
               {{}, most}, Origin::theory, why),
      usual_causes, [find](const Subject& s) { return growth_of_smallest(find(s)); }, Effort::core};
}

}  // namespace

std::vector<IntegratorGate> stability_gates(const Subject& subject) {
  std::vector<IntegratorGate> all{
      growth_row("oscillator", 1e-12, "a stable step lets nothing grow; 1e-12 for rounding", small_steps_on_oscillator),
      growth_row("bar", 1e-7,
                 "a stable step lets nothing grow; 1e-7, for double eigenvalues are known to half the digits",
                 small_steps_on_bar)};
  if (const auto claimed = subject.claims().limit) {
    const bool none = std::isinf(*claimed);
    const Range expected = none ? Range{8.0, {}} : Range{(1 - 5e-4) * *claimed, (1 + 5e-4) * *claimed};
    all.push_back({"stability",
                   gate_row("stability", "claimed/oscillator", "largest stable step on the oscillator, 1/omega",
                            expected, Origin::theory,
                            none ? "claimed by the integrator: no limit, to the scan's end at 8"
                                 : "claimed by the integrator, to three digits"),
                   "another scheme than the claim speaks of, or a factor in a force or a strain",
                   [](const Subject& s) { return plain(std::min(limit_on_oscillator(s), 1e6)); }, Effort::core});
  }
  return all;
}

}  // namespace plumbline
