// Small scenes for the tests of the kernel: boxes of gas, chains of membrane points, and looks at what became
// of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "kernel/integrator_traits.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/uniaxial_membrane.hpp"
#include "kernel/shapes/domain_columns.hpp"
#include "kernel/shapes/shape.hpp"
#include "kernel/simulation.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline::scenes {

using Place = std::array<double, 3>;
using WallTable = decltype(GridSpec::walls);

// The four geometries.
enum class Space { line, plane, axisymmetric, solid };
inline constexpr Space spaces[] = {Space::line, Space::plane, Space::axisymmetric, Space::solid};
inline constexpr int dim_of(Space space) { return space == Space::line ? 1 : space == Space::solid ? 3 : 2; }
inline constexpr Space space_of(int dim) { return dim == 1 ? Space::line : dim == 3 ? Space::solid : Space::plane; }
inline Space space_of(const GridSpec& grid) { return grid.axisymmetric ? Space::axisymmetric : space_of(grid.dim); }
inline std::ostream& operator<<(std::ostream& out, Space space) {
  constexpr const char* names[] = {"line", "plane", "axisymmetric", "solid"};
  return out << names[static_cast<int>(space)];
}

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

inline WallTable walls(Wall x_low, Wall x_high, Wall y_low = Wall::free, Wall y_high = Wall::free,
                       Wall z_low = Wall::free, Wall z_high = Wall::free) {
  return {{{x_low, x_high}, {y_low, y_high}, {z_low, z_high}}};
}
inline WallTable walls_everywhere(Wall kind) { return walls(kind, kind, kind, kind, kind, kind); }

inline GridSpec box(Space space, std::array<int, 3> cells, double h, WallTable sides = walls_everywhere(Wall::free)) {
  GridSpec grid;
  grid.dim = dim_of(space);
  grid.axisymmetric = space == Space::axisymmetric;
  for (int d = 0; d < grid.dim; ++d) grid.cells[d] = cells[d];
  grid.h = h;
  grid.walls = sides;
  return grid;
}
inline GridSpec line(int cells, double h, WallTable sides = walls_everywhere(Wall::free)) {
  return box(Space::line, {cells, 1, 1}, h, sides);
}
inline GridSpec plane(int columns, int rows, double h, WallTable sides = walls_everywhere(Wall::free)) {
  return box(Space::plane, {columns, rows, 1}, h, sides);
}

// per_cell points a cell and direction in the cells first <= cell < last, evenly spaced, rows of growing x.
inline std::vector<Place> lattice(const GridSpec& grid, int per_cell, std::array<int, 3> first,
                                  std::array<int, 3> last) {
  std::vector<Place> places;
  const double spacing = grid.h / per_cell;
  std::array<int, 3> low{0, 0, 0}, high{1, 1, 1};
  for (int d = 0; d < grid.dim; ++d) {
    low[d] = first[d] * per_cell;
    high[d] = last[d] * per_cell;
  }
  const auto at = [&](int k, int d) { return d < grid.dim ? grid.origin[d] + (k + 0.5) * spacing : 0.0; };
  for (int k = low[2]; k < high[2]; ++k) {
    for (int j = low[1]; j < high[1]; ++j) {
      for (int i = low[0]; i < high[0]; ++i) places.push_back({at(i, 0), at(j, 1), at(k, 2)});
    }
  }
  return places;
}
inline std::vector<Place> lattice(const GridSpec& grid, int per_cell) {
  return lattice(grid, per_cell, {0, 0, 0}, grid.cells);
}
// m^dim; in an axisymmetric scene the area of a ring's section.
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
  Place velocity{0, 0, 0};
};
using GasField = std::function<GasState(const Place&)>;

// Each point has the volume `volume` and the mass that the field's density gives it there. In an axisymmetric scene a
// point is a ring and `volume` its section: per radian the volume is |r| times that.
inline Body gas_body(const IdealGas& gas, Space space, const std::vector<Place>& places, double volume,
                     const GasField& field) {
  const bool rings = space == Space::axisymmetric;
  Body body = make_body("gas", std::make_shared<IdealGas>(gas), static_cast<int>(places.size()), dim_of(space), rings);
  for (std::size_t p = 0; p < places.size(); ++p) {
    const GasState state = field(places[p]);
    const double own = rings ? volume * std::abs(places[p][0]) : volume;
    for (int d = 0; d < dim_of(space); ++d) {
      body.points(column::position, d)[p] = places[p][d];
      body.points(column::velocity, d)[p] = state.velocity[d];
    }
    body.points(column::mass)[p] = state.density * own;
    body.points(column::volume)[p] = own;
    body.points(column::density)[p] = state.density;
    body.points(column::energy)[p] = state.energy;
  }
  return body;
}
inline Body gas_body(const IdealGas& gas, int dim, const std::vector<Place>& places, double volume,
                     const GasField& field) {
  return gas_body(gas, space_of(dim), places, volume, field);
}

inline Body membrane_body(const UniaxialMembrane& law, int dim, const std::vector<Place>& places, double volume,
                          const std::function<Place(const Place&)>& velocity = {}) {
  Body body = make_body("membrane", std::make_shared<UniaxialMembrane>(law), static_cast<int>(places.size()), dim);
  for (std::size_t p = 0; p < places.size(); ++p) {
    const Place v = velocity ? velocity(places[p]) : Place{0, 0, 0};
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
                      const std::string& transfer, Place gravity = {0, 0, 0}) {
  Scene scene;
  scene.grid = grid;
  scene.bodies = std::move(bodies);
  scene.shape = shape;
  scene.transfer = transfer;
  scene.gravity = gravity;
  return scene;
}

inline IdealGas rough_law() {
  IdealGas gas;
  gas.viscosity = 0.01;
  gas.viscosity_linear = 0.2;
  gas.viscosity_quadratic = 0.5;
  return gas;
}
// Without physical viscosity: its stress is a pressure, one component.
inline IdealGas inviscid_law() {
  IdealGas gas = rough_law();
  gas.viscosity = 0;
  return gas;
}

inline constexpr Place rough_gravity{3, -9, 0}, no_gravity{0, 0, 0};

// A gas with all there is: random velocities, uneven places and energies, both viscosities, walls and a free
// surface. The low side in x is the axis of an axisymmetric scene.
inline Scene rough_gas(Space space, const std::string& shape, const std::string& transfer,
                       Place gravity = rough_gravity, const IdealGas& gas = rough_law()) {
  const int dim = dim_of(space), per_cell = dim == 3 ? 2 : 3;
  const Wall s = Wall::symmetry, n = Wall::no_slip, f = Wall::free;
  const GridSpec grid = dim == 1   ? line(9, 0.1, walls(s, f))
                        : dim == 2 ? box(space, {6, 7, 1}, 0.1, walls(s, n, n, f))
                                   : box(space, {4, 5, 4}, 0.1, walls(s, n, n, f, f, s));
  const auto filled = dim == 3 ? lattice(grid, per_cell, {0, 0, 1}, {4, 3, 4})
                               : lattice(grid, per_cell, {0, 0, 0}, {6, 4, 1});
  const auto places = jittered(filled, 0.012, dim);
  Random random(7);
  const auto field = [&](const Place&) {
    GasState state;
    state.density = random(0.5, 1.5);
    state.energy = random(1, 2);
    state.velocity = {random(-0.4, 0.4), random(-0.4, 0.4), 0};
    if (dim == 3) state.velocity[2] = random(-0.4, 0.4);
    return state;
  };
  return scene_of(grid, {gas_body(gas, space, places, lattice_volume(grid, per_cell), field)}, shape, transfer,
                  gravity);
}
inline Scene rough_gas(int dim, const std::string& shape, const std::string& transfer, Place gravity = rough_gravity) {
  return rough_gas(space_of(dim), shape, transfer, gravity);
}

// The same in empty space: no walls, space to all sides, and node lines half a cell off the edges, so that no
// point starts a cell of its own, where a node of next to no mass would be thrown about. An axisymmetric scene stands
// five cells off the axis.
inline Scene rough_gas_in_space(Space space, const std::string& shape, const std::string& transfer,
                                Place gravity = rough_gravity, const IdealGas& gas = rough_law()) {
  Scene scene = rough_gas(space, shape, transfer, gravity, gas);
  const int dim = dim_of(space);
  scene.grid.walls = walls_everywhere(Wall::free);
  for (int d = 0; d < dim; ++d) {
    scene.grid.origin[d] = -0.25;
    scene.grid.cells[d] = d == 0 && dim < 3 ? 11 : 9;
  }
  if (dim == 3) scene.grid.origin[2] = -0.15;
  if (space == Space::axisymmetric) {
    Columns& points = scene.bodies[0].points;
    scene.grid.origin[0] += 0.5;
    for (int p = 0; p < points.points(); ++p) {
      double& r = points(column::position)[p];
      for (const ColumnId* id : {&column::mass, &column::volume}) points(*id)[p] *= (r + 0.5) / r;
      r += 0.5;
    }
  }
  return scene;
}
inline Scene rough_gas_in_space(int dim, const std::string& shape, const std::string& transfer,
                                Place gravity = rough_gravity) {
  return rough_gas_in_space(space_of(dim), shape, transfer, gravity);
}

// Some integrator, shape and transfer that work together.
struct Combination {
  std::string integrator, shape, transfer;
};
inline std::ostream& operator<<(std::ostream& out, const Combination& c) {
  return out << c.integrator << ", " << c.shape << ", " << c.transfer;
}
// Whether a part or an integrator is one that a single test registers: all tests of a program share its lists.
inline bool of_a_test(const std::string& name) { return name.rfind("test_", 0) == 0; }
// Shapes whose weights are those of where points stand now.
inline std::vector<Choice> shapes_in_space() {
  std::vector<Choice> all;
  for (const ShapeEntry& shape : shapes()) {
    if (!shape.at_start) all.push_back(shape);
  }
  return all;
}
inline std::vector<Combination> working_combinations() {
  std::vector<Combination> all;
  for (const IntegratorEntry& entry : integrators()) {
    if (of_a_test(entry.name)) continue;
    for (const Choice& shape : shapes_in_space()) {
      for (const Choice& transfer : transfers()) {
        if (of_a_test(transfer.name) || !lacks(entry, shape.name, transfer.name).empty()) continue;
        // Forces of linear shapes jump where points change cells: there a step may have no midpoint, and the run stops.
        if (entry.name == "implicit-midpoint" && shape.name == "linear") continue;
        all.push_back({entry.name, shape.name, transfer.name});
      }
    }
  }
  return all;
}

// How often a point adds to a node that it reaches, at most: a bound of rounding grows with the number of terms.
inline int terms(const std::string& shape, int dim) { return shape == "cpdi" ? 1 << dim : 1; }

// Whether a test of all combinations is to run one in a space. Listing the corners of domains in space takes seconds a scene: there one
// integrator and transfer stand for all.
inline bool runs_in(const Combination& c, Space space) {
  return space != Space::solid || c.shape != "cpdi" || (c.integrator == "midpoint" && c.transfer == "apic");
}

// One column of a body in the order in which the scene made its points.
inline std::vector<double> by_id(const Body& body, const ColumnId& id, int component = 0) {
  std::vector<double> values(body.id.size());
  for (std::size_t p = 0; p < values.size(); ++p) values[body.id[p]] = body.points(id, component)[p];
  return values;
}

// The densities that a step computes with, m_p / V_p, in the same order.
inline std::vector<double> densities_in_use(const Body& body) {
  std::vector<double> rho = by_id(body, column::mass);
  const std::vector<double> volume = by_id(body, column::volume);
  for (std::size_t p = 0; p < rho.size(); ++p) rho[p] /= volume[p];
  return rho;
}

inline std::vector<const ColumnId*> all_columns() {
  return {&column::position,  &column::velocity,           &column::affine,      &column::mass,
          &column::volume,    &column::strain_rate,        &column::stress,      &column::density,
          &column::energy,    &column::pressure,           &column::strain,      &column::kept_loss,
          &column::tangent,   &column::transfer_loss,      &column::deformation, &column::body_force,
          &column::half_size, &column::half_size_at_start, &column::half_edges,  &column::half_edges_at_start};
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
  for (const Account& angular : ledger.angular_momentum) EXPECT_LE(angular.relative_drift(true), tolerance);
  EXPECT_LE(ledger.energy.relative_drift(false), tolerance);
}

// Every flow, store and residual of two accounts, bit for bit.
inline void expect_same_account(const Account& a, const Account& b) {
  EXPECT_EQ(a.store(), b.store());
  EXPECT_EQ(a.residual(), b.residual());
  EXPECT_EQ(a.largest_residual(), b.largest_residual());
  EXPECT_EQ(a.booked(), b.booked());
  for (int f = 0; f < flow_count; ++f) EXPECT_EQ(a.flow(static_cast<Flow>(f)), b.flow(static_cast<Flow>(f)));
}
inline void expect_same_ledger(const Ledger& a, const Ledger& b) {
  expect_same_account(a.mass, b.mass);
  expect_same_account(a.energy, b.energy);
  for (std::size_t d = 0; d < 3; ++d) {
    expect_same_account(a.momentum[d], b.momentum[d]);
    expect_same_account(a.angular_momentum[d], b.angular_momentum[d]);
  }
  EXPECT_EQ(a.viscous, b.viscous);
}

}  // namespace plumbline::scenes
