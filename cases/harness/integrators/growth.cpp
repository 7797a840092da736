#include "cases/harness/integrators/growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/harness/integrators/small_scenes.hpp"
#include "cases/harness/laboratory/bar_patch.hpp"
#include "cases/harness/laboratory/matrices.hpp"
#include "cases/harness/laboratory/oscillator.hpp"
#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {
namespace {

constexpr int halvings = 5;

SmallSteps with_power(SmallSteps steps) {
  const std::size_t n = steps.dt.size();
  const double fine = steps.growth[n - 1], coarse = steps.growth[n - 2];
  if (fine > 1e-12 && coarse > fine) steps.power = std::log2(coarse / fine);
  return steps;
}

Maps maps_on_bar(const Subject& subject) {
  std::vector<Lack> first;
  for (const Maps& maps : {Maps{"linear", "flip"}, Maps{"quadratic", "flip"}, Maps{"quadratic", "apic"}}) {
    auto missing = lacks(subject.entry(), maps.shape, maps.transfer);
    if (missing.empty()) return maps;
    if (first.empty()) first = std::move(missing);
  }
  throw CannotWork(std::move(first));
}

Experiment bar_of(const Subject& subject) {
  const Maps maps = maps_on_bar(subject);
  Experiment experiment;
  experiment.patch = [maps](const Extent& extent) { return bar_patch({maps.shape, maps.transfer, 2}, 1, 0.5, extent); };
  experiment.integrator = subject.choice();
  return experiment;
}

}  // namespace

SmallSteps small_steps(const std::function<double(double dt)>& radius) {
  SmallSteps steps;
  double dt = limit_of_york;
  for (int k = 0; k < halvings; ++k) {
    dt /= 2;
    steps.dt.push_back(dt);
    steps.growth.push_back(std::log(radius(dt)));
  }
  return with_power(std::move(steps));
}

SmallSteps small_steps_on_oscillator(const Subject& subject) {
  return small_steps([&](double dt) { return spectral_radius(step_matrix(subject.choice(), 0, dt)); });
}

SmallSteps small_steps_on_bar(const Subject& subject) {
  const Experiment experiment = bar_of(subject);
  return small_steps([&](double dt) { return worst_growth(experiment, dt).per_step; });
}

double limit_on_bar(const Subject& subject) {
  Scan scan{0.1, limit_of_york, 8};
  scan.first_limit_only = true;
  return std::min(predict(bar_of(subject), scan, 1e-3).limit(), limit_of_york);
}

double limit_on_oscillator(const Subject& subject) {
  return subject.once<double>("limit/oscillator", [&] {
    const StabilityProblem& problem = find_stability_problem("oscillator");
    std::vector<Override> overrides{{"integrator", subject.name()}};
    for (const auto& [key, value] : subject.choice().parameters) overrides.emplace_back(key, value);
    const Prediction predicted = problem.predicted(stability_settings(problem, "default", overrides), 1e-9);
    return predicted.always_stable() ? std::numeric_limits<double>::infinity() : predicted.limit();
  });
}

}  // namespace plumbline
