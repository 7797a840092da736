#include "cases/harness/laboratory/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "kernel/inadmissible.hpp"

namespace plumbline {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double least_tail = 1e-10;  // what is cut off at the patch's edge: below this it moves no eigenvalue by 1e-9

}  // namespace

std::vector<double> Scan::values() const {
  std::vector<double> all;
  for (int k = 0; k < steps; ++k) all.push_back(low * std::pow(high / low, static_cast<double>(k) / (steps - 1)));
  return all;
}

namespace {

// The amplification at one step after another, on patches just as large as a step reaches.
class Predictor {
 public:
  explicit Predictor(const Experiment& experiment) : experiment_(experiment), reach_(experiment.least_reach) { make(); }

  // A patch is too small while changes reach its edge; what stops there may be the edge's doing.
  Amplification at(double dt) {
    for (;;) {
      const bool last = patch_.directions == 0 || 2 * reach_ > experiment_.most_reach;
      try {
        Amplification found(patch_, experiment_.integrator, experiment_.positions, dt * patch_.units.time());
        if (patch_.directions == 0 || found.tail() <= least_tail) return found;
        if (last) {
          throw std::runtime_error("a step of " + experiment_.integrator.name + " reaches further than " +
                                   std::to_string(experiment_.most_reach) + " periods: what it does there is " +
                                   std::to_string(found.tail()));
        }
      } catch (const NotStepped&) {
        if (last || reach_ >= far_reach) throw;
      }
      reach_ *= 2;
      make();
    }
  }
  int directions() const { return patch_.directions; }
  int reach() const { return reach_; }

 private:
  void make() { patch_ = experiment_.patch({1, reach_}); }

  const Experiment& experiment_;
  int reach_;
  Patch patch_;
};

}  // namespace

namespace {

struct Between {
  double low, high;
  bool low_stable;
};

// Where the radius passes `threshold`. `growing`: a wave of the unstable side.
double crossing(const GrowthOfStep& growth, Between ends, WaveNumber growing, double threshold, double width) {
  while (ends.high - ends.low > width * ends.high) {
    const double middle = 0.5 * (ends.low + ends.high);
    const Growth worst = growth(middle, {growing});
    const bool here = worst.per_step <= threshold;
    if (!here) growing = worst.theta;
    (here == ends.low_stable ? ends.low : ends.high) = middle;
  }
  return 0.5 * (ends.low + ends.high);
}

// The radius leaves one a little before it passes stable_radius: by as much as stable_radius - 1 over its slope, which half
// that rise tells. Rises as a root does, of two eigenvalues that meet, come out the same to their square.
double limit_of(const GrowthOfStep& growth, const Between& ends, const WaveNumber& growing, double width) {
  constexpr double close = 1e-4;  // slower rises are no limit's
  const double limit = crossing(growth, ends, growing, stable_radius, width);
  const double half_way = 1 + (stable_radius - 1) / 2;
  const Between near{ends.low_stable ? limit * (1 - close) : limit, ends.low_stable ? limit : limit * (1 + close),
                     ends.low_stable};
  if (width > close * close) return limit;
  if (growth(ends.low_stable ? near.low : near.high, {growing}).per_step > half_way) return limit;
  return 2 * crossing(growth, near, growing, half_way, width) - limit;
}

}  // namespace

namespace {

// Of the whole scan the largest step comes first: patches are then as large as any step reaches.
std::vector<Growth> scanned(const GrowthOfStep& growth, const Scan& scan) {
  const std::vector<double> steps = scan.values();
  std::vector<Growth> found;
  if (scan.first_limit_only) {
    for (const double dt : steps) {
      found.push_back(growth(dt, {}));
      if (!(found.back().per_step <= stable_radius)) break;
    }
    return found;
  }
  std::for_each(steps.rbegin(), steps.rend(), [&](double dt) { found.push_back(growth(dt, {})); });
  std::reverse(found.begin(), found.end());
  return found;
}

}  // namespace

Prediction predict(const GrowthOfStep& growth, const Scan& scan, double width) {
  Prediction prediction;
  prediction.growth = scanned(growth, scan);
  std::vector<double> steps = scan.values();
  steps.resize(prediction.growth.size());
  const auto stable = [&](std::size_t k) { return prediction.growth[k].per_step <= stable_radius; };
  const auto limit_between = [&](std::size_t k, bool low_stable) {
    const WaveNumber growing = prediction.growth[low_stable ? k + 1 : k].theta;
    return limit_of(growth, {steps[k], steps[k + 1], low_stable}, growing, width);
  };
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (!stable(k)) continue;
    StableInterval interval{k == 0 ? 0 : limit_between(k - 1, false), infinite};
    while (k + 1 < steps.size() && stable(k + 1)) ++k;
    if (k + 1 < steps.size()) interval.high = limit_between(k, true);
    prediction.stable.push_back(interval);
  }
  return prediction;
}

Prediction predict(const Experiment& experiment, const Scan& scan, double width) {
  Predictor predictor(experiment);
  std::optional<Amplification> first;
  std::optional<NotStepped> stopped;
  const auto growth = [&](double dt, const std::vector<WaveNumber>& hints) -> Growth {
    try {
      const Amplification a = predictor.at(dt);
      if (!first) first = a;
      const WorstWave worst = worst_wave(a, predictor.directions(), hints);
      return {dt, worst.radius, worst.theta};
    } catch (const NotStepped& reason) {  // however small a wave, it does not outlast the step
      stopped = reason;
      return {dt, infinite, {}};
    }
  };
  Prediction prediction = predict(growth, scan, width);
  if (!first) throw *stopped;
  prediction.differences = first->differences();
  prediction.tail = first->tail();
  prediction.unknowns = first->unknowns();
  prediction.reach = predictor.reach();
  return prediction;
}

int reach_of_step(const Experiment& experiment, double dt) {
  Predictor predictor(experiment);
  predictor.at(dt);
  return predictor.reach();
}

Growth worst_growth(const Experiment& experiment, double dt) {
  Predictor predictor(experiment);
  const WorstWave worst = worst_wave(predictor.at(dt), predictor.directions());
  return {dt, worst.radius, worst.theta};
}

std::vector<double> radii_over_waves(const Experiment& experiment, double dt, const std::vector<double>& thetas) {
  Predictor predictor(experiment);
  const Amplification a = predictor.at(dt);
  std::vector<double> radii;
  for (const double theta : thetas) radii.push_back(a.spectral_radius({theta, 0}));
  return radii;
}

namespace {

// A run of the core with its margins, which are the core's periods again.
class PeriodicRun {
 public:
  PeriodicRun(const Experiment& experiment, const Watch& watch, int reach, double dt)
      : patch_(experiment.patch({watch.core, reach})),
        core_(watch.core),
        map_(patch_.scene, patch_.units, experiment.integrator, experiment.positions, dt * patch_.units.time()),
        base_(map_.state()) {
    find_sources();
    perturb(watch);
  }

  void step() {
    map_.step();
    state_ = map_.state();
    repeat();
    return_drift();
    map_.set_state(state_);
  }

  // How far the state of the core is from the one at rest; positions follow velocities and do not count.
  double size() const {
    double sum = 0;
    for (const std::size_t k : counted_) sum += (state_[k] - base_[k]) * (state_[k] - base_[k]);
    return std::sqrt(sum);
  }

 private:
  struct Copy {
    std::size_t to, from;
    double shift;
  };

  void find_sources() {
    std::map<std::array<int, 5>, std::size_t> core_entry;  // body, member, slot, period
    const auto place = [&](std::size_t k) -> const Patch::Place& {
      return patch_.places[map_.entry(k).body][static_cast<std::size_t>(map_.entry(k).point)];
    };
    const auto key = [&](std::size_t k, const Patch::Period& period) {
      return std::array<int, 5>{static_cast<int>(map_.entry(k).body), place(k).member, map_.entry(k).slot, period[0],
                                period[1]};
    };
    const auto inside = [&](const Patch::Period& period) {
      for (int d = 0; d < patch_.directions; ++d) {
        if (period[static_cast<std::size_t>(d)] < 0 || period[static_cast<std::size_t>(d)] >= core_) return false;
      }
      return true;
    };
    for (std::size_t k = 0; k < map_.size(); ++k) {
      if (!inside(place(k).period)) continue;
      core_entry[key(k, place(k).period)] = k;
      if (map_.position_direction(k) < 0) counted_.push_back(k);
    }
    for (std::size_t k = 0; k < map_.size(); ++k) {
      const Patch::Period period = place(k).period;
      if (inside(period)) continue;
      Patch::Period source = period;
      double shift = 0;
      const int direction = map_.position_direction(k);
      for (std::size_t d = 0; d < static_cast<std::size_t>(patch_.directions); ++d) {
        source[d] = ((period[d] % core_) + core_) % core_;
        if (direction >= 0) {
          shift += (period[d] - source[d]) * patch_.step[d][static_cast<std::size_t>(direction)] / patch_.units.length;
        }
      }
      copies_.push_back({k, core_entry.at(key(k, source)), shift});
    }
  }

  void perturb(const Watch& watch) {
    std::mt19937_64 random(watch.seed);
    const auto uniform = [&] { return 2 * (static_cast<double>(random() >> 11) * 0x1p-53) - 1; };
    state_ = base_;
    for (const std::size_t k : counted_) {
      state_[k] += watch.perturbation * uniform();
    }
    repeat();
    map_.set_state(state_);
  }

  void repeat() {
    for (const Copy& copy : copies_) state_[copy.to] = state_[copy.from] + copy.shift;
  }

  // A lattice that has drifted by a period lies to the grid as it did at the start.
  void return_drift() {
    for (std::size_t d = 0; d < static_cast<std::size_t>(patch_.directions); ++d) {
      double length = 0;
      for (const double x : patch_.step[d]) length += x * x;
      length /= patch_.units.length * patch_.units.length;
      double drift = 0;
      int count = 0;
      for (std::size_t k = 0; k < state_.size(); ++k) {
        const int direction = map_.position_direction(k);
        if (direction < 0) continue;
        drift += (state_[k] - base_[k]) * patch_.step[d][static_cast<std::size_t>(direction)] / patch_.units.length;
        count += direction == 0;
      }
      if (count == 0) continue;
      const double periods = drift / (count * length);
      if (std::abs(periods) < 1) continue;
      const double back = std::trunc(periods);
      for (std::size_t k = 0; k < state_.size(); ++k) {
        const int direction = map_.position_direction(k);
        if (direction < 0) continue;
        state_[k] -= back * patch_.step[d][static_cast<std::size_t>(direction)] / patch_.units.length;
      }
    }
  }

  Patch patch_;
  int core_;
  StepMap map_;
  std::vector<double> base_, state_;
  std::vector<Copy> copies_;
  std::vector<std::size_t> counted_;
};

}  // namespace

bool GrowthInRun::goes_on(double size) {
  ++done_;
  run_.amplified = std::max(run_.amplified, size);
  if (done_ > since_ && from_ > 0) run_.growth = std::pow(size / from_, 1.0 / (done_ - since_));
  run_.unstable = !(size <= watch_.grown);
  if (run_.unstable || size == 0) return false;
  if (done_ == 1 || done_ == 2 * watch_.steps / 3) {
    from_ = size;
    since_ = done_;
  }
  if (done_ < last_) return true;
  const bool grows = run_.growth > 1 + watch_.slowest;
  run_.unstable = grows && run_.amplified > watch_.grown_slowly;
  if (!grows || run_.unstable || last_ >= 4 * watch_.steps) return false;
  last_ *= 2;
  return true;
}

Run run_perturbed(const Experiment& experiment, const Watch& watch, int reach, double dt) {
  GrowthInRun growth(watch);
  try {
    PeriodicRun run(experiment, watch, reach, dt);
    const double start = run.size();
    double size = 0;
    do {
      run.step();
      size = run.size() / start;
      if (!std::isfinite(size)) throw InadmissibleState("not finite", "", 0, "", size);
    } while (growth.goes_on(size));
    return growth.run();
  } catch (const InadmissibleState&) {
    Run stopped = growth.run();
    stopped.unstable = true;
    if (stopped.growth <= 1) stopped.growth = infinite;
    return stopped;
  }
}

Observation observe(const Experiment& experiment, const Scan& steps, const Watch& look, int reach) {
  Scan scan = steps;
  Watch watch = look;
  if (reach > far_reach) {  // an implicit step: patches are large and steps dear, and unstable ones easily seen
    watch.core = std::min(watch.core, 8);
    watch.steps = std::min(watch.steps, 150);
    scan.steps = std::min(scan.steps, 4);
  }
  return observe([&](double dt) { return run_perturbed(experiment, watch, reach, dt); }, scan, watch);
}

Observation observe(const std::function<Run(double dt)>& run_at, const Scan& scan, const Watch& watch) {
  Observation observation;
  const std::vector<double> steps = scan.values();
  std::vector<bool> unstable;
  for (const double dt : steps) {
    const Run run = run_at(dt);
    observation.growth.push_back({dt, run.growth, {}});
    unstable.push_back(run.unstable);
  }
  observation.always_stable = std::none_of(unstable.begin(), unstable.end(), [](bool u) { return u; });
  observation.always_unstable = std::all_of(unstable.begin(), unstable.end(), [](bool u) { return u; });
  for (std::size_t k = 0; k + 1 < steps.size(); ++k) {
    if (unstable[k] == unstable[k + 1]) continue;
    double low = steps[k], high = steps[k + 1];
    while (high - low > watch.width * high) {
      const double middle = 0.5 * (low + high);
      const bool here = run_at(middle).unstable;
      (here == unstable[k] ? low : high) = middle;
    }
    observation.brackets.push_back({low, high, !unstable[k]});
  }
  return observation;
}

}  // namespace plumbline
