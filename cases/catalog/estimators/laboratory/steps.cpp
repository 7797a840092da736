#include <cmath>

#include "cases/catalog/estimators/answers.hpp"
#include "cases/harness/integrators/growth.hpp"
#include "cases/harness/laboratory/limits.hpp"

namespace plumbline {
namespace {

// A perturbation that is multiplied by `factor` at every step, or by `later` from step `since` on.
struct GrowthOfSize {
  double factor = 1, later = 1;
  int since = 1000000;
};
struct WatchedRun {
  Run run;
  int steps = 0;
};
WatchedRun watched(const GrowthOfSize& law, const Watch& watch) {
  GrowthInRun growth(watch);
  WatchedRun found;
  double size = 1;
  do {
    size *= ++found.steps > law.since ? law.later : law.factor;
  } while (growth.goes_on(size));
  found.run = growth.run();
  return found;
}

// Most steps that a run of the laboratory makes where sizes are below `grown`.
constexpr int watched_steps = 300;

void add_run(const std::string& name, const WatchedRun& found, double growth, double amplified, bool unstable,
             double steps, KnownAnswers& all) {
  all.push_back({name + ".growth", found.run.growth, growth});
  all.push_back({name + ".amplified", found.run.amplified, amplified, amplified});
  all.push_back({name + ".unstable", static_cast<double>(found.run.unstable), unstable ? 1.0 : 0.0});
  all.push_back({name + ".steps", static_cast<double>(found.steps), steps});
}

}  // namespace

KnownAnswers growth_answers() {
  KnownAnswers all;
  Watch watch;
  watch.steps = watched_steps;
  add_run("decays", watched({0.99}, watch), 0.99, 1, false, watched_steps, all);
  add_run("stays", watched({1}, watch), 1, 1, false, watched_steps, all);
  // 10^4 is passed at the first step n with 2^n > 10^4; the growth of the first step is not known yet.
  add_run("doubles", watched({2}, watch), 2, 16384, true, 14, all);
  // By 0.5 % a step it is thirty times as large after 683 steps: the run is made twice as long, and once more.
  add_run("slowly", watched({1.005}, watch), 1.005, std::pow(1.005, 4 * watched_steps), true, 4 * watched_steps, all);
  // By 0.09 % a step, less than what counts as slow.
  add_run("hardly", watched({1.0009}, watch), 1.0009, std::pow(1.0009, watched_steps), false, watched_steps, all);
  // By 35 in the first step, then no more: the last third tells.
  add_run("once", watched({35, 1, 1}, watch), 1, 35, false, watched_steps, all);
  return all;
}

namespace {

// Steps whose radius is exp(a dt^p): the logarithm falls with the power p.
void add_powers(const std::string& name, double a, double p, KnownAnswers& all) {
  const double growth = a * std::pow(limit_of_york / 32, p);
  const SmallSteps steps = small_steps([&](double dt) { return std::exp(a * std::pow(dt, p)); });
  all.push_back({name + ".power", steps.power, p});
  all.push_back({name + ".smallest", steps.dt.back(), limit_of_york / 32});
  all.push_back({name + ".largest", steps.dt.front(), limit_of_york / 2});
  all.push_back({name + ".count", static_cast<double>(steps.dt.size()), 5});
  all.push_back({name + ".growth", steps.growth.back(), growth, growth});
}

// A step that is stable in these intervals, and else grows by as much as it is beyond the nearest of their ends.
Growth growth_beyond(double dt, const std::vector<StableInterval>& stable) {
  double beyond = HUGE_VAL;
  for (const StableInterval& interval : stable) {
    if (dt >= interval.low && dt <= interval.high) return {dt, 1, {}};
    beyond = std::min(beyond, dt < interval.low ? interval.low - dt : dt - interval.high);
  }
  return {dt, 1 + beyond, {}};
}

}  // namespace

KnownAnswers limit_answers() {
  KnownAnswers all;
  add_powers("cubic", 0.02, 3, all);
  add_powers("linear", 0.5, 1, all);
  const Scan scan{0.1, 4, 16};
  const auto count = [](const Prediction& found) { return static_cast<double>(found.stable.size()); };

  const std::vector<StableInterval> one{{0, 1.7}}, two{{0.3, 1.1}, {1.9, 3}};
  const auto predicted = [&](const std::vector<StableInterval>& stable) {
    return predict([&](double dt, const auto&) { return growth_beyond(dt, stable); }, scan);
  };
  const Prediction first = predicted(one), second = predicted(two);
  all.push_back({"one.intervals", count(first), 1});
  all.push_back({"one.limit", first.limit(), 1.7, 1.7});
  all.push_back({"two.intervals", count(second), 2});
  all.push_back({"two.limit", second.limit(), 0});  // the smallest step is not stable
  for (std::size_t k = 0; k < std::min<std::size_t>(second.stable.size(), 2); ++k) {
    const std::string name = "two." + std::to_string(k);
    all.push_back({name + ".low", second.stable[k].low, two[k].low, two[k].low});
    all.push_back({name + ".high", second.stable[k].high, two[k].high, two[k].high});
  }
  const Prediction always = predicted({{0, 9}}), never = predicted({{8, 9}});
  all.push_back({"always.stable", static_cast<double>(always.always_stable()), 1});
  all.push_back(yes("always.no_limit", std::isinf(always.limit())));
  all.push_back({"never.stable", static_cast<double>(never.always_unstable()), 1});
  all.push_back({"never.limit", never.limit(), 0});
  // A radius that rises as a root: by e beyond 1 at a distance of e^2 from the limit.
  const Prediction root = predict(
      [](double dt, const auto&) {
        return Growth{dt, 1 + std::sqrt(std::max(0.0, dt - 2.3)), {}};
      },
      scan);
  all.push_back({"root.limit", root.limit(), 2.3, 2.3});
  Scan to_first = scan;
  to_first.first_limit_only = true;
  const Prediction stops = predict(
      [&](double dt, const auto&) {
        return growth_beyond(dt, {{0, 0.5}, {1, 2}});
      },
      to_first);
  all.push_back({"stops.intervals", count(stops), 1});
  all.push_back({"stops.limit", stops.limit(), 0.5, 0.5});

  // Runs bracket the limits, the one of stability above, the other below the step where a run changes.
  Watch watch;
  watch.width = 1e-10;
  const Observation seen = observe(
      [&](double dt) {
        return Run{1, 1, growth_beyond(dt, two).per_step > 1};
      },
      scan, watch);
  const std::vector<double> ends{0.3, 1.1, 1.9, 3};
  all.push_back({"seen.brackets", static_cast<double>(seen.brackets.size()), 4});
  for (std::size_t k = 0; k < std::min<std::size_t>(seen.brackets.size(), 4); ++k) {
    const Bracket& bracket = seen.brackets[k];
    const std::string name = "seen." + std::to_string(k);
    all.push_back({name + ".middle", 0.5 * (bracket.low + bracket.high), ends[k], ends[k]});
    all.push_back({name + ".holds", static_cast<double>(bracket.low <= ends[k] && ends[k] <= bracket.high), 1});
    all.push_back({name + ".below", static_cast<double>(bracket.stable_below), k % 2 == 0 ? 0.0 : 1.0});
  }
  all.push_back({"seen.always", static_cast<double>(seen.always_stable || seen.always_unstable), 0});
  return all;
}

}  // namespace plumbline
