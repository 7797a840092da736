// Picks the loops for a scene's shape. Included only by the files that instantiate a geometry.
#pragma once

#include "kernel/engine/loops/survey.hpp"
#include "kernel/engine/loops/to_nodes.hpp"
#include "kernel/engine/loops/to_points.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/gimp.hpp"
#include "kernel/shapes/linear.hpp"
#include "kernel/shapes/quadratic.hpp"

namespace plumbline {

template <class Geometry>
std::unique_ptr<PointLoops<Geometry>> make_point_loops(const Scene& scene, const TransferChoice& transfer) {
  const std::string& shape = scene.shape;
  if (shape == "linear") return std::make_unique<ShapeLoops<Geometry, Linear>>(scene.grid, transfer);
  if (shape == "quadratic") return std::make_unique<ShapeLoops<Geometry, Quadratic>>(scene.grid, transfer);
  if (shape == "cubic") return std::make_unique<ShapeLoops<Geometry, Cubic>>(scene.grid, transfer);
  if (shape == "gimp" || shape == "contiguous-gimp") {
    return std::make_unique<ShapeLoops<Geometry, Gimp>>(scene.grid, transfer);
  }
  throw std::invalid_argument("no shape " + shape);
}

}  // namespace plumbline
