#include "cases/harness/laboratory/bar_patch.hpp"

#include <cmath>

#include "kernel/materials/linear_elastic.hpp"

namespace plumbline {
namespace {

void choose(const MapChoice& maps, Scene& scene) {
  scene.shape = maps.shape;
  scene.transfer = maps.transfer;
  scene.transfer_order = maps.transfer_order;
}

GridSpec grid_of(int dim, int cells) {
  GridSpec grid;
  grid.dim = dim;
  for (int d = 0; d < dim; ++d) grid.cells[static_cast<std::size_t>(d)] = cells;
  return grid;
}

Body bar(const std::vector<double>& places, int ppc) {
  LinearElastic law;
  law.youngs_modulus = law.density = 1;
  Body body = make_body("bar", std::make_shared<LinearElastic>(law), static_cast<int>(places.size()), 1);
  body.spacing = 1.0 / ppc;
  for (std::size_t p = 0; p < places.size(); ++p) {
    body.points(column::position)[p] = places[p];
    body.points(column::mass)[p] = body.points(column::volume)[p] = 1.0 / ppc;
  }
  return body;
}

}  // namespace

Patch bar_patch(const MapChoice& maps, int ppc, double place, const Extent& extent) {
  const int cells = extent.core + 2 * extent.margin;
  Patch patch;
  patch.scene.grid = grid_of(1, cells);
  choose(maps, patch.scene);
  patch.directions = 1;
  patch.step[0] = {1, 0, 0};
  patch.places.emplace_back();
  std::vector<double> places;
  for (int cell = 0; cell < cells; ++cell) {
    for (int k = 0; k < ppc; ++k) {
      places.push_back(cell + (k + place) / ppc);
      patch.places[0].push_back({{cell - extent.margin, 0}, k});
    }
  }
  patch.scene.bodies.push_back(bar(places, ppc));
  return patch;
}

Patch bar_edge_patch(const MapChoice& maps, int ppc, double depth, int cells, FarEnd far_end) {
  Patch patch;
  patch.scene.grid = grid_of(1, cells + 2);
  if (far_end == FarEnd::wall) patch.scene.grid.walls[0][0] = Wall::symmetry;
  choose(maps, patch.scene);
  const double last = cells + depth;
  const int count = far_end == FarEnd::free ? cells * ppc : static_cast<int>(std::ceil(last * ppc));
  std::vector<double> places;
  for (int k = 0; k < count; ++k) places.push_back(last - static_cast<double>(k) / ppc);
  patch.scene.bodies.push_back(bar(places, ppc));
  patch.places.emplace_back(places.size());
  for (std::size_t p = 0; p < places.size(); ++p) patch.places[0][p].member = static_cast<int>(p);
  return patch;
}

Patch plate_patch(const MapChoice& maps, int ppc, double place_x, double place_y, double nu, const Extent& extent) {
  const int cells = extent.core + 2 * extent.margin;
  Patch patch;
  patch.scene.grid = grid_of(2, cells);
  choose(maps, patch.scene);
  patch.directions = 2;
  patch.step = {{{1, 0, 0}, {0, 1, 0}}};
  LinearElastic law;
  law.density = 1;
  law.poissons_ratio = nu;
  law.youngs_modulus = (1 + nu) * (1 - 2 * nu) / (1 - nu);  // compression waves of speed one
  const int side = cells * ppc;
  Body body = make_body("plate", std::make_shared<LinearElastic>(law), side * side, 2);
  body.spacing = 1.0 / ppc;
  patch.places.emplace_back();
  std::size_t p = 0;
  for (int j = 0; j < side; ++j) {
    for (int i = 0; i < side; ++i, ++p) {
      body.points(column::position, 0)[p] = (i + place_x) / ppc;
      body.points(column::position, 1)[p] = (j + place_y) / ppc;
      body.points(column::mass)[p] = body.points(column::volume)[p] = 1.0 / (ppc * ppc);
      patch.places[0].push_back({{i / ppc - extent.margin, j / ppc - extent.margin}, i % ppc + ppc * (j % ppc)});
    }
  }
  patch.scene.bodies.push_back(std::move(body));
  return patch;
}

}  // namespace plumbline
