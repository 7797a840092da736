// Whether there is a stable step, and where the limit lies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/judging/growth.hpp"
#include "cases/judging/integrator_gates.hpp"
#include "cases/laboratory/known_limits.hpp"

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

// The first row of a problem in the list of known limits.
const KnownLimit& limit_on(const StabilityProblem& problem, const Subject& subject) {
  return subject.once<KnownLimit>("limit/" + problem.name(), [&] {
    KnownLimit row = rows_of(subject.choice(), {&problem}).front();
    find_limit(row);
    return row;
  });
}

constexpr int margin = 2;  // periods: enough to have every body

[[noreturn]] void say_what_is_missing(const StabilityProblem& problem, const Subject& subject) {
  const Settings settings = stability_settings(problem, "default", {{"integrator", subject.name()}});
  throw CannotWork(lacks(subject.entry(), problem.patch(settings, {1, margin}).scene));
}

// Throws CannotWork where the integrator cannot step the problem.
bool too_many_to_follow(const StabilityProblem& problem, const Subject& subject) {
  const KnownLimit row = rows_of(subject.choice(), {&problem}).front();
  if (!row.settings) say_what_is_missing(problem, subject);
  return problem.patch(*row.settings, {1, margin}).directions > 1 && reaches_far(subject.choice());
}

// How far the limit that runs show is from the one that the step's matrix predicts, relative; 1: runs show none near it.
Measured off_prediction(const StabilityProblem& problem, const Subject& subject) {
  constexpr double around = 0.1, width = 2e-3, to_be_told = 0.01;
  Measured measured = plain(0);
  if (too_many_to_follow(problem, subject)) {
    measured.inconclusive = true;
    measured.note = "a point depends on all others, which are too many to follow in two directions";
    return measured;
  }
  const KnownLimit& row = limit_on(problem, subject);
  measured.inconclusive = std::isnan(row.limit) || row.no_stable_step();
  if (measured.inconclusive) {
    measured.note = row.no_stable_step() ? fmt::format("no stable step: it grows by {:.6g} in a step of {:.4g} {}",
                                                       row.growth.per_step, row.growth.dt, row.unit)
                                         : row.note;
    return measured;
  }
  const Experiment experiment = experiment_of(problem, *row.settings);
  Watch watch = problem.watch(*row.settings);
  watch.width = width;
  const bool endless = !row.has_limit();
  if (!endless) {
    constexpr int longest = 4;  // of a run in watch.steps
    const double beyond = worst_growth(experiment, (1 + to_be_told) * row.limit).per_step;
    measured.inconclusive = beyond < 1 + watch.slowest ||
                            longest * watch.steps * std::log(beyond) < std::log(watch.grown_slowly);
    measured.note = fmt::format("1 % above {:.4g} {} it grows by {:.6g} a step: runs do not show that", row.limit,
                                row.unit, beyond);
    if (measured.inconclusive) return measured;
  }
  const double low = endless ? row.scanned / 2 : (1 - around) * row.limit,
               high = endless ? row.scanned : (1 + around) * row.limit;
  const Observation seen = observe(experiment, {low, high, 2}, watch, reach_of_step(experiment, low));
  if (endless) return plain(seen.always_stable ? 0 : 1, "no limit was predicted");
  if (seen.brackets.size() != 1) return plain(1, fmt::format("runs show no limit between {:.4g} and {:.4g}", low, high));
  const Bracket& bracket = seen.brackets.front();
  return plain(std::abs(0.5 * (bracket.low + bracket.high) / row.limit - 1),
               fmt::format("{:.4g} {} predicted, {:.4g} observed, {}", row.limit, row.unit,
                           0.5 * (bracket.low + bracket.high), row.words()));
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
  for (const StabilityProblem* problem : stability_problems()) {
    if (!problem->has_grid() || problem->listed().empty()) continue;
    all.push_back({"stability",
                   gate_row("stability", problem->name() + "/observed",
                            "largest stable step of runs against that of the step's matrix, relative", {{}, 0.01},
                            Origin::theory, "a step's matrix says what perturbations do; 1 % for runs of finite length"),
                   "the step keeps something that is no part of its state, or depends on what was done before",
                   [problem](const Subject& s) { return off_prediction(*problem, s); }});
  }
  return all;
}

}  // namespace plumbline
