// York's gas expansion: a uniform cylinder of gas let go into a vacuum.
#include <algorithm>
#include <cmath>
#include <memory>

#include "cases/catalog/gas/expansion_watch.hpp"
#include "cases/catalog/gas/fill_ball.hpp"
#include "cases/catalog/gas/flip_beside.hpp"
#include "cases/catalog/gas/gas_case.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/verify/restart_gate.hpp"
#include "reference/converged_gas.hpp"

namespace plumbline::gas_expansion {
namespace {

constexpr double york_cells = 40;        // his mesh [York 4.2]
constexpr double deck_courant = 0.24;    // by the speed of sound at the start, on the mesh of his deck [York A.4.2]
constexpr double courant_digit = 0.005;  // half of its last

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
  if (cylinder.geometry.name == "plane" && settings.number("cells") == york_cells) {
    const reference::GasState gas = flow.initial(0);
    const double sound = std::sqrt(flow.gamma * gas.pressure / gas.density);
    compare_with_flip(flow, static_cast<int>(std::ceil(flow.high[0] / h - 1e-9)), h, deck_courant * h / sound,
                      courant_digit / deck_courant);
  }
  return flow;
}

// A measure of a run over another of the same.
Number over(const std::string& measure, const std::string& other) {
  return number_at(
      measure + " over " + other + " at 40", measure, york_cells,
      [other](const RunResult& run, const Measure& of) { return Measured::of(*of.value / *run.find(other)->value); });
}

// What York says of FLIP beside his points and can be asked of others.
std::vector<CaseGate> flip_gates(const std::string& study) {
  const Because within_a_cell = requirement(
      "York, p. 40, finds reasonable agreement with implicit FLIP in Figs. 17 and 18: as near to each other as the "
      "exact "
      "solution is to itself a cell further on, all that the mesh resolves");
  return {
      gate(study + "/scatters-less-than-explicit-flip", over("scatter", "explicit_flip_scatter"), at_most(0.99),
           literature("York, p. 40, of Fig. 16: it is the points of explicit FLIP that are scattered and bunched; a "
                      "hundredth, for one without any effect, with whichever step rounds to his Courant number")),
      gate(study + "/flip-pressure", value_at("implicit_flip_pressure", york_cells), at_most(1), within_a_cell),
      gate(study + "/flip-energy", value_at("implicit_flip_energy", york_cells), at_most(1), within_a_cell)};
}

std::vector<CaseGate> gates() {
  const std::string spray =
      "on fine meshes points at the edge of vacuum are split, and the motion of the halves among each other becomes "
      "heat, "
      "of a few light ones: without splitting the rise is that at 40 cells";
  return joined(
      {flip_gates("york1997"),
       flip_gates("default"),
       {gate("york1997/nearest-to-implicit-flip", over("from_implicit_flip", "from_explicit_flip"), at_most(0.99),
             literature(
                 "York, p. 40, of Fig. 16: his points agree most closely with those of implicit FLIP; a hundredth, "
                 "for one without any effect, with whichever step rounds to his Courant number")),
        gate("york1997/unheated", value_at("energy_ratio", york_cells), at_most(260.0 / 250),
             literature(
                 "Fig. 18: contours of MPM are marked 240 and less where the gas starts with 250; 260 would be the "
                 "next mark")),
        gate("york1997/flip-heats", value_at("implicit_flip_hottest", york_cells), at_least(260.0 / 250),
             literature(
                 "Fig. 18: contours of implicit FLIP are marked 260 to 320 where the gas starts with 250, those of "
                 "MPM not above 240; 260 is the first mark above the start"))},
       required_order("default", "density.L1", 0.8, "the jump at the start allows 1; 0.8 as of the shock tubes"),
       {energy_gate("default"),
        no_heating_gate("default", 40)
            .fails("sharpening undoes the maps' smoothing and overshoots beside the jump of the first steps: gas "
                   "just inside the edge is squeezed by two hundredths before it expands; without it the rise is a "
                   "tenth of that",
                   {1.005, 1.011}, "2026-11-21 fbef8d3"),
        no_heating_gate("default", 160).fails(spray, {1.2, 1.6}, "2026-11-30 2b748617"),
        no_heating_gate("default", 320).in(Tier::full).fails(spray, {1.25, 1.65}, "2026-11-30 2b748617"),
        restart_gate("default", "runs that split points", {{"split", 0.2}})}});
}

Case gas_expansion() {
  return {.name = "gas-expansion",
          .kind = Kind::gas,
          .keys = Cylinder().keys(),
          .sets = {{"ppc", 4.0}, {"cells", 40.0}},
          .york1997 = york_points,
          .york_step = courant_number(deck_courant),
          .problem = gas_run(expansion_flow),
          .studies = {study("york1997", "York's points on his mesh", "One mesh, that of Figs. 16 to 18.", {40})
                          .of_york()
                          .pictured(2),
                      study("default", "default, a quarter in the plane",
                            "The start is a jump to vacuum, the rarefaction's head a kink: order 1.",
                            {40, 56, 80, 112, 160})
                          .in_full({40, 56, 80, 112, 160, 240, 320})
                          .pictured(25, 80.0)},
          .gates = gates(),
          .levels = {40, 56, 80, 112, 160}};
}
PLUMBLINE_CASE(gas_expansion);

}  // namespace
}  // namespace plumbline::gas_expansion
