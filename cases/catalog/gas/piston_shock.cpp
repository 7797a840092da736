// A piston pushed into gas at rest.
#include "reference/piston_shock.hpp"

#include <cmath>
#include <memory>

#include "cases/catalog/gas/gas_case.hpp"
#include "cases/catalog/gas/shock_front.hpp"
#include "cases/catalog/gas/shock_tube.hpp"
#include "cases/harness/verify/restart_gate.hpp"

namespace plumbline {
namespace {

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
  const reference::PistonShockProblem problem{settings.number("piston_velocity"), 1, 1, settings.number("gamma")};
  const auto exact = std::make_shared<const reference::PistonShock>(problem);
  const double u = problem.piston_velocity;
  const bool moving = settings.text("frame") == "laboratory";
  GasFlow flow;
  flow.gamma = problem.gamma;
  flow.end_time = settings.number("t_end");
  if (moving) {
    flow.pistons[0] = u;
    flow.space[0] = 0.05;
    flow.initial = [problem](double) { return reference::GasState{problem.density, 0, problem.pressure}; };
    flow.exact = [exact](double x, double t) { return exact->sample(x, t); };
  } else {
    const reference::GasState stream{problem.density, -u, problem.pressure};
    flow.margin[1] = disturbed_by_wall(stream, problem.gamma, flow.end_time) + 0.1;
    flow.judged = Interval{0, 1 - u * flow.end_time};
    flow.initial = [stream](double) { return stream; };
    flow.exact = [exact, u](double x, double t) {
      reference::Sample at = exact->sample(x + u * t, t);
      at.velocity = at.velocity - u;
      return at;
    };
  }
  const double h = flow.cells_along / settings.number("cells");
  flow.further = [exact, h, u, moving](const std::vector<GasSample>& points, double time) {
    const reference::Bounded distance = (exact->shock_speed() - u) * time;
    const ShockFront front{moving ? u * time : 0, distance, exact->ahead().density.value, exact->behind().density,
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

class PistonShock final : public Case {
 public:
  std::string name() const override { return "piston-shock"; }

  Kind kind() const override { return Kind::gas; }

  std::vector<Key> keys() const override {
    return {{.name = "frame",
             .value = "laboratory",
             .choices = {"laboratory", "piston"},
             .description = "who moves: the gas towards the piston, or the piston"},
            {.name = "piston_velocity",
             .value = 1.0,
             .unit = "m/s",
             .low = 0,
             .high = 2,
             .low_open = true,
             .description = "speed of the piston"},
            {.name = "gamma",
             .value = 1.4,
             .low = 1,
             .high = 3,
             .low_open = true,
             .description = "ratio of specific heats"},
            {.name = "t_end",
             .value = 0.4,
             .unit = "s",
             .low = 0,
             .high = 0.45,
             .low_open = true,
             .description = "end time"}};
  }

  std::vector<Override> points_and_end(const std::string& scheme) const override { return york_points(scheme); }
  void derive(Settings& settings, const std::string& scheme) const override { york_step(settings, scheme); }
  std::unique_ptr<Problem> problem(const Settings& settings) const override {
    return gas_problem(piston_flow(settings), settings);
  }
  std::vector<double> default_levels() const override { return {100, 200, 400, 800, 1600}; }

  std::vector<StudyPlan> studies() const override {
    const std::string why = "One shock, and the layer at the piston: order 1 in the mean.";
    const std::vector<double> coarse{100, 140, 200, 280, 400}, fine{100, 200, 400, 800, 1600};
    return {{.id = "default", .title = "default, the piston moves", .why = why, .values = coarse, .full_values = fine},
            {.id = "piston",
             .title = "default, seen from the piston",
             .why = why,
             .overrides = {{"frame", "piston"}},
             .values = coarse,
             .full_values = fine}};
  }

  std::vector<CaseGate> gates() const override {
    std::vector<CaseGate> all;
    const auto add = [&](std::vector<CaseGate> more) { all.insert(all.end(), more.begin(), more.end()); };
    for (const char* study : {"default", "piston"}) {
      add(required_order(study, "density.L1", 0.8,
                         "a shock and the layer at the piston allow 1; 0.8 as of the shock tubes"));
      add(shock_gates(study, 400, 1.0 / 400, 2.07916));
      add(published_gates(study));
      add({energy_gate(study), coverage_gate(study, 400)});
    }
    add({coverage_gate("piston", 100), cut_coverage_gate(100), restart_gate("default", "runs with pistons that move")});
    return all;
  }

 private:
  // The three numbers of the statement, from the points. The end is at 0.4 s: a cell there is h/0.4 in the speed.
  static std::vector<CaseGate> published_gates(const std::string& study) {
    const auto gate = [&](const char* measure, const char* id, double value, double room, const std::string& why) {
      return value_gate(study, measure, 400,
                        declare(study + "/" + id + "-400", {value - room, value + room}, Origin::literature, why));
    };
    return {gate("shock_speed", "speed", 1.92665, 1.0 / 400 / 0.4,
                 "Rankine and Hugoniot for a piston of 1 m/s; one cell in the shock's place"),
            gate("plateau_pressure", "pressure", 2.92665, 0.02 * 2.92665,
                 "Rankine and Hugoniot for a piston of 1 m/s; 2 %, as of the density"),
            gate("plateau_density", "density", 2.07916, 0.02 * 2.07916,
                 "Rankine and Hugoniot for a piston of 1 m/s; 2 %, as of the density behind every shock here")};
  }

  // A piston is no node line. Nodes up to half a cell before it move with it, so that the gas may stand up to half a
  // cell behind it; and no kernel is mirrored in it: of the density next to it points read only the share S of their
  // kernel, cubic twice, that has gas under it, a volume too large by the integral of 1/S - 1, 0.488 cells.
  static CaseGate cut_coverage_gate(double level) {
    const double judged = 0.6, cells = 0.5 + 0.488;
    return value_gate(
        "default", "coverage", level,
        declare("default/coverage-" + to_text(level), {0.99, 1.01 + cells / (judged * level)}, Origin::theory,
                "1 % as elsewhere, and at the piston: half a cell that the gas may stand behind it, and "
                "0.488 cells by which volumes are overstated where kernels are cut"));
  }
};

PLUMBLINE_CASE(PistonShock);

}  // namespace
}  // namespace plumbline
