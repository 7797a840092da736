#include "cases/laboratory/safe_step.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cases/harness/errors.hpp"

namespace plumbline {
namespace {

constexpr double width = 1e-4;  // relative, of limits

std::vector<double> places(bool finely) {
  if (!finely) return {0.5, 0.25, 0.01};
  return {0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.1, 0.05, 0.02, 0.01, 0.001};
}

// None at which a point stands on a face between cells: there linear shapes have a kink, and the step no derivative.
std::vector<double> depths(bool finely) {
  if (!finely) return {0.6, 0.01};
  return {0.9, 0.7, 0.6, 0.3, 0.1, 0.05, 0.01, 1e-3, 1e-4};
}

}  // namespace

SafeStep safe_step_of_bar(const Method& method, int order, const std::map<std::string, double>& parameters, int ppc,
                          bool finely) {
  const MapChoice maps{method.shape, method.transfer, order};
  const auto stepped = [&](std::function<Patch(const Extent&)> patch) {
    return Experiment{std::move(patch), {method.integrator, parameters}, Positions::frozen};
  };
  const auto regular = [&](const Extent& extent) { return bar_patch(maps, ppc, 0.5, extent); };
  // Implicit steps reach far and cost much: two large ones tell whether they have a limit at all.
  const bool far = reach_of_step(stepped(regular), 3) > far_reach;
  const Scan scan = far ? Scan{1, 4, 2} : Scan{0.02, 4, 16};
  const auto limit_of = [&](std::function<Patch(const Extent&)> patch) {
    try {
      return predict(stepped(std::move(patch)), scan, width).limit();
    } catch (const std::runtime_error&) {  // a step that cannot be taken behind this edge is none to call safe
      return 0.0;
    }
  };
  SafeStep safe{method, order, ppc};
  safe.limit = safe.edge = HUGE_VAL;
  for (const double place : places(finely)) {
    const double limit = limit_of([&](const Extent& extent) { return bar_patch(maps, ppc, place, extent); });
    if (place == 0.5) safe.regular = limit;
    if (limit < safe.limit) {
      safe.limit = limit;
      safe.place = place;
    }
  }
  for (const double depth : depths(finely)) {
    const double limit = limit_of([&](const Extent&) { return bar_edge_patch(maps, ppc, depth, 6); });
    if (limit < safe.edge) {
      safe.edge = limit;
      safe.edge_depth = depth;
    }
  }
  return safe;
}

namespace {

// The least limit of a registered problem over the places of its points, with the choices that it has in common with a run.
double least_limit(const std::string& name, const Settings& run) {
  const StabilityProblem& problem = find_stability_problem(name);
  std::vector<Override> common;
  const Settings known = stability_settings(problem, "default", {});
  for (const Key& key : known.keys()) {
    if (run.has(key.name) && run.is_set(key.name) && key.name != "offset") common.emplace_back(key.name, run[key.name]);
  }
  double least = HUGE_VAL;
  for (const double place : places(false)) {
    std::vector<Override> overrides = common;
    overrides.emplace_back("offset", place);
    const Settings settings = stability_settings(problem, "default", overrides);
    least = std::min(least, predict(experiment_of(problem, settings), problem.scan(settings), width).limit());
  }
  return least;
}

}  // namespace

double safe_courant_number(const Settings& settings, Kind kind, int dim) {
  const bool gas = kind == Kind::gas || kind == Kind::coupled;
  const Method method{settings.text("integrator"), settings.text("shape"), settings.text("transfer")};
  const double limit = gas ? least_limit("gas", settings)
                           : safe_step_of_bar(method, settings.integer("transfer_order"),
                                              integrator_parameters(settings), settings.integer("ppc"), false)
                                 .worst();
  if (!(limit > 0)) {
    throw UsageError("cfl", "auto", "a number", {},
                     "cfl=auto: the laboratory finds no stable step for integrator=" + method.integrator +
                         ", shape=" + method.shape + ", transfer=" + method.transfer + "; `plumbline stability " +
                         (gas ? "gas" : "bar") + "` shows the growth");
  }
  return auto_share * limit / std::sqrt(dim);
}

}  // namespace plumbline
