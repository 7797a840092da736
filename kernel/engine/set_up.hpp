// Set-up of an engine, and the stage that finds where points stand.
#pragma once

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "kernel/engine/boxes.hpp"
#include "kernel/engine/mechanics.hpp"
#include "kernel/shapes/shape.hpp"

namespace plumbline {

template <class G>
Mechanics<G>::Mechanics(Scene& scene, Ledger& ledger, const EngineOptions& options)
    : scene_(scene),
      ledger_(ledger),
      options_(options),
      space_(scene, threads_for(scene, options)),
      layout_(layout_of(scene.bodies, space_.grid)),
      placing_(space_),
      momentum_(space_, scene, layout_.field_of_body),
      densities_(space_, scene.density),
      chains_(space_, scene.chain_relaxation, scene.strain_smoothing),
      reflection_(space_),
      filter_(space_),
      loss_to_gas_(space_, scene.loss_to_gas && options.keep_loss),
      tangents_(scene.normals) {
  refuse_what_cannot_work(scene, space_);
  add_columns();
}

template <class G>
int Mechanics<G>::threads_for(const Scene& scene, const EngineOptions& options) {
  long points = 0;
  for (const Body& body : scene.bodies) points += body.points.points();
  return points < fewest_shared ? 1 : options.threads;
}

template <class G>
void Mechanics<G>::add_columns() {
  for (std::size_t b = 0; b < bodies(); ++b) {
    Body& body = scene_.bodies[b];
    const bool gives_loss = loss_to_gas_.gives(body, field_of(b));
    if (space_.transfer.affine) body.points.add(column::affine, dim * dim);
    if (space_.shape.boxes) add_boxes<G>(body, shape_named(scene_.shape).boxes_deform);
    if (gives_loss || (options_.keep_loss && body.material->takes_heat())) body.points.add(column::transfer_loss);
    if (gives_loss) body.points.add(column::kept_loss);
  }
}

template <class G>
MaterialContext Mechanics<G>::context(double ahead) const {
  return {dim,
          space_.grid.h(),
          scene_.density == DensityMethod::continuity,
          ahead,
          scene_.density == DensityMethod::grid,
          tangents_.given()};
}

template <class G>
auto Mechanics<G>::nodal(const Field& field, NodalVelocity which) const -> const std::vector<Vec>& {
  switch (which == NodalVelocity::current ? current_ : which) {
    case NodalVelocity::end:
      return field.end;
    case NodalVelocity::midpoint:
      return field.midpoint;
    case NodalVelocity::remapped:
      return field.remapped;
    default:
      return field.start;
  }
}

// Without its weights a stage would read and write anywhere.
template <class G>
void Mechanics<G>::want_places(const char* stage) const {
  if (std::all_of(layout_.weights.begin(), layout_.weights.end(), [](const auto& at) { return at.known(); })) return;
  throw std::logic_error(std::string(stage) + " wants the points located: locate_points comes first");
}

// Points carry what the maps take only for integrators that were seen to give it back.
template <class G>
void Mechanics<G>::want_losses(const char* stage) const {
  for (const Body& body : scene_.bodies) {
    if (!body.material->takes_heat() || body.points.has(column::transfer_loss)) continue;
    throw std::logic_error(std::string(stage) +
                           " is called first in a later step than those that tell the integrator's traits");
  }
}

// What a step sets before it reads it.
template <class G>
std::vector<ColumnId> Mechanics<G>::stale_columns(const Body& body) const {
  std::vector<ColumnId> stale{column::transfer_loss};
  if (scene_.density != DensityMethod::continuity) stale.push_back(column::density);
  if (!options_.evaluates_stress_first) return stale;
  stale.push_back(column::strain_rate);
  if (body.material->has_density()) stale.insert(stale.end(), {column::stress, column::volume, column::pressure});
  return stale;
}

template <class G>
void Mechanics<G>::locate_points() {
  for (Field& field : layout_.fields) {
    std::fill(field.touched.begin(), field.touched.end(), std::pair<int, int>{0, 0});
  }
  for (std::size_t b = 0; b < bodies(); ++b) {
    Body& body = scene_.bodies[b];
    deform_boxes(space_, body.points, ledger_);
    follow_points(space_, body, ledger_);
    placing_.locate(body, layout_.weights[b], sorting_, stale_columns(body));
    space_.touch(layout_.weights[b], field_of(b));
  }
  for (Field& field : layout_.fields) space_.walls.include_mirrors(field.touched);
  step_ = {};
  forces_.reset();
  rate_of_.reset();
  strained_ = {};
  load_ahead_ = 0;
  tangents_.find(scene_.grid, scene_.bodies);
}

// Until they are located, points of a body that has more or fewer of them than before count in the order they have.
template <class G>
void Mechanics<G>::points_added() {
  survey_.reset();
  for (std::size_t b = 0; b < bodies(); ++b) {
    Weights<dim>& at = layout_.weights[b];
    const int points = scene_.bodies[b].points.points();
    at.drop();
    at.bins_hold = false;
    if (at.bins.points() == points) continue;
    std::vector<int> alone(static_cast<std::size_t>(points));
    std::iota(alone.begin(), alone.end(), 0);
    placing_.build(alone, at, false);
  }
}

template <class G>
void Mechanics<G>::initialise() {
  survey_.reset();
  for (Body& body : scene_.bodies) {
    if (!options_.evaluates_stress_first) continue;
    const auto rates = body.points.values(column::strain_rate);  // of points as they stood before they were sorted
    std::fill(rates.begin(), rates.end(), 0.0);
  }
  locate_points();
  map_mass_and_momentum();
  rate_of_ = NodalVelocity::start;  // the rates that the points carry serve
  step_.map_loss = 0;
  evaluate_stress(NodalVelocity::start);
  for (Body& body : scene_.bodies) body.material->describe(body.points);
}

template <class G>
void Mechanics<G>::refresh_density() {
  initialise();
}

}  // namespace plumbline
