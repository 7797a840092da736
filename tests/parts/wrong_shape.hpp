// Wrong shapes made of loops of their own.
#pragma once

#include <string>

#include "kernel/engine/loops/shape_entry.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "tests/parts/wrong_source.hpp"

namespace plumbline::wrong {

// On lines and in the plane; elsewhere, where compiling takes longer, quadratic B-splines.
template <class Shape>
ShapeEntry shape(const std::string& name, const std::string& defect) {
  ShapeEntry entry = shape_named("quadratic");
  entry.name = name;
  entry.title = defect;
  entry.source = here;
  entry.offers.clear();
  if (Shape::smooth_gradients) entry.offers.insert(Trait::smooth_gradients);
  if (Shape::fixed_inertia) entry.offers.insert(Trait::constant_inertia);
  entry.inertia = Shape::inertia(0.0);
  std::get<MakeLoops<Line>>(entry.loops) = make_loops<Shape, Line>;
  std::get<MakeLoops<Plane>>(entry.loops) = make_loops<Shape, Plane>;
  return entry;
}

}  // namespace plumbline::wrong
