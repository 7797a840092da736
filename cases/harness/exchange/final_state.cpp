#include "cases/harness/exchange/final_state.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "cases/harness/run/experiment.hpp"

namespace plumbline {
namespace {

// What a body's points must carry for the engine to look at them before they are replaced.
const std::array<ColumnId, 11>& state_columns() {
  static const std::array<ColumnId, 11> all{column::position, column::velocity,    column::mass,     column::volume,
                                            column::density,  column::energy,      column::pressure, column::strain,
                                            column::stress,   column::deformation, column::tangent};
  return all;
}

// As many points as are wanted, each standing where some point of the scene does: the engine never sees others.
Body stand_ins(const Body& own, int points, const GridSpec& grid) {
  Body body = make_body(own.name, own.material, points, grid.dim, grid.axisymmetric);
  body.field = own.field;
  body.spacing = own.spacing;
  for (const ColumnId& id : state_columns()) {
    const int components = own.points.components(id);
    if (components == 0) continue;
    body.points.add(id, components);
    for (int k = 0; k < components; ++k) {
      for (int p = 0; p < points; ++p) body.points(id, k)[p] = own.points(id, k)[p % own.points.points()];
    }
  }
  return body;
}

// Some of the points at the start, in the order of their numbers.
HandedIn first_points(const Body& body, int most) {
  HandedIn some{std::min(most, body.points.points()), Columns(0)};
  some.columns = Columns(some.points);
  for (const ColumnId& id : state_columns()) {
    const int components = body.points.components(id);
    if (components == 0) continue;
    some.columns.add(id, components);
    for (int k = 0; k < components; ++k) std::copy_n(body.points(id, k), some.points, some.columns(id, k));
  }
  return some;
}

}  // namespace

std::string why_not_scored(const Case& entry, const Settings& settings) {
  if (!entry.trials.empty()) return "its trials have no points";
  if (entry.kind == Kind::membrane || entry.kind == Kind::coupled) return "points of membranes cannot be handed in";
  const auto problem = entry.problem(settings);
  const bool judged = dynamic_cast<const JudgedAtEnd*>(problem.get());
  return judged ? "" : "its measures are made of what happens on the way, not of the final state";
}

std::unique_ptr<Simulation> simulation_of(const Problem& problem, const Settings& settings,
                                          const std::vector<HandedIn>& bodies, double time) {
  Scene scene = problem.scene();
  scene.split = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    scene.bodies[b] = stand_ins(scene.bodies[b], bodies[b].points, scene.grid);
  }
  auto simulation = std::make_unique<Simulation>(std::move(scene), settings.text("integrator"), step_control(settings));
  Checkpoint state = simulation->save();
  state.step_limit.reset();
  state.time = time;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    std::iota(state.ids[b].begin(), state.ids[b].end(), 0);
    for (const ColumnId& id : state_columns()) {
      if (!bodies[b].columns.has(id)) continue;
      const auto from = bodies[b].columns.values(id);
      std::copy(from.begin(), from.end(), state.points[b].values(id).begin());
    }
  }
  simulation->restore(state);
  return simulation;
}

std::vector<Measure> measures_to_be_judged(const Problem& problem, const Settings& settings) {
  std::vector<HandedIn> own;
  const Scene scene = problem.scene();
  for (const Body& body : scene.bodies) own.push_back(first_points(body, 16));
  return measures_at_end(problem, *simulation_of(problem, settings, own, problem.end_time()));
}

}  // namespace plumbline
