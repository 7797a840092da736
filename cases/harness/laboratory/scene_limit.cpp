#include "cases/harness/laboratory/scene_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/laboratory/known_limits.hpp"
#include "kernel/traits.hpp"

namespace plumbline {
namespace {

constexpr double scene_width = 1e-3;  // relative, of limits: little beside auto_share

// Keys of a kind of scene mean the same in all scenes and problems of it; a problem's own do not. Where points stand is
// sampled, whatever the run's offset.
std::vector<Override> common_choices(const StabilityProblem& problem, const Settings& run) {
  const Settings known = stability_settings(problem, "default", {});
  std::vector<Override> common;
  for (const Key& key : kind_keys(problem.kind())) {
    if (key.name == "offset" || !known.has(key.name) || !run.has(key.name) || !run.is_set(key.name)) continue;
    common.emplace_back(key.name, run[key.name]);
  }
  return common;
}

// The limit, and why there is none.
struct Found {
  double limit = 0;
  std::string why = {};
};

Found look(const StabilityProblem& problem, const Settings& settings) {
  const Scan scan = scan_of_first_limit(problem, settings);
  try {
    const Prediction prediction = problem.predicted(settings, scan, scene_width);
    const Growth& first = prediction.growth.front();
    return {std::min(prediction.limit(), scan.high),
            fmt::format("it grows by {:.6g} in a step of {:.4g} {}", first.per_step, first.dt, problem.unit())};
  } catch (const std::runtime_error& error) {  // a step that cannot be taken is none to call safe
    return {0, error.what()};
  } catch (const CannotWork& parts) {
    return {0, parts.what()};
  }
}

Found remembered(const StabilityProblem& problem, const Settings& settings) {
  static std::mutex guard;
  static std::map<std::string, Found> all;
  const std::string key = problem.name() + "\n" + settings.canonical();
  {
    const std::lock_guard lock(guard);
    if (const auto found = all.find(key); found != all.end()) return found->second;
  }
  const Found found = look(problem, settings);
  const std::lock_guard lock(guard);
  return all.emplace(key, found).first->second;
}

}  // namespace

std::vector<SceneLimit> limits_in(const Scene& scene, const Settings& run) {
  const SceneContents contents = contents_of(scene);
  std::vector<SceneLimit> all;
  for (const StabilityProblem* problem : stability_problems()) {
    const std::vector<Occurrence> occurrences = problem->occurrences(contents);
    if (occurrences.empty()) continue;
    const std::vector<Override> common = common_choices(*problem, run);
    for (const Occurrence& occurrence : occurrences) {
      std::vector<Override> overrides = common;
      overrides.insert(overrides.end(), occurrence.choices.begin(), occurrence.choices.end());
      const Settings settings = stability_settings(*problem, "default", overrides);
      const Found found = remembered(*problem, settings);
      all.push_back({problem, settings, occurrence.choices, found.limit,
                     found.limit * problem->fastest(settings) * occurrence.factor, found.why});
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.courant < b.courant; });
  return all;
}

double safe_courant_number(const Scene& scene, const Settings& run) {
  const std::vector<SceneLimit> all = limits_in(scene, run);
  if (all.empty()) throw std::logic_error("no stability problem occurs in a scene of nothing");
  const SceneLimit& least = all.front();
  if (least.limit > 0) return auto_share * least.courant;
  const std::string name = least.problem->name(), integrator = run.text("integrator");
  throw UsageError(
      "cfl", "auto", "a number", {},
      fmt::format("cfl=auto: {} has no stable step on problem {} ({}), which this scene contains: {}; "
                  "`plumbline stability {} --integrator {}` shows more",
                  integrator, name, choices_in_words(least.settings, least.choices), least.why, name, integrator));
}

}  // namespace plumbline
