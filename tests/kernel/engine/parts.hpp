// Points on a small grid, for parts of the engine that are built without the rest of it.
#pragma once

#include "kernel/engine/layout.hpp"
#include "kernel/engine/placing.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline {

// Four cells of 0.5 m along each direction, with points of 2 kg at these places.
inline Scene points_at(const std::vector<std::array<double, 2>>& places, Wall wall = Wall::symmetry,
                       const std::string& transfer = "flip") {
  Scene scene;
  scene.grid = scenes::box(scenes::Space::plane, {4, 4, 1}, 0.5, scenes::walls_everywhere(wall));
  scene.shape = "quadratic";
  scene.transfer = transfer;
  Body body = make_body("gas", std::make_shared<IdealGas>(), static_cast<int>(places.size()), 2);
  for (int p = 0; p < body.points.points(); ++p) {
    for (int d = 0; d < 2; ++d) {
      body.points(column::position, d)[p] = places[static_cast<std::size_t>(p)][static_cast<std::size_t>(d)];
    }
    body.points(column::mass)[p] = 2;
  }
  if (transfer == "apic") body.points.add(column::affine, 4);
  scene.bodies.push_back(std::move(body));
  return scene;
}

// The points of a scene where they stand on its grid, in their order.
struct Located {
  Scene scene;
  Discretisation<Plane> space;
  Layout<2> at;

  explicit Located(Scene made) : scene(std::move(made)), space(scene, 1), at(layout_of(scene.bodies, space.grid)) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      Placing<Plane>(space).locate(scene.bodies[b], at.weights[b], false, {});
      space.touch(at.weights[b], at.field(b));
    }
    for (VelocityField<2>& field : at.fields) space.walls.include_mirrors(field.touched);
  }
  Located(const Located&) = delete;

  Body& body(std::size_t b = 0) { return scene.bodies[b]; }
  Columns& points(std::size_t b = 0) { return scene.bodies[b].points; }
  VelocityField<2>& field(std::size_t b = 0) { return at.field(b); }
  // Sum over the touched nodes of a field.
  template <class Value>
  auto sum(Value&& value) {
    auto total = value(std::size_t{0});
    total = 0 * total;
    field().for_touched(space.grid, [&](std::size_t i) { total += value(i); });
    return total;
  }
};

}  // namespace plumbline
