#include "cases/stability/coupled_patch.hpp"

#include <cmath>

#include "cases/coupled/membrane.hpp"
#include "cases/harness/schemes.hpp"
#include "cases/stability/gas_patch.hpp"

namespace plumbline {
namespace {

Body gas_body(const Settings& settings, const CoupledCell& cell) {
  const int per_cell = static_cast<int>(std::lround(std::sqrt(settings.number("ppc"))));
  const int across = cell.width * per_cell, up = cell.height * per_cell;
  Body body = make_body("gas", gas_material(settings, 0, Side::closing, false), across * up, 2);
  std::size_t p = 0;
  for (int j = 0; j < up; ++j) {
    for (int i = 0; i < across; ++i, ++p) {
      body.points(column::position, 0)[p] = (i + 0.5) / per_cell;
      body.points(column::position, 1)[p] = (j + 0.5) / per_cell;
      put_gas(body.points, p, 1.0 / (per_cell * per_cell));
    }
  }
  return body;
}

Body straight_membrane(const Settings& settings, const CoupledCell& cell) {
  MembraneMaterial material;
  material.thickness = 1;
  material.youngs_modulus = cell.stiffness_ratio;
  material.density = cell.density_ratio * (1 + cell.strain);  // of the unstretched membrane
  const double height = cell.height / 2 + cell.place;
  const Curve line = evenly({{0, height}, {static_cast<double>(cell.width), height}},
                            cell.width * settings.integer("membrane.ppc"));
  return membrane_body(settings, "membrane", material, line, cell.strain);
}

}  // namespace

Patch coupled_patch(const Settings& settings, const CoupledCell& cell) {
  Patch patch;
  GridSpec& grid = patch.scene.grid;
  grid.dim = 2;
  grid.cells = {cell.width, cell.height, 1};
  for (std::size_t d = 0; d < 2; ++d) grid.walls[d] = {Wall::symmetry, Wall::symmetry};
  patch.scene.bodies.push_back(gas_body(settings, cell));
  patch.scene.bodies.push_back(straight_membrane(settings, cell));
  apply_choices(settings, patch.scene);
  for (const Body& body : patch.scene.bodies) {
    patch.places.emplace_back(body.id.size());
    for (std::size_t p = 0; p < body.id.size(); ++p) patch.places.back()[p].member = static_cast<int>(p);
  }
  return patch;
}

}  // namespace plumbline
