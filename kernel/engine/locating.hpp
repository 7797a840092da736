// The first stage of a step: where the points stand, and what they need to have for that.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "kernel/contact/pair_potential.hpp"
#include "kernel/engine/boxes.hpp"
#include "kernel/engine/layout.hpp"
#include "kernel/engine/placing.hpp"
#include "kernel/mechanics.hpp"
#include "kernel/normals/membrane_tangents.hpp"

namespace plumbline {

template <class Geometry>
class Locating {
 public:
  static constexpr int dim = Geometry::dim;
  using Space = Discretisation<Geometry>;
  using Bodies = Layout<dim>;

  Locating(const Space& space, const Scene& scene, const EngineOptions& options, Ledger& ledger)
      : space_(space),
        grid_(scene.grid),
        options_(options),
        placing_(space),
        tangents_(scene.normals),
        ledger_(ledger) {}

  // Of all bodies; sorting: points, but those of chains, go to the order of the bins. Throws InadmissibleState where a point
  // left the grid.
  void locate(Bodies& at, bool sorting) {
    for (auto& field : at.fields) std::fill(field.touched.begin(), field.touched.end(), std::pair<int, int>{0, 0});
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      Body& body = at.bodies[b];
      deform_boxes(space_, body.points, ledger_);
      follow_points(space_, body, ledger_);
      placing_.locate(body, at.weights[b], sorting, stale_columns(body));
      space_.touch(at.weights[b], at.field(b));
    }
    for (auto& field : at.fields) space_.walls.include_mirrors(field.touched);
    tangents_.find(grid_, at.bodies);
  }
  // The same in the order that suits the integrator: where states name points by their place these are sorted once.
  void locate(Bodies& at) {
    const bool placed = std::any_of(at.weights.begin(), at.weights.end(),
                                    [](const auto& places) { return places.bins.points() > 0; });
    locate(at, !(options_.keeps_order && placed));
  }

  // Strain rates that a step sets before it reads them are zero before its start: columns that are not sorted along.
  void clear_stale_rates(Bodies& at) const {
    for (Body& body : at.bodies) {
      const auto rates = body.points.values(column::strain_rate);
      if (options_.evaluates_stress_first) std::fill(rates.begin(), rates.end(), 0.0);
    }
  }

  // Until they are located, points of a body that has more or fewer of them than before count in the order they have.
  void forget(Bodies& at) const {
    for (std::size_t b = 0; b < at.bodies.size(); ++b) {
      Weights<dim>& places = at.weights[b];
      const int points = at.bodies[b].points.points();
      places.drop();
      places.bins_hold = false;
      if (places.bins.points() == points) continue;
      std::vector<int> alone(static_cast<std::size_t>(points));
      std::iota(alone.begin(), alone.end(), 0);
      places.bins.build(alone);
    }
  }

 private:
  // What a step sets before it reads it.
  const std::vector<ColumnId>& stale_columns(const Body& body) {
    stale_ = {column::transfer_loss, column::contact_force, column::contact_velocity};
    if (!space_.context.continuity_density) stale_.push_back(column::density);
    if (!options_.evaluates_stress_first) return stale_;
    stale_.insert(stale_.end(), {column::strain_rate, column::sound_speed, column::closing});
    if (body.material->has_density()) stale_.insert(stale_.end(), {column::stress, column::volume, column::pressure});
    return stale_;
  }

  const Space& space_;
  GridSpec grid_;
  EngineOptions options_;
  Placing<Geometry> placing_;
  MembraneTangents tangents_;
  std::vector<ColumnId> stale_;  // of one body
  Ledger& ledger_;
};

}  // namespace plumbline
