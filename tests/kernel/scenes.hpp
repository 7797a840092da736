// Small scenes for the tests of the kernel: boxes of gas, chains of membrane points, and looks at what became
// of them.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"
#include "kernel/simulation.hpp"

namespace plumbline::scenes {

using Place = std::array<double, 2>;
using WallTable = std::array<std::array<Wall, 2>, 2>;

// Uniform numbers, the same with every standard library.
class Random {
 public:
  explicit Random(unsigned long seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }

 private:
  std::mt19937_64 engine_;
};

inline WallTable walls(Wall x_low, Wall x_high, Wall y_low = Wall::free, Wall y_high = Wall::free) {
  return {{{x_low, x_high}, {y_low, y_high}}};
}
inline WallTable walls_everywhere(Wall kind) { return walls(kind, kind, kind, kind); }

inline GridSpec line(int cells, double h, WallTable sides = walls_everywhere(Wall::free)) {
  GridSpec grid;
  grid.cells = {cells, 1};
  grid.h = h;
  grid.walls = sides;
  return grid;
}
inline GridSpec plane(int columns, int rows, double h, WallTable sides = walls_everywhere(Wall::free)) {
  GridSpec grid = line(columns, h, sides);
  grid.dim = 2;
  grid.cells = {columns, rows};
  return grid;
}

// per_cell points a cell and direction in the cells first <= cell < last, evenly spaced, rows of growing x.
inline std::vector<Place> lattice(const GridSpec& grid, int per_cell, std::array<int, 2> first,
                                  std::array<int, 2> last) {
  std::vector<Place> places;
  const double d = grid.h / per_cell;
  const auto at = [&](int k, int direction) { return grid.origin[direction] + (k + 0.5) * d; };
  if (grid.dim == 1) {
    for (int i = first[0] * per_cell; i < last[0] * per_cell; ++i) places.push_back({at(i, 0), 0.0});
    return places;
  }
  for (int j = first[1] * per_cell; j < last[1] * per_cell; ++j) {
    for (int i = first[0] * per_cell; i < last[0] * per_cell; ++i) places.push_back({at(i, 0), at(j, 1)});
  }
  return places;
}
inline std::vector<Place> lattice(const GridSpec& grid, int per_cell) {
  return lattice(grid, per_cell, {0, 0}, grid.cells);
}
inline double lattice_volume(const GridSpec& grid, int per_cell) { return std::pow(grid.h / per_cell, grid.dim); }

// Every place moved by up to `amplitude` in each direction.
inline std::vector<Place> jittered(std::vector<Place> places, double amplitude, int dim, unsigned long seed = 1) {
  Random random(seed);
  for (Place& place : places) {
    for (int d = 0; d < dim; ++d) place[d] += random(-amplitude, amplitude);
  }
  return places;
}

struct GasState {
  double density = 1, energy = 1;
  Place velocity{0, 0};
};
using GasField = std::function<GasState(const Place&)>;

// Each point has the volume `volume` and the mass that the field's density gives it there.
inline Body gas_body(const IdealGas& gas, int dim, const std::vector<Place>& places, double volume,
                     const GasField& field) {
  Body body = make_body("gas", std::make_shared<IdealGas>(gas), static_cast<int>(places.size()), dim);
  for (std::size_t p = 0; p < places.size(); ++p) {
    const GasState state = field(places[p]);
    for (int d = 0; d < dim; ++d) {
      body.points(column::position, d)[p] = places[p][d];
      body.points(column::velocity, d)[p] = state.velocity[d];
    }
    body.points(column::mass)[p] = state.density * volume;
    body.points(column::volume)[p] = volume;
    body.points(column::density)[p] = state.density;
    body.points(column::energy)[p] = state.energy;
  }
  return body;
}

inline Body membrane_body(const UniaxialMembrane& law, int dim, const std::vector<Place>& places, double volume,
                          const std::function<Place(const Place&)>& velocity = {}) {
  Body body = make_body("membrane", std::make_shared<UniaxialMembrane>(law), static_cast<int>(places.size()), dim);
  for (std::size_t p = 0; p < places.size(); ++p) {
    const Place v = velocity ? velocity(places[p]) : Place{0, 0};
    for (int d = 0; d < dim; ++d) {
      body.points(column::position, d)[p] = places[p][d];
      body.points(column::velocity, d)[p] = v[d];
    }
    body.points(column::mass)[p] = law.density * volume;
    body.points(column::volume)[p] = volume;
  }
  return body;
}

inline Scene scene_of(const GridSpec& grid, std::vector<Body> bodies, const std::string& shape,
                      const std::string& transfer, Place gravity = {0, 0}) {
  Scene scene;
  scene.grid = grid;
  scene.bodies = std::move(bodies);
  scene.shape = shape;
  scene.transfer = transfer;
  scene.gravity = gravity;
  return scene;
}

// A gas with all there is: random velocities, uneven places and energies, both viscosities, walls and a free
// surface.
inline Scene rough_gas(int dim, const std::string& shape, const std::string& transfer, Place gravity = {3, -9}) {
  IdealGas gas;
  gas.viscosity = 0.01;
  gas.viscosity_linear = 0.2;
  gas.viscosity_quadratic = 0.5;
  const GridSpec grid = dim == 1 ? line(9, 0.1, walls(Wall::symmetry, Wall::free))
                                 : plane(6, 7, 0.1, walls(Wall::symmetry, Wall::no_slip, Wall::no_slip, Wall::free));
  const auto places = jittered(lattice(grid, 3, {0, 0}, {6, 4}), 0.012, dim);
  Random random(7);
  const auto field = [&](const Place&) {
    GasState state;
    state.density = random(0.5, 1.5);
    state.energy = random(1, 2);
    state.velocity = {random(-0.4, 0.4), random(-0.4, 0.4)};
    return state;
  };
  return scene_of(grid, {gas_body(gas, dim, places, lattice_volume(grid, 3), field)}, shape, transfer, gravity);
}

// The same in empty space: no walls, room to all sides, and node lines half a cell off the edges, so that no
// point starts a cell of its own, where a node of next to no mass would be thrown about.
inline Scene rough_gas_in_space(int dim, const std::string& shape, const std::string& transfer,
                                Place gravity = {3, -9}) {
  Scene scene = rough_gas(dim, shape, transfer, gravity);
  scene.grid.walls = walls_everywhere(Wall::free);
  scene.grid.origin = {-0.25, dim == 1 ? 0.0 : -0.25};
  scene.grid.cells = {11, dim == 1 ? 1 : 9};
  return scene;
}

// Some integrator, shape and transfer that work together.
struct Combination {
  std::string integrator, shape, transfer;
};
inline std::ostream& operator<<(std::ostream& out, const Combination& c) {
  return out << c.integrator << ", " << c.shape << ", " << c.transfer;
}
inline std::vector<Combination> working_combinations() {
  std::vector<Combination> all;
  for (const IntegratorEntry& entry : integrators()) {
    for (const Choice& shape : shapes()) {
      for (const Choice& transfer : transfers()) {
        if (!entry.make()->refusal(shape.name, transfer.name).empty()) continue;
        all.push_back({entry.name, shape.name, transfer.name});
      }
    }
  }
  return all;
}

// One column of a body in the order in which the scene made its points.
inline std::vector<double> by_id(const Body& body, const ColumnId& id, int component = 0) {
  std::vector<double> values(body.id.size());
  for (std::size_t p = 0; p < values.size(); ++p) values[body.id[p]] = body.points(id, component)[p];
  return values;
}

inline std::vector<const ColumnId*> all_columns() {
  return {&column::position,    &column::velocity, &column::affine,       &column::mass,   &column::volume,
          &column::strain_rate, &column::stress,   &column::density,      &column::energy, &column::pressure,
          &column::strain,      &column::tangent,  &column::transfer_loss};
}

// Every column, bit for bit, and the order of the points.
inline bool same_bits(const Body& a, const Body& b) {
  if (a.id != b.id) return false;
  for (const ColumnId* id : all_columns()) {
    if (a.points.has(*id) != b.points.has(*id)) return false;
    if (!a.points.has(*id)) continue;
    const auto left = a.points.values(*id), right = b.points.values(*id);
    if (!std::equal(left.begin(), left.end(), right.begin(), right.end())) return false;
  }
  return true;
}

// The ledger's identities, relative to the scales that the contract names.
inline void expect_ledger_closes(const Ledger& ledger, double tolerance) {
  EXPECT_LE(ledger.mass.relative_drift(false), tolerance);
  for (const Account& momentum : ledger.momentum) EXPECT_LE(momentum.relative_drift(true), tolerance);
  EXPECT_LE(ledger.angular_momentum.relative_drift(true), tolerance);
  EXPECT_LE(ledger.energy.relative_drift(false), tolerance);
}

}  // namespace plumbline::scenes
