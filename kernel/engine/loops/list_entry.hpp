// The entry of a shape that lists its nodes, for every geometry. Included only by the source file of such a shape.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "kernel/engine/loops/list_loops.hpp"
#include "kernel/register_part.hpp"
#include "kernel/shapes/shape.hpp"

namespace plumbline {

template <template <int> class Shape, class Geometry>
std::unique_ptr<PointLoops<Geometry>> make_list_loops(const GridSpec& grid, const Transfer& transfer) {
  constexpr int dim = Geometry::dim;
  return std::make_unique<ListLoops<Geometry>>(
      grid, transfer,
      +[](const Grid<dim>& on) -> std::unique_ptr<const ListedShape<dim>> { return std::make_unique<Shape<dim>>(on); });
}

// Shape<dim>: a ListedShape<dim> made of a Grid<dim>. offers: Trait::smooth_gradients or nothing.
template <template <int> class Shape>
ShapeEntry list_entry(std::string name, std::string title, std::string source, Traits offers = {}) {
  return {{std::move(name), std::move(title), std::move(source), std::move(offers)},
          {make_list_loops<Shape, Line>, make_list_loops<Shape, Plane>, make_list_loops<Shape, Axisymmetric>,
           make_list_loops<Shape, Solid>}};
}

}  // namespace plumbline
