#include "cases/catalog/estimators/exchange/given_scenes.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"

namespace plumbline {
namespace {

const std::array<const ColumnId*, 13>& filled_columns() {
  static const std::array<const ColumnId*, 13> all{
      &column::position,    &column::velocity,    &column::mass,      &column::volume,      &column::density,
      &column::energy,      &column::pressure,    &column::strain,    &column::deformation, &column::affine,
      &column::rest_length, &column::rest_radius, &column::body_force};
  return all;
}

// lambda = mu = 1 Pa, and E = 2.5 Pa on a line.
template <class Solid>
std::shared_ptr<Solid> solid_of_unit_constants() {
  auto solid = std::make_shared<Solid>();
  solid->youngs_modulus = 2.5;
  solid->poissons_ratio = 0.25;
  solid->density = 1.5;
  return solid;
}

std::shared_ptr<SegmentMembrane> given_segments(bool closed, bool revolved) {
  auto law = std::make_shared<SegmentMembrane>();
  law->youngs_modulus = 4;
  law->density = 1.5;
  law->section = 0.5;
  law->closed = closed;
  law->revolved = revolved;
  return law;
}

Body filled_body(const std::string& name, const std::shared_ptr<const Material>& material, int points,
                 const GridSpec& grid) {
  Body body = make_body(name, material, points, grid.dim, grid.axisymmetric);
  fill_columns(body, grid.dim);
  return body;
}

GridSpec given_grid(int dim, bool axisymmetric) {
  GridSpec grid;
  grid.dim = dim;
  grid.axisymmetric = axisymmetric;
  grid.h = 0.5;
  grid.cells = {8, dim > 1 ? 6 : 1, dim > 2 ? 7 : 1};
  return grid;
}

Scene scene_of_solids(int dim, bool axisymmetric) {
  Scene scene;
  scene.grid = given_grid(dim, axisymmetric);
  for (const auto& [name, solid] :
       {std::pair<const char*, std::shared_ptr<const Material>>{"small", solid_of_unit_constants<LinearElastic>()},
        {"finite", solid_of_unit_constants<NeoHookean>()}}) {
    Body body = make_body(name, solid, 3, dim, axisymmetric);
    body.points.add(column::affine, dim * dim);
    fill_columns(body, dim);
    scene.bodies.push_back(std::move(body));
  }
  return scene;
}

}  // namespace

double given_number(const ColumnId& id, int component, int point, int dim) {
  int place = 0;
  while (filled_columns()[static_cast<std::size_t>(place)]->index() != id.index()) ++place;
  const bool diagonal = component == dim * dim || component % (dim + 1) == 0;
  const double whole = id.index() != column::deformation.index() ? 1 : diagonal ? 2 : 0;
  return whole + place / 16.0 + component / 256.0 + point / 4096.0;
}

std::vector<double> given_rows(const ColumnId& id, int components, int points, int dim) {
  std::vector<double> rows;
  for (int p = 0; p < points; ++p) {
    for (int k = 0; k < components; ++k) rows.push_back(given_number(id, k, p, dim));
  }
  return rows;
}

void fill_columns(Body& body, int dim) {
  for (const ColumnId* id : filled_columns()) {
    for (int k = 0; k < body.points.components(*id); ++k) {
      for (int p = 0; p < body.points.points(); ++p) body.points(*id, k)[p] = given_number(*id, k, p, dim);
    }
  }
}

Scene plane_of_gas_and_chains() {
  Scene scene;
  scene.grid = given_grid(2, false);
  scene.grid.origin = {0.5, -0.25, 7};
  scene.grid.walls[0] = {Wall::symmetry, Wall::free};
  scene.grid.walls[1] = {Wall::no_slip, Wall::symmetry};
  scene.gravity = {0.25, -9.75, 7};
  scene.pistons = {{0, 0, 0.75, 2, 0}, {1, 1, 2.5, -1, 0.5}};
  scene.contact = "separation";
  auto law = std::make_shared<IdealGas>();
  law->gamma = 1.5;
  Body gas = make_body("gas", law, 3, 2);
  gas.points.add(column::affine, 4);
  gas.points.add(column::body_force, 2);
  fill_columns(gas, 2);
  gas.points(column::density)[0] = gas.points(column::density)[2] = 0;  // left to the density method
  gas.load = [](double time, Columns& points, std::span<const int> id) {
    for (std::size_t p = 0; p < id.size(); ++p) {
      points(column::body_force, 0)[p] = time * (1 + id[p]);
      points(column::body_force, 1)[p] = id[p] - time * time;
    }
  };
  gas.enclosure = Enclosure{"skin", {{3, 1}, {3.5, 2}}};
  scene.bodies.push_back(std::move(gas));
  scene.bodies.push_back(filled_body("skin", given_segments(false, false), 4, scene.grid));
  scene.bodies.back().field = "second";
  scene.bodies.push_back(filled_body("loop", given_segments(true, false), 3, scene.grid));
  auto layer = std::make_shared<UniaxialMembrane>();
  layer->youngs_modulus = 4;
  layer->density = 1.5;
  scene.bodies.push_back(filled_body("layer", layer, 3, scene.grid));
  return scene;
}

Scene rings_of_bands() {
  Scene scene;
  scene.grid = given_grid(2, true);
  scene.bodies.push_back(filled_body("bands", given_segments(false, true), 3, scene.grid));
  return scene;
}

Scene rings_of_solids() { return scene_of_solids(2, true); }

Scene space_of_solids() {
  Scene scene = scene_of_solids(3, false);
  scene.bodies.front().load = [](double, Columns& points, std::span<const int>) {
    points(column::body_force, 1)[0] = points(column::position, 2)[1];
  };
  Body& body = scene.bodies.back();
  body.points.add(column::body_force, 3);
  fill_columns(body, 3);
  return scene;
}

// Loads that are there in the middle of the time alone, and the same for a body that moves as a whole.
Scene line_of_solids() {
  Scene scene;
  scene.grid = given_grid(1, false);
  const auto add = [&](const std::string& name, const ColumnId& asks) {
    Body body = filled_body(name, solid_of_unit_constants<LinearElastic>(), 3, scene.grid);
    body.load = [asks](double time, Columns& points, std::span<const int>) {
      const double apart = points(asks)[1] - points(asks)[0] + points(asks)[2] - points(asks)[0];
      for (int p = 0; p < points.points(); ++p) points(column::body_force)[p] = time == 1 ? apart : 0;
    };
    scene.bodies.push_back(std::move(body));
  };
  add("by_place", column::position);
  add("by_speed", column::velocity);
  return scene;
}

}  // namespace plumbline
