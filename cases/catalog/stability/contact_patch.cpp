#include "cases/catalog/stability/contact_patch.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include "kernel/materials/linear_elastic.hpp"

namespace plumbline {

Patch ContactPatch::make() const {
  Patch patch;
  GridSpec& grid = patch.scene.grid;
  grid.cells[0] = 2 * cells + 1;
  grid.walls[0] = {Wall::symmetry, Wall::symmetry};
  const double spacing = 1.0 / ppc, meet = cells + interface, away = touching ? 0 : 0.5 * distance * spacing;
  for (const double side : {-1.0, 1.0}) {
    std::vector<double> places;
    for (int k = 0; k <= 2 * cells * ppc; ++k) {
      const double x = meet + side * (away + (k + 0.5) * spacing);
      if (x > 0 && x < grid.cells[0]) places.push_back(x);
    }
    constexpr double rounding = 1e-9;  // points touch where they are nearer than their spacing
    LinearElastic law;
    law.youngs_modulus = law.density = 1;
    Body body = make_body(side < 0 ? "left" : "right", std::make_shared<LinearElastic>(law),
                          static_cast<int>(places.size()), 1);
    body.spacing = spacing * (1 + rounding);
    patch.places.emplace_back();
    for (std::size_t p = 0; p < places.size(); ++p) {
      body.points(column::position)[p] = places[p];
      body.points(column::mass)[p] = body.points(column::volume)[p] = spacing;
      body.points(column::velocity)[p] = -side * approach;
      body.points(column::strain)[p] = touching && approach == 0 ? -pressure : 0;
      patch.places.back().push_back({{}, static_cast<int>(p)});
    }
    // The point at the wall bears what of the line between its box and the wall no box bears: boxes are then at rest.
    const double wall = side < 0 ? 0 : grid.cells[0];
    body.points(column::strain)[places.size() - 1] *= std::abs(places.back() - wall) / spacing + 0.5;
    patch.scene.bodies.push_back(std::move(body));
  }
  return patch;
}

}  // namespace plumbline
