#include "cases/catalog/stability/fast_growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumbline {
namespace {

Growth growth_at(const Experiment& experiment, double dt) {
  const Patch patch = experiment.patch({1, 0});
  const Amplification a(patch, experiment.integrator, experiment.positions, dt * patch.units.time());
  return {dt, a.spectral_radius({}), {}};
}

}  // namespace

Prediction predict_beside(double slow, const Experiment& experiment, const Scan& scan, double width) {
  std::vector<Growth> all;
  const auto excess = [&](double dt, const std::vector<WaveNumber>&) {
    Growth growth = growth_at(experiment, dt);
    all.push_back(growth);
    growth.per_step *= std::exp(-slow * dt);
    return growth;
  };
  Prediction prediction = predict(excess, scan, width);
  for (Growth& growth : prediction.growth) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const Growth& g) { return g.dt == growth.dt; });
    growth.per_step = same->per_step;
  }
  return prediction;
}

Watch watch_beside(double slow, const Scan& scan) {
  Watch watch;
  watch.core = 1;
  if (slow == 0) return watch;
  watch.steps = 150;
  watch.slowest = std::expm1(slow * scan.high);
  watch.grown = 1e6;
  watch.grown_slowly = 1e3;
  return watch;
}

GrowthSeen compare_growth(const Experiment& experiment, double dt) {
  constexpr double small = 1e-13, decades = 7;  // from above rounding to where squares count
  GrowthSeen seen;
  seen.predicted = growth_at(experiment, dt).per_step;
  Watch watch;
  watch.core = 1;
  watch.perturbation = small;
  watch.grown = std::numeric_limits<double>::infinity();
  watch.steps = static_cast<int>(std::min(1e5, decades * std::log(10.0) / std::log(seen.predicted)));
  seen.observed = run_perturbed(experiment, watch, 0, dt).growth;
  return seen;
}

}  // namespace plumbline
