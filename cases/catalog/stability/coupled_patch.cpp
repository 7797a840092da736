#include "cases/catalog/stability/coupled_patch.hpp"

#include <cmath>

#include "cases/catalog/coupled/membrane.hpp"
#include "cases/catalog/membrane/string.hpp"
#include "cases/catalog/stability/gas_patch.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/files/whole.hpp"

namespace plumbline {
namespace {

void number_members(Patch& patch) {
  for (const Body& body : patch.scene.bodies) {
    patch.places.emplace_back(body.id.size());
    for (std::size_t p = 0; p < body.id.size(); ++p) patch.places.back()[p].member = static_cast<int>(p);
  }
}

Body box_of_gas(const Settings& settings, int width, int height) {
  const int per_cell = whole(std::round(std::sqrt(settings.number("ppc"))));
  const int across = width * per_cell, up = height * per_cell;
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

// Every point stands in the middle of its share, so that none is on a wall, and has the mass of its share.
Body membrane_across(const Settings& settings, const CoupledCell& cell, int width, int height) {
  MembraneMaterial material;
  material.thickness = 1;
  material.youngs_modulus = cell.stiffness_ratio;
  material.density = cell.density_ratio;
  material.one_way = false;
  const int points = width * settings.integer("membrane.ppc");
  const double y = height / 2 + cell.place, half = 0.5 * width / points;
  const bool segments = settings.text("membrane.strain") == "segments";
  const Curve line = segments ? evenly({{half, y}, {width - half, y}}, points - 1)
                              : evenly({{0, y}, {static_cast<double>(width), y}}, points);
  Body body = membrane_body(settings, "membrane", material, line);
  for (int p = 0; p < points; ++p) {
    body.points(column::volume)[p] = 2 * half;
    body.points(column::mass)[p] = 2 * half * cell.density_ratio;
  }
  return body;
}

Body line_of_gas(const Settings& settings, int cells) {
  const int per_cell = settings.integer("ppc"), count = cells * per_cell;
  Body body = make_body("gas", gas_material(settings, 0, Side::closing, false), count, 1);
  for (std::size_t p = 0; p < static_cast<std::size_t>(count); ++p) {
    body.points(column::position)[p] = (static_cast<double>(p) + 0.5) / per_cell;
    put_gas(body.points, p, 1.0 / per_cell);
  }
  return body;
}

Body membrane_along(const Settings& settings, const CoupledCell& cell, int cells) {
  const int per_cell = settings.integer("membrane.ppc");
  const double spacing = 1.0 / per_cell, from = cell.place * spacing;
  const StringState state = straight_string({from, 0}, {from + cells - spacing, 0}, cells * per_cell);
  const StringMaterial material{
      .youngs_modulus = cell.stiffness_ratio, .area = 1, .density = cell.density_ratio, .one_way = false};
  return string_body("membrane", settings.text("membrane.strain"), material, state, 1, StringEnds::whole);
}

}  // namespace

Patch coupled_line_patch(const Settings& settings, const CoupledCell& cell, const Extent& extent) {
  const int cells = extent.core + 2 * extent.margin;
  const int gas_points = settings.integer("ppc"), membrane_points = settings.integer("membrane.ppc");
  Patch patch;
  patch.directions = 1;
  patch.step[0] = {1, 0, 0};
  patch.scene.grid.cells[0] = cells;
  patch.scene.grid.walls[0] = {Wall::symmetry, Wall::symmetry};
  patch.scene.bodies.push_back(line_of_gas(settings, cells));
  patch.scene.bodies.push_back(membrane_along(settings, cell, cells));
  apply_choices(settings, patch.scene);
  patch.places.resize(2);
  for (int p = 0; p < cells * gas_points; ++p) {
    patch.places[0].push_back({{p / gas_points - extent.margin, 0}, p % gas_points});
  }
  for (int p = 0; p < cells * membrane_points; ++p) {
    patch.places[1].push_back({{p / membrane_points - extent.margin, 0}, p % membrane_points});
  }
  return patch;
}

Patch coupled_box_patch(const Settings& settings, const CoupledCell& cell, int width, int height) {
  Patch patch;
  GridSpec& grid = patch.scene.grid;
  grid.dim = 2;
  grid.cells = {width, height, 1};
  for (std::size_t d = 0; d < 2; ++d) grid.walls[d] = {Wall::symmetry, Wall::symmetry};
  patch.scene.bodies.push_back(box_of_gas(settings, width, height));
  patch.scene.bodies.push_back(membrane_across(settings, cell, width, height));
  apply_choices(settings, patch.scene);
  number_members(patch);
  return patch;
}

}  // namespace plumbline
