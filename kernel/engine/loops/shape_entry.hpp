// The loops of a shape for every geometry. Included only by the source file of a shape, which instantiates them.
#pragma once

#include "kernel/engine/loops/places.hpp"
#include "kernel/engine/loops/survey.hpp"
#include "kernel/engine/loops/to_nodes.hpp"
#include "kernel/engine/loops/to_points.hpp"
#include "kernel/engine/loops/values.hpp"
#include "kernel/register_part.hpp"
#include "kernel/shapes/shape.hpp"

namespace plumbline {

template <class Shape, class Geometry>
std::unique_ptr<PointLoops<Geometry>> make_loops(const GridSpec& grid, const Transfer& transfer) {
  return std::make_unique<ShapeLoops<Geometry, Shape>>(grid, transfer);
}

// A shape that is a product of functions of one coordinate; see kernel/shapes/quadratic.hpp for what Shape has.
template <class Shape>
ShapeEntry shape_entry(std::string name, std::string title, std::string source) {
  ShapeEntry entry{
      {std::move(name), std::move(title), std::move(source)},
      {make_loops<Shape, Line>, make_loops<Shape, Plane>, make_loops<Shape, Axisymmetric>, make_loops<Shape, Solid>}};
  if (Shape::smooth_gradients) entry.offers.insert(Trait::smooth_gradients);
  if (Shape::fixed_inertia) entry.offers.insert(Trait::constant_inertia);
  if constexpr (Shape::boxes) {
    entry.inertia = Shape::inertia(0.0, Shape::usual_half);
  } else {
    entry.inertia = Shape::inertia(0.0);
  }
  entry.boxes = Shape::boxes;
  entry.flows = FlowingShape<Shape>;
  entry.lanes = lanes;
  return entry;
}

}  // namespace plumbline
