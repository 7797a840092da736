// Picks the instantiation for a scene's shape and transfer. Included only by the files that instantiate a geometry.
#pragma once

#include "kernel/mechanics_impl.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"

namespace plumbline {

template <class Geometry, class Shape>
std::unique_ptr<Engine> engine_with_shape(Scene& scene, Ledger& ledger, bool keep_loss) {
  if (scene.transfer == "pic") return std::make_unique<Mechanics<Geometry, Shape, Pic>>(scene, ledger, keep_loss);
  if (scene.transfer == "flip") return std::make_unique<Mechanics<Geometry, Shape, Flip>>(scene, ledger, keep_loss);
  if (scene.transfer == "apic") return std::make_unique<Mechanics<Geometry, Shape, Apic>>(scene, ledger, keep_loss);
  return nullptr;
}

template <class Geometry>
std::unique_ptr<Engine> engine_of(Scene& scene, Ledger& ledger, bool keep_loss) {
  if (scene.shape == "linear") return engine_with_shape<Geometry, Linear>(scene, ledger, keep_loss);
  if (scene.shape == "quadratic") return engine_with_shape<Geometry, Quadratic>(scene, ledger, keep_loss);
  if (scene.shape == "cubic") return engine_with_shape<Geometry, Cubic>(scene, ledger, keep_loss);
  return nullptr;
}

}  // namespace plumbline
