#include "cases/catalog/gas/shock_tube.hpp"

#include <cmath>
#include <memory>

#include "cases/catalog/gas/stick.hpp"
#include "reference/gas_problem.hpp"

namespace plumbline {
namespace {

Key positive(std::string name, double value, std::string unit, std::string description) {
  return {.name = std::move(name),
          .value = value,
          .unit = std::move(unit),
          .low = 0,
          .low_open = true,
          .description = std::move(description)};
}

}  // namespace

std::vector<Key> shock_tube_keys(const ShockTube& tube) {
  const auto velocity = [](std::string name, double value, std::string description) {
    return Key{.name = std::move(name), .value = value, .unit = "m/s", .description = std::move(description)};
  };
  const auto& [left, right, gamma] = tube.states;
  return {positive("left.density", left.density, "kg/m^3", "density left of the diaphragm"),
          velocity("left.velocity", left.velocity, "velocity left of the diaphragm"),
          positive("left.pressure", left.pressure, "Pa", "pressure left of the diaphragm"),
          positive("right.density", right.density, "kg/m^3", "density right of the diaphragm"),
          velocity("right.velocity", right.velocity, "velocity right of the diaphragm"),
          positive("right.pressure", right.pressure, "Pa", "pressure right of the diaphragm"),
          {.name = "gamma",
           .value = gamma,
           .low = 1,
           .high = 10,
           .low_open = true,
           .description = "ratio of specific heats"},
          {.name = "diaphragm",
           .value = tube.diaphragm,
           .unit = "m",
           .low = tube.low,
           .high = tube.high,
           .low_open = true,
           .high_open = true,
           .description = "position of the diaphragm"},
          positive("t_end", tube.end_time, "s", "end time"),
          {.name = "dimension",
           .value = static_cast<double>(tube.dimension),
           .low = 1,
           .high = 3,
           .integer = true,
           .description = "of the space: on a line, or a few cells across between mirrors"}};
}

ShockTube shock_tube_from(const Settings& settings, const ShockTube& defaults) {
  ShockTube tube = defaults;
  tube.states.left = {settings.number("left.density"), settings.number("left.velocity"),
                      settings.number("left.pressure")};
  tube.states.right = {settings.number("right.density"), settings.number("right.velocity"),
                       settings.number("right.pressure")};
  tube.states.gamma = settings.number("gamma");
  tube.diaphragm = settings.number("diaphragm");
  tube.end_time = settings.number("t_end");
  tube.dimension = static_cast<int>(settings.number("dimension"));
  return tube;
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

Comparator tube_stick(const ShockTube& tube, const std::vector<double>& cells) {
  const reference::RiemannSolution exact(tube.states);
  return finite_volume_stick(
      reference::riemann_tube(tube.states, tube.diaphragm, tube.end_time, tube.low, tube.high),
      [&](double x) { return exact.sample((x - tube.diaphragm) / tube.end_time); }, cells);
}

std::unique_ptr<Problem> shock_tube_problem(const ShockTube& tube, const Settings& settings) {
  GasFlow flow = tube_flow(tube);
  flow.dim = tube.dimension;
  const double h = flow.cells_along / settings.number("cells");
  for (std::size_t d = 1; d < static_cast<std::size_t>(tube.dimension); ++d) flow.high[d] = cells_across_tube * h;
  return gas_problem(flow, settings);
}

}  // namespace plumbline
