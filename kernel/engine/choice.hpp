// Picks the instantiation for a scene's shape and transfer. Included only by the files that instantiate a geometry.
#pragma once

#include "kernel/engine/coupling.hpp"
#include "kernel/engine/locate.hpp"
#include "kernel/engine/method_of_lines.hpp"
#include "kernel/engine/strain.hpp"
#include "kernel/engine/survey.hpp"
#include "kernel/engine/to_grid.hpp"
#include "kernel/engine/to_points.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/gimp.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"

namespace plumbline {

template <class Geometry, class Shape>
std::unique_ptr<Engine> engine_with_shape(Scene& scene, Ledger& ledger, const EngineOptions& options) {
  if (transfer_choice(scene.transfer, scene.transfer_order).affine) {
    return std::make_unique<Mechanics<Geometry, Shape, Affine>>(scene, ledger, options);
  }
  return std::make_unique<Mechanics<Geometry, Shape, Plain>>(scene, ledger, options);
}

template <class Geometry>
std::unique_ptr<Engine> engine_of(Scene& scene, Ledger& ledger, const EngineOptions& options) {
  if (scene.shape == "linear") return engine_with_shape<Geometry, Linear>(scene, ledger, options);
  if (scene.shape == "quadratic") return engine_with_shape<Geometry, Quadratic>(scene, ledger, options);
  if (scene.shape == "cubic") return engine_with_shape<Geometry, Cubic>(scene, ledger, options);
  if (scene.shape == "gimp" || scene.shape == "contiguous-gimp") {
    return engine_with_shape<Geometry, Gimp>(scene, ledger, options);
  }
  return nullptr;
}

}  // namespace plumbline
