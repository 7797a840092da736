#include "cases/harness/laboratory/safe_step.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumbline {
namespace {

constexpr double safe_width = 1e-4;  // relative, of limits

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
  const Scan scan = far ? Scan{1, 4, 2} : Scan{0.005, 4, 20};  // from below sqrt(2 depth) on
  const auto limit_of = [&](std::function<Patch(const Extent&)> patch) {
    try {
      return predict(stepped(std::move(patch)), scan, safe_width).limit();
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

}  // namespace plumbline
