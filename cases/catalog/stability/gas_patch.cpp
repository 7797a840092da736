#include "cases/catalog/stability/gas_patch.hpp"

#include <algorithm>
#include <cmath>

#include "cases/harness/description/schemes.hpp"
#include "cases/harness/files/whole.hpp"

namespace plumbline {
namespace {

constexpr int braking_cells = 4;

// Points of one line of the lattice: where they stand, in cells from the first cell, in which cell, and as which.
struct LinePoint {
  double place;
  int cell, member;
};

std::vector<LinePoint> line_points(int cells, int per_cell, double offset) {
  std::vector<LinePoint> all;
  // A lattice shifted by one spacing is the lattice.
  const double shift = std::fmod(offset + 0.5 / per_cell, 1.0 / per_cell);
  for (int cell = 0; cell < cells; ++cell) {
    for (int k = 0; k < per_cell; ++k) all.push_back({cell + static_cast<double>(k) / per_cell + shift, cell, k});
  }
  return all;
}

}  // namespace

std::shared_ptr<const IdealGas> gas_material(const Settings& settings, double viscosity, Side side, bool quadratic) {
  auto gas = std::make_shared<IdealGas>();
  gas->gamma = gas_gamma;
  gas->viscosity = viscosity;
  const double linear = settings.number("viscosity.linear");
  if (side == Side::both) gas->viscosity_linear = linear;
  if (side == Side::closing) gas->viscosity += 0.75 * linear;
  if (quadratic) gas->viscosity_quadratic = settings.number("viscosity.quadratic");
  return gas;
}

void put_gas(Columns& points, std::size_t p, double volume) {
  points(column::volume)[p] = points(column::mass)[p] = volume;
  points(column::density)[p] = 1;
  points(column::energy)[p] = gas_energy;
}

namespace {

// The velocity of the lattice, which the walls at 0 and `cells` stop.
double velocity_at(const GasLattice& lattice, double x, int cells) {
  const double share = std::min({1.0, x / braking_cells, (cells - x) / braking_cells});
  return -share * lattice.compression * (x - 0.5 * cells);
}

void set_in_motion(const GasLattice& lattice, int cells, bool affine, Body& body) {
  if (affine) body.points.add(column::affine, lattice.dim * lattice.dim);
  for (int d = 0; d < lattice.dim; ++d) {
    const double* x = body.points(column::position, d);
    for (std::size_t p = 0; p < body.id.size(); ++p) {
      body.points(column::velocity, d)[p] = velocity_at(lattice, x[p], cells);
      if (affine) body.points(column::affine, d * lattice.dim + d)[p] = -lattice.compression;
    }
  }
}

}  // namespace

Patch gas_patch(const Settings& settings, const GasLattice& lattice, const Extent& extent) {
  const bool moves = lattice.compression != 0;
  const int margin = extent.margin + (moves ? braking_cells : 0), cells = extent.core + 2 * margin, dim = lattice.dim;
  const int per_cell = dim == 1 ? settings.integer("ppc") : whole(std::round(std::sqrt(settings.number("ppc"))));
  Patch patch;
  patch.directions = dim;
  patch.step = {{{1, 0, 0}, {0, 1, 0}}};
  patch.scene.grid.dim = dim;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dim); ++d) {
    patch.scene.grid.cells[d] = cells;
    patch.scene.grid.walls[d] = {Wall::symmetry, Wall::symmetry};
  }
  const std::vector<LinePoint> along = line_points(cells, per_cell, lattice.offset);
  const std::vector<LinePoint> across = dim == 1 ? std::vector<LinePoint>{{0, margin, 0}} : along;
  const auto material = gas_material(settings, lattice.viscosity, lattice.side, lattice.compression != 0);
  Body body = make_body("gas", material, static_cast<int>(along.size() * across.size()), dim);
  patch.places.emplace_back();
  std::size_t p = 0;
  for (const LinePoint& y : across) {
    for (const LinePoint& x : along) {
      body.points(column::position)[p] = x.place;
      if (dim == 2) body.points(column::position, 1)[p] = y.place;
      put_gas(body.points, p++, std::pow(per_cell, -dim));
      patch.places[0].push_back({{x.cell - margin, y.cell - margin}, x.member + per_cell * y.member});
    }
  }
  if (moves) set_in_motion(lattice, cells, settings.text("transfer") == "apic", body);
  patch.scene.bodies.push_back(std::move(body));
  apply_choices(settings, patch.scene);
  return patch;
}

}  // namespace plumbline
