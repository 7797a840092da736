// What holds in every step of every scheme, on all cases that can be stepped with the integrator, and two identities of
// momentum that need nothing that a step has recorded.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cases/harness/files/signals.hpp"
#include "cases/harness/integrators/growth.hpp"
#include "cases/harness/integrators/integrator_gates.hpp"
#include "cases/harness/integrators/measured_limit.hpp"
#include "cases/harness/integrators/pairs.hpp"
#include "cases/harness/verify/verification.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {
namespace {

// A case that integrators can step, and its geometry.
struct Stepped {
  const Case* entry;
  int dim;
  bool axisymmetric;
};

// Identities hold in every step: a few steps of each case at its coarsest levels will do, and fewer where each of them costs
// many forces: then meshes of many cells are a quarter as fine.
struct Extract {
  long steps;
  std::vector<double> cells;
};
Extract extract_for(const Subject& subject, const Stepped& stepped) {
  constexpr double many_cells = 40;
  const std::vector<double> levels = stepped.entry->levels;
  const double coarsest = levels.front();
  if (subject.has_inner_solver())
    return {2, {stepped.dim == 1 && coarsest >= many_cells ? std::floor(coarsest / 4) : coarsest}};
  return {std::min(100, 800 / std::max(1, subject.traits().force_evaluations)),
          {levels.begin(), levels.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(2, levels.size()))}};
}

const std::vector<Stepped>& stepped_cases() {
  static const std::vector<Stepped> all = [] {
    std::vector<Stepped> found;
    for (const Case* entry : cases()) {
      if (!entry->trials.empty()) continue;
      const Settings settings = entry->settings("default", {{"cells", entry->levels.front()}});
      const GridSpec grid = entry->problem(settings)->unprepared().grid;
      found.push_back({entry, grid.dim, grid.axisymmetric});
    }
    return found;
  }();
  return all;
}

RunResult first_steps(const Stepped& stepped, const Subject& subject, const Settings& settings) {
  const Case& entry = *stepped.entry;
  RunResult result(entry.name, subject.name(), settings);
  const auto problem = entry.problem(settings);
  Scene scene = problem->scene();
  result.dim = scene.grid.dim;
  result.axisymmetric = scene.grid.axisymmetric;
  StepControl control = step_control(settings);
  control.parameters = subject.choice().parameters;
  if (const double limit = limit_on_oscillator(subject); limit > 0) {  // steps of cases are meant for York's limit
    const double share = std::min(1.0, limit / limit_of_york);
    control.cfl *= share;
    if (control.dt) *control.dt *= share;
  }
  try {
    Simulation run(std::move(scene), subject.name(), control);
    const double end = problem->end_time();
    const long steps = extract_for(subject, stepped).steps;
    while (run.steps() < steps && end - run.time() > 1e-12 * end) {
      throw_if_interrupted();
      run.step(end - run.time());
    }
    result.steps = run.steps();
    result.ledger = run.ledger();
    result.finished = true;
  } catch (const InadmissibleState& state) {
    result.stop = Stop{state.reason, state.body, state.field, state.step, state.time, state.point, state.value};
  }
  return result;
}

// The first steps at the coarsest levels, as a study that generic gates can read.
const StudyResult& study_of(const Stepped& stepped, const Subject& subject) {
  return subject.once<StudyResult>("identities/" + stepped.entry->name, [&] {
    for (const Trait trait : stepped.entry->needs) {
      if (subject.traits().offers.count(trait) > 0) continue;
      throw CannotWork({{trait, "case " + stepped.entry->name, "integrator " + subject.name()}});
    }
    StudyResult study;
    study.entry = stepped.entry;
    study.plan = integrator_plan(*stepped.entry, subject.name());
    study.plan.values = extract_for(subject, stepped).cells;
    for (const PlannedRun& planned : planned_runs(*stepped.entry, study.plan, Tier::quick)) {
      study.levels.push_back({planned.value, 0, first_steps(stepped, subject, planned.settings), {}});
    }
    return study;
  });
}

double momentum_along(const Scene& scene, int d, const ColumnId& of) {
  double sum = 0;
  for (const Body& body : scene.bodies) {
    for (int p = 0; p < body.points.points(); ++p) sum += body.points(column::mass)[p] * body.points(of, d)[p];
  }
  return sum;
}

// Over a step sum m x changes by dt times sum m v: of the start, the end or between. Free flight of a plate that turns: by
// how much it is off, over what sum m v itself changes in a step and rounding.
Measured centre_of_mass(const Subject& subject) {
  const SmallScene small = with_some_maps(small_scene("plate-turning"), subject.name());
  Scene scene = workable(small, subject.name());
  constexpr int steps = 20;
  const double dt = small.end / steps;
  StepControl control;
  control.dt = dt;
  control.parameters = subject.choice().parameters;
  Simulation run(std::move(scene), subject.name(), control);
  double worst = 0;
  for (int k = 0; k < steps; ++k) {
    double before[2], momentum[2], scale = 0;
    for (int d = 0; d < 2; ++d) {
      before[d] = momentum_along(run.scene(), d, column::position);
      momentum[d] = momentum_along(run.scene(), d, column::velocity);
      scale = std::max(scale, std::abs(before[d]));
    }
    run.step(dt);
    for (int d = 0; d < 2; ++d) {
      const double moved = momentum_along(run.scene(), d, column::position) - before[d];
      const double change = std::abs(momentum_along(run.scene(), d, column::velocity) - momentum[d]);
      const double rounding = 100 * std::numeric_limits<double>::epsilon() * scale;
      worst = larger(worst, std::abs(moved - dt * momentum[d]) / (dt * change + rounding));
    }
  }
  return plain(worst);
}

// Nothing is held and no wall is near: momentum changes by mass, gravity and time, over which the difference is taken, for
// dt -> 0. Velocities that stand half a step behind lack the impulse of that half.
Measured impulse(const Subject& subject) {
  const SmallScene small = with_some_maps(small_scene("plate-turning"), subject.name());
  Scene scene = workable(small, subject.name());
  scene.gravity = {0.02, -0.03, 0};
  double mass = 0;
  for (const double m : scene.bodies[0].points.values(column::mass)) mass += m;
  return measured_limit({8, 3, 8}, [&](int steps) {
    StepControl control;
    control.dt = small.end / steps;
    control.parameters = subject.choice().parameters;
    Simulation run(scene, subject.name(), control);
    for (int k = 0; k < steps; ++k) run.step(small.end);
    std::vector<double> off;
    for (int d = 0; d < 2; ++d) {
      const double given = mass * scene.gravity[static_cast<std::size_t>(d)] * small.end;
      const double change = momentum_along(run.scene(), d, column::velocity) -
                            momentum_along(scene, d, column::velocity);
      off.push_back(change / given - 1);
    }
    return off;
  });
}

}  // namespace

std::vector<IntegratorGate> identity_gates(const Subject& subject) {
  constexpr const char* beside =
      "positions or velocities are changed by another amount, or for another time, than the stages tell";
  std::vector<IntegratorGate> all{
      {"identities",
       gate_row("identities", "centre-of-mass",
                "sum m x over a step of free flight less dt sum m v, over what sum m v changes", {{}, 1.0},
                Origin::identity, "the centre of mass moves with the mean velocity of the mass"),
       beside, centre_of_mass},
      {"identities",
       gate_row("identities", "impulse", "change of momentum less the impulse of gravity, over the latter, for dt -> 0",
                {{}, most_left_over}, Origin::identity, "momentum changes by the impulse of the load alone"),
       beside, impulse}};
  all.back().gate.order = true;  // the extrapolation's interval is judged
  const int maps = subject.traits().maps;
  for (const Stepped& stepped : stepped_cases()) {
    const std::string id = "identities/" + stepped.entry->name;
    for (CaseGate& gate : generic_gates(id, stepped.dim, stepped.axisymmetric)) {
      if (gate.gate.expected.high && maps > 1) {
        *gate.gate.expected.high *= maps;
        gate.gate.reason += "; times the maps of a step, for each adds its rounding";
      }
      all.push_back(
          {"identities", std::move(gate.gate), beside,
           [&stepped, measure = std::move(gate.measure)](const Subject& s) { return measure(study_of(stepped, s)); }});
    }
  }
  return all;
}

}  // namespace plumbline
