// Whether there is a stable step, and where the limit lies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "cases/harness/integrators/growth.hpp"
#include "cases/harness/integrators/integrator_gates.hpp"
#include "cases/harness/laboratory/known_limits.hpp"

namespace plumbline {
namespace {

constexpr const char* causes_of_growth =
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
      causes_of_growth, [find](const Subject& s) { return growth_of_smallest(find(s)); }, Effort::core};
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

// The largest growth among the waves that a run's core holds.
double growth_in_core(const Experiment& experiment, const Patch& patch, const Watch& watch, double dt) {
  if (patch.directions != 1) return worst_growth(experiment, dt).per_step;
  std::vector<double> waves;
  for (int k = 0; 2 * k <= watch.core; ++k) waves.push_back(2 * std::numbers::pi * k / watch.core);
  const std::vector<double> radii = radii_over_waves(experiment, dt, waves);
  return *std::max_element(radii.begin(), radii.end());
}

// Whether a run is long enough to show a growth. A random perturbation holds little of the wave that grows.
bool shows(double growth, const Watch& watch) {
  constexpr int longest = 4;  // runs, in watch.steps, while something grows
  constexpr double share = 0.01;
  return growth > 1 + 2 * watch.slowest &&
         longest * watch.steps * std::log(growth) > std::log(watch.grown_slowly / share);
}

// Within which distance, relative, of the limit that the step's matrix predicts, runs lose stability; 1: they do not.
Measured distance_of_limits(const StabilityProblem& problem, const Subject& subject) {
  const auto not_told = [](const std::string& note) {
    Measured measured = plain(0, note);
    measured.inconclusive = true;
    return measured;
  };
  const KnownLimit sought = rows_of(subject.choice(), {&problem}).front();
  if (!sought.settings) say_what_is_missing(problem, subject);
  const Patch patch = problem.patch(*sought.settings, {1, margin});
  if (patch.directions > 1 && (subject.has_inner_solver() || reaches_far(subject.choice()))) {
    return not_told("a step of an inner solver makes a point depend on too many others in two directions");
  }
  const KnownLimit& row = limit_on(problem, subject);
  if (std::isnan(row.limit)) return not_told(row.note);
  if (row.no_stable_step()) {
    return not_told(fmt::format("no stable step: it grows by {:.6g} in a step of {:.4g} {}", row.growth.per_step,
                                row.growth.dt, row.unit));
  }
  const Experiment experiment = experiment_of(problem, *row.settings);
  Watch watch = problem.watch(*row.settings);
  watch.width = 1;  // two steps are asked about, none between
  const auto seen_at = [&](double low, double high) {
    return observe(experiment, {low, high, 2}, watch, reach_of_step(experiment, low));
  };
  if (!row.has_limit()) {
    constexpr double not_the_end = 0.98;  // of the scan, which may be the limit
    const double high = not_the_end * row.scanned;
    return plain(seen_at(high / 2, high).always_stable ? 0 : 1, "no limit was predicted, " + row.words());
  }
  const std::string predicted = fmt::format("{:.4g} {} predicted, {}", row.limit, row.unit, row.words());
  constexpr double closest = 0.01;
  for (const double distance : {closest, 0.05, 0.2}) {
    const double beyond = (1 + distance) * row.limit;
    const Observation seen = seen_at((1 - distance) * row.limit, beyond);
    if (seen.always_stable) {
      const double growth = growth_in_core(experiment, patch, watch, beyond);
      if (shows(growth, watch)) continue;
      return not_told(fmt::format("{}; beyond, it grows by {:.6g} a step: runs do not show that", predicted, growth));
    }
    if (seen.always_unstable || !seen.brackets.front().stable_below) continue;
    // Near its limit an inner solver ends early, in runs at other steps than in the matrix's small differences.
    if (subject.has_inner_solver() && distance > closest) return not_told(predicted);
    return plain(distance, predicted);
  }
  return plain(1, predicted);
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
    // Contact switches, and a run crosses what the matrix of one side does not know.
    if (!problem->has_grid() || problem->listed().empty() || problem->has_contact()) continue;
    all.push_back(
        {"stability",
         gate_row("stability", problem->name() + "/observed",
                  "distance from the limit predicted by the step's matrix within which runs lose stability", {{}, 0.01},
                  Origin::theory, "a step's matrix says what perturbations do; 1 % for runs of finite length"),
         "the step keeps something that is no part of its state, or depends on what was done before",
         [problem](const Subject& s) { return distance_of_limits(*problem, s); }});
  }
  return all;
}

}  // namespace plumbline
