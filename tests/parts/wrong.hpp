// What wrong parts are made with. Each stands in a file of its own that registers it, as a plug-in would; its title is the defect.
#pragma once

#include <string>

#include "kernel/engine/loops/shape_entry.hpp"
#include "kernel/shapes/quadratic.hpp"

namespace plumbline::wrong {

inline const char* const here = "tests/parts";  // what stands as source of a part that nobody has published

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
