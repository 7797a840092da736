// York's gas expansion: a uniform cylinder of gas let go into a vacuum.
#include <algorithm>
#include <cmath>
#include <memory>

#include "cases/catalog/gas/expansion_watch.hpp"
#include "cases/catalog/gas/fill_ball.hpp"
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/verify/restart_gate.hpp"
#include "reference/converged_gas.hpp"

namespace plumbline {
namespace {

struct Cylinder : Parameters {
  using Parameters::Parameters;
  RadialGeometry geometry = radial_geometry(2, text(geometry_key(2, "plane")));
  double radius = number({.name = "radius",
                          .value = 0.38,
                          .unit = "m",
                          .low = 0.1,
                          .high = 1,
                          .description = "of the cylinder; York's input has 0.376"});
  double end_time = within("t_end", 0.005, "s", 0, 0.006, "end time");
};

GasFlow expansion_flow(const Settings& settings) {
  const Cylinder cylinder(settings);
  const double radius = cylinder.radius, time = cylinder.end_time;
  const reference::ConvergedGasProblem problem = reference::gas_expansion_reference(radius, time);
  GasFlow flow;
  flow.end_time = time;
  flow.gamma = problem.gas.gamma;
  const double front = reference::gas_expansion_front(radius, time).value;
  const double h = cell_size(flow, settings);
  set_geometry(flow, cylinder.geometry, std::max(1.0, front + 4 * h), settings);
  flow.initial = problem.gas.initial;
  const auto solution = [radius, time]() -> const reference::ConvergedGas& {
    return reference::gas_expansion(radius, time);
  };
  flow.exact = [solution](double r, double) { return solution().sample(r); };
  flow.exact_error = [solution] { return solution().error(); };
  flow.fill = [geometry = cylinder.geometry, radius, initial = flow.initial](
                  std::shared_ptr<const IdealGas> gas, const PointRule& rule, const GridSpec& grid) {
    return fill_ball(std::move(gas), {geometry, radius, initial, true}, rule, grid);
  };
  const reference::GasState start = flow.initial(0);
  const GasEdge edge{"front", [front](double) { return reference::Bounded{front, 0.0}; }};
  watch_expansion(flow, start.pressure * std::pow(start.density, -flow.gamma), edge);
  return flow;
}

std::vector<CaseGate> gates() {
  const std::string spray =
      "on fine meshes points at the edge of vacuum are split, and the motion of the halves among each other becomes "
      "heat, "
      "of a few light ones: without splitting the rise is that at 40 cells";
  return joined(
      {required_order("default", "density.L1", 0.8, "the jump at the start allows 1; 0.8 as of the shock tubes"),
       {energy_gate("default"),
        no_heating_gate("default", 40)
            .fails("sharpening undoes the maps' smoothing and overshoots beside the jump of the first steps: gas "
                   "just inside the edge is squeezed by two hundredths before it expands; without it the rise is a "
                   "tenth of that",
                   {1.005, 1.011}, "2026-11-21 fbef8d3"),
        no_heating_gate("default", 160).fails(spray, {1.05, 1.4}, "2026-11-26 0c29d45"),
        no_heating_gate("default", 320).in(Tier::full).fails(spray, {1.1, 1.45}, "2026-11-26 0c29d45"),
        restart_gate("default", "runs that split points", {{"split", 0.2}})}});
}

Case gas_expansion() {
  return {.name = "gas-expansion",
          .kind = Kind::gas,
          .keys = Cylinder().keys(),
          .sets = {{"ppc", 4.0}, {"cells", 40.0}},
          .york1997 = york_points,
          .york_step = courant_number(0.24),  // his deck's
          .problem = gas_run(expansion_flow),
          .studies = {study("default", "default, a quarter in the plane",
                            "The start is a jump to vacuum, the rarefaction's head a kink: order 1.",
                            {40, 56, 80, 112, 160})
                          .in_full({40, 56, 80, 112, 160, 240, 320})
                          .pictured(25, 80.0)},
          .gates = gates(),
          .levels = {40, 56, 80, 112, 160}};
}
PLUMBLINE_CASE(gas_expansion);

}  // namespace
}  // namespace plumbline
