// Wrong shapes made of loops of their own.
#pragma once

#include <string>

#include "kernel/engine/loops/shape_entry.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "tests/parts/wrong_source.hpp"

namespace plumbline::wrong {

// On lines and in the plane alone: each further geometry takes seconds to compile.
template <class Shape>
ShapeEntry shape(const std::string& name, const std::string& defect) {
  ShapeEntry entry{{name, defect, here}, {make_loops<Shape, Line>, make_loops<Shape, Plane>, nullptr, nullptr}};
  if (Shape::smooth_gradients) entry.offers.insert(Trait::smooth_gradients);
  if (Shape::fixed_inertia) entry.offers.insert(Trait::constant_inertia);
  entry.inertia = Shape::inertia(0.0);
  return entry;
}

}  // namespace plumbline::wrong
