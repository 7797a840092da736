// A piston pushed into gas at rest.
#include <cmath>
#include <memory>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/shock_front.hpp"
#include "cases/catalog/gas/shock_tube.hpp"
#include "cases/harness/description/parameters.hpp"
#include "cases/harness/verify/restart_gate.hpp"
#include "reference/piston_shock.hpp"

namespace plumbline::piston_shock {
namespace {

struct Piston : Parameters {
  using Parameters::Parameters;
  bool moves = one_of("frame", "laboratory", {"laboratory", "piston"},
                      "who moves: the gas towards the piston, or the piston") == "laboratory";
  reference::PistonShockProblem shock{
      .piston_velocity = within("piston_velocity", 1, "m/s", 0, 2, "speed of the piston"),
      .gamma = within("gamma", 1.4, "1", 1, 3, "ratio of specific heats")};
  double end_time = within("t_end", 0.4, "s", 0, 0.45, "end time");
};

// The pressure that is furthest from the exact one, where shock_measures() looks for the density.
double plateau_pressure(const std::vector<GasSample>& points, const ShockFront& front, double exact) {
  double furthest = std::nan("");
  for (const GasSample& p : points) {
    const double share = (p.coordinate - front.origin) / front.distance.value;
    if (share < 0.5 || share > 0.75) continue;
    if (!(std::abs(p.pressure - exact) <= std::abs(furthest - exact))) furthest = p.pressure;
  }
  return furthest;
}

GasFlow piston_flow(const Settings& settings) {
  const Piston piston(settings);
  const reference::PistonShockProblem& problem = piston.shock;
  const auto exact = std::make_shared<const reference::PistonShock>(problem);
  const double u = problem.piston_velocity;
  GasFlow flow;
  flow.gamma = problem.gamma;
  flow.end_time = piston.end_time;
  const reference::GasState start{problem.density, piston.moves ? 0 : -u, problem.pressure};
  flow.initial = [start](double) { return start; };
  if (piston.moves) {
    flow.pistons[0] = u;
    flow.space[0] = 0.05;
    flow.exact = [exact](double x, double t) { return exact->sample(x, t); };
  } else {
    flow.margin[1] = disturbed_by_wall(start, problem.gamma, flow.end_time) + 0.1;
    flow.judged = Interval{0, 1 - u * flow.end_time};
    flow.exact = [exact, u](double x, double t) {
      reference::Sample at = exact->sample(x + u * t, t);
      at.velocity = at.velocity - u;
      return at;
    };
  }
  const double h = flow.cells_along / settings.number("cells");
  flow.further = [exact, h, u, moves = piston.moves](const std::vector<GasSample>& points, double time) {
    const reference::Bounded distance = (exact->shock_speed() - u) * time;
    const ShockFront front{moves ? u * time : 0, distance, exact->ahead().density.value, exact->behind().density,
                           exact->behind().energy};
    std::vector<Measure> all = shock_measures(points, h, front);
    const reference::Bounded speed = exact->shock_speed(), pressure = exact->behind().pressure;
    all.push_back(scalar_measure("shock_speed", *all.front().value / time + u, speed.value, speed.bound, "m/s"));
    all.push_back(scalar_measure("plateau_pressure", plateau_pressure(points, front, pressure.value), pressure.value,
                                 pressure.bound, "Pa"));
    return all;
  };
  return flow;
}

std::vector<StudyPlan> studies() {
  const std::string why = "One shock, and the layer at the piston: order 1 in the mean.";
  const std::vector<double> coarse{100, 140, 200, 280, 400}, fine{100, 200, 400, 800, 1600};
  return {study("default", "default, the piston moves", why, coarse).in_full(fine),
          study("piston", "default, seen from the piston", why, coarse).with({{"frame", "piston"}}).in_full(fine)};
}

// One of the three numbers of the statement, from the points, within so much of it.
CaseGate published(const std::string& id, const std::string& measure, double value, double margin,
                   const std::string& why_margin) {
  return gate(id + "-400", value_at(measure, 400), between(value - margin, value + margin),
              literature("Rankine and Hugoniot for a piston of 1 m/s; " + why_margin));
}

// A piston is no node line. Nodes up to half a cell before it move with it, so that the gas may stand up to half a
// cell behind it; and no kernel is mirrored in it: of the density next to it points read only the share S of their
// kernel, cubic twice, that has gas under it, a volume too large by the integral of 1/S - 1, 0.488 cells.
CaseGate cut_coverage_gate(double level) {
  const double judged = 0.6, cells = 0.5 + 0.488;
  return gate("default/coverage-" + to_text(level), value_at("coverage", level),
              between(0.99, 1.01 + cells / (judged * level)),
              theory("1 % as elsewhere, and at the piston: half a cell that the gas may stand behind it, and 0.488 "
                     "cells by which volumes are overstated where kernels are cut"));
}

std::vector<CaseGate> gates() {
  constexpr double density = 2.07916, pressure = 2.92665;
  const auto of = [](const std::string& study) {
    return joined(
        {required_order(study, "density.L1", 0.8,
                        "a shock and the layer at the piston allow 1; 0.8 as of the shock tubes"),
         shock_gates(study, 400, 1.0 / 400, density),
         {// The end is at 0.4 s: a cell there is h/0.4 in the speed.
          published(study + "/speed", "shock_speed", 1.92665, 1.0 / 400 / 0.4, "one cell in the shock's place"),
          published(study + "/pressure", "plateau_pressure", pressure, 0.02 * pressure, "2 %, as of the density"),
          published(study + "/density", "plateau_density", density, 0.02 * density,
                    "2 %, as of the density behind every shock here"),
          energy_gate(study), coverage_gate(study, 400)}});
  };
  return joined(
      {of("default"),
       of("piston"),
       {coverage_gate("piston", 100), cut_coverage_gate(100), restart_gate("default", "runs with pistons that move")}});
}

Case piston_shock() {
  return {.name = "piston-shock",
          .kind = Kind::gas,
          .keys = Piston().keys(),
          .york1997 = york_points,
          .york_step = york_step,
          .problem = gas_run(piston_flow),
          .studies = studies(),
          .gates = gates(),
          .levels = {100, 200, 400, 800, 1600}};
}
PLUMBLINE_CASE(piston_shock);

}  // namespace
}  // namespace plumbline::piston_shock
