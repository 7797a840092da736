#include "cases/catalog/gas/shock_tube.hpp"

#include <cmath>
#include <memory>

#include "cases/catalog/gas/finite_volume_comparator.hpp"
#include "reference/gas_problem.hpp"

namespace plumbline {
namespace {

constexpr int cells_across_tube = 4;

}  // namespace

TubeParameters::TubeParameters(const ShockTube& defaults, Parameters given)
    : Parameters(std::move(given)),
      tube(defaults) {
  auto& [left, right, gamma] = tube.states;
  left.density = positive("left.density", left.density, "kg/m^3", "density left of the diaphragm");
  left.velocity = any_number("left.velocity", left.velocity, "m/s", "velocity left of the diaphragm");
  left.pressure = positive("left.pressure", left.pressure, "Pa", "pressure left of the diaphragm");
  right.density = positive("right.density", right.density, "kg/m^3", "density right of the diaphragm");
  right.velocity = any_number("right.velocity", right.velocity, "m/s", "velocity right of the diaphragm");
  right.pressure = positive("right.pressure", right.pressure, "Pa", "pressure right of the diaphragm");
  gamma = within("gamma", gamma, "1", 1, 10, "ratio of specific heats");
  tube.diaphragm = number({.name = "diaphragm",
                           .value = tube.diaphragm,
                           .unit = "m",
                           .low = tube.low,
                           .high = tube.high,
                           .low_open = true,
                           .high_open = true,
                           .description = "position of the diaphragm"});
  tube.end_time = positive("t_end", tube.end_time, "s", "end time");
  tube.dimension = integer({.name = "dimension",
                            .value = static_cast<double>(tube.dimension),
                            .low = 1,
                            .high = 3,
                            .description = "of the space: on a line, or a few cells across between mirrors"});
}

double disturbed_by_wall(const reference::GasState& gas, double gamma, double time) {
  if (gas.velocity == 0) return 0;
  return (std::abs(gas.velocity) + std::sqrt(gamma * gas.pressure / gas.density)) * time;
}

GasFlow tube_flow(const ShockTube& tube) {
  GasFlow flow;
  flow.cells_along = tube.high - tube.low;
  flow.low[0] = tube.low;
  flow.high[0] = tube.high;
  flow.jumps = {tube.diaphragm};
  flow.initial = [tube](double x) { return x < tube.diaphragm ? tube.states.left : tube.states.right; };
  const auto exact = std::make_shared<const reference::RiemannSolution>(tube.states);
  flow.exact = [exact, at = tube.diaphragm](double x, double t) { return exact->sample((x - at) / t); };
  const auto margin = [&](const reference::GasState& gas) {
    const double reach = disturbed_by_wall(gas, tube.states.gamma, tube.end_time);
    return reach > 0 ? reach + 0.1 * flow.cells_along : 0.0;  // a tenth: waves are some cells wide on coarse meshes
  };
  flow.margin = {margin(tube.states.left), margin(tube.states.right)};
  flow.gamma = tube.states.gamma;
  flow.end_time = tube.end_time;
  return flow;
}

std::function<std::unique_ptr<Problem>(const Settings&)> tube_run(const ShockTube& defaults) {
  return [defaults](const Settings& settings) {
    const ShockTube tube = TubeParameters(defaults, settings).tube;
    GasFlow flow = tube_flow(tube);
    flow.dim = tube.dimension;
    const double h = flow.cells_along / settings.number("cells");
    for (std::size_t d = 1; d < static_cast<std::size_t>(tube.dimension); ++d) flow.high[d] = cells_across_tube * h;
    return gas_problem(flow, settings);
  };
}

std::function<std::vector<Comparator>(const Settings&, const std::vector<double>&)> beside_finite_volumes(
    const ShockTube& defaults) {
  return [defaults](const Settings& settings, const std::vector<double>& cells) -> std::vector<Comparator> {
    const ShockTube tube = TubeParameters(defaults, settings).tube;
    const reference::RiemannSolution exact(tube.states);
    return {finite_volume_comparator(
        reference::riemann_tube(tube.states, tube.diaphragm, tube.end_time, tube.low, tube.high),
        [&](double x) { return exact.sample((x - tube.diaphragm) / tube.end_time); }, cells)};
  };
}

}  // namespace plumbline
