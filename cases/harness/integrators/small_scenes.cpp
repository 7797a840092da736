#include "cases/harness/integrators/small_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "cases/harness/description/fill_solid.hpp"
#include "kernel/integrator_traits.hpp"
#include "kernel/materials/ideal_gas.hpp"
#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/materials/segment_membrane.hpp"

namespace plumbline {
namespace {

using Vector = std::array<double, 3>;

constexpr int points_per_cell = 2;
constexpr double speed = 0.03;  // of points, over that of waves: they move by less than a tenth of a cell

struct Space {
  int dim;
  bool axisymmetric;
  int cells;  // of the material in each direction
};
constexpr Space line{1, false, 8}, plane{2, false, 5}, rings{2, true, 5}, space{3, false, 3};

// Walls of both kinds below, two empty cells before free sides above.
GridSpec corner(const Space& in, bool closed) {
  GridSpec grid;
  grid.dim = in.dim;
  grid.axisymmetric = in.axisymmetric;
  for (std::size_t d = 0; d < static_cast<std::size_t>(in.dim); ++d) {
    grid.cells[d] = in.cells + (closed ? 0 : 2);
    grid.walls[d] = {d == 1 && !closed ? Wall::no_slip : Wall::symmetry, closed ? Wall::symmetry : Wall::free};
  }
  return grid;
}

// Another wave in each direction, none of them along an axis; at rest on the walls of the corner.
double wave(const Vector& x, int direction, int dim) {
  const double k = 0.45 + 0.11 * direction;
  double value = 1 + 0.3 * direction;
  for (int d = 0; d < dim; ++d)
    value *= d == direction ? std::sin(k * x[static_cast<std::size_t>(d)])
                            : std::cos(0.2 * (d + 1) * x[static_cast<std::size_t>(d)]);
  return value;
}

Vector place(const Columns& points, int p, int dim) {
  Vector x{};
  for (int d = 0; d < dim; ++d) x[static_cast<std::size_t>(d)] = points(column::position, d)[p];
  return x;
}

void set_in_motion(Body& body, int dim) {
  for (int p = 0; p < body.points.points(); ++p) {
    const Vector x = place(body.points, p, dim);
    for (int d = 0; d < dim; ++d) body.points(column::velocity, d)[p] = speed * wave(x, d, dim);
  }
}

template <class Law>
std::shared_ptr<const Law> elastic() {
  auto law = std::make_shared<Law>();
  law->density = 1;
  law->poissons_ratio = 0.3;
  law->youngs_modulus = 0.74;  // compression waves of speed one in the plane and in space
  return law;
}

SolidShape box(const Space& in, Vector low, Vector high) {
  for (int d = in.dim; d < 3; ++d) high[static_cast<std::size_t>(d)] = 0;
  return {.low = low, .high = high};
}
SolidShape filled(const Space& in) {
  const double side = in.cells;
  return box(in, {0, 0, 0}, {side, side, side});
}

template <class Law>
Scene solid(const Space& in, double gravity) {
  Scene scene;
  scene.grid = corner(in, false);
  scene.bodies.push_back(fill_solid("solid", elastic<Law>(), filled(in), 1, points_per_cell, scene.grid));
  set_in_motion(scene.bodies[0], in.dim);
  scene.gravity[static_cast<std::size_t>(in.dim) - 1] = gravity;
  return scene;
}

// Gas between walls, hotter on one side.
Scene gas(const Space& in, double viscosity = 0) {
  auto law = std::make_shared<IdealGas>();
  law->gamma = 1.4;
  law->viscosity = viscosity;
  Scene scene;
  scene.grid = corner(in, true);
  Body body = fill_solid("gas", std::move(law), filled(in), 1, points_per_cell, scene.grid);
  set_in_motion(body, in.dim);
  for (int p = 0; p < body.points.points(); ++p) {
    const Vector x = place(body.points, p, in.dim);
    const double hotter = 0.05 * std::cos(0.5 * x[0]) * (in.dim > 1 ? std::cos(0.3 * x[1]) : 1);
    body.points(column::density)[p] = 1;
    body.points(column::energy)[p] = (1 + hotter) / (1.4 * 0.4);  // sound of speed one
  }
  scene.bodies.push_back(std::move(body));
  return scene;
}

// A string of segments that hangs between its ends' inertia, taut and in motion.
Scene string() {
  constexpr int count = 17;
  constexpr double spacing = 0.5, taut = 0.05;
  auto law = std::make_shared<SegmentMembrane>();
  law->youngs_modulus = law->density = 1;
  law->section = 0.1;
  law->one_way = false;
  Scene scene;
  scene.grid.dim = 2;
  scene.grid.cells = {12, 5, 1};
  Body body = make_body("string", law, count, 2);
  for (int p = 0; p < count; ++p) {
    const double along = 1.77 + p * spacing;
    body.points(column::position, 0)[p] = along;
    body.points(column::position, 1)[p] = 2.5 + 0.2 * std::sin(0.7 * along);
    body.points(column::velocity, 0)[p] = speed * std::sin(0.4 * along);
    body.points(column::velocity, 1)[p] = speed * std::cos(0.5 * along);
    body.points(column::rest_length)[p] = spacing / (1 + taut);
    body.points(column::volume)[p] = body.points(column::mass)[p] = law->section * spacing;
  }
  scene.bodies.push_back(std::move(body));
  scene.gravity = {0, -0.01, 0};
  return scene;
}

// Two solids, the second three times as heavy and stiff, that move with one velocity field.
Scene two_bodies() {
  Scene scene;
  scene.grid = corner(plane, false);
  auto heavy = std::make_shared<NeoHookean>(*elastic<NeoHookean>());
  heavy->density = 3;
  heavy->youngs_modulus *= 3;
  scene.bodies.push_back(
      fill_solid("light", elastic<NeoHookean>(), box(plane, {0, 0, 0}, {3, 5, 0}), 1, points_per_cell, scene.grid));
  scene.bodies.push_back(fill_solid("heavy", heavy, box(plane, {3, 0, 0}, {5, 5, 0}), 3, points_per_cell, scene.grid));
  for (Body& body : scene.bodies) set_in_motion(body, 2);
  return scene;
}

// A plate that turns about its middle and swells; nothing holds it.
Scene turning() {
  constexpr double middle = 4, rate = 0.15;
  Scene scene;
  scene.grid.dim = 2;
  scene.grid.cells = {8, 8, 1};
  scene.bodies.push_back(
      fill_solid("plate", elastic<NeoHookean>(), box(plane, {2, 2, 0}, {6, 6, 0}), 1, points_per_cell, scene.grid));
  Columns& points = scene.bodies[0].points;
  for (int p = 0; p < points.points(); ++p) {
    const double x = points(column::position, 0)[p] - middle, y = points(column::position, 1)[p] - middle;
    points(column::velocity, 0)[p] = -rate * y + 0.3 * speed * x + speed;
    points(column::velocity, 1)[p] = rate * x + 0.3 * speed * y;
  }
  return scene;
}

// A bar without walls, space on both sides, its ends in the middle of cells.
Scene free_bar() {
  constexpr double low = 3.5, length = 8;
  Scene scene;
  scene.grid.cells[0] = 16;
  scene.bodies.push_back(fill_solid("bar", elastic<LinearElastic>(), box(line, {low, 0, 0}, {low + length, 0, 0}), 1,
                                    points_per_cell, scene.grid));
  Columns& points = scene.bodies[0].points;
  for (int p = 0; p < points.points(); ++p) {
    points(column::velocity)[p] = speed * std::sin(0.8 * (points(column::position)[p] - low) + 0.3);
  }
  return scene;
}

// A bar that a body force swings, another at each instant and place.
Scene loaded() {
  Scene scene = solid<LinearElastic>(line, 0);
  const Columns& at_start = scene.bodies[0].points;
  const std::vector<double> places(at_start(column::position), at_start(column::position) + at_start.points());
  scene.bodies[0].points.add(column::body_force, 1);
  scene.bodies[0].load = [places](double time, Columns& points, std::span<const int> id) {
    for (std::size_t p = 0; p < id.size(); ++p) {
      points(column::body_force)[p] = 0.02 * std::cos(1.3 * time) * places[static_cast<std::size_t>(id[p])];
    }
  };
  return scene;
}

// Half a wave in each direction of a closed box, many cells long: what a filter takes from such velocities once a step is less
// than what a consistency gate sees, so that shorter steps have a limit.
void set_long_wave(Body& body, const GridSpec& grid) {
  for (int p = 0; p < body.points.points(); ++p) {
    for (int d = 0; d < grid.dim; ++d) {
      double v = speed * (1 + 0.5 * d);
      for (int e = 0; e < grid.dim; ++e) {
        const double x = body.points(column::position, e)[p];
        const double phase = std::numbers::pi * x / grid.cells[static_cast<std::size_t>(e)];
        v *= e == d ? std::sin(phase) : std::cos(phase);
      }
      body.points(column::velocity, d)[p] = v;
    }
  }
}

Scene long_wave_in_solid(const Space& in) {
  Scene scene;
  scene.grid = corner(in, true);
  scene.bodies.push_back(fill_solid("solid", elastic<NeoHookean>(), filled(in), 1, points_per_cell, scene.grid));
  set_long_wave(scene.bodies[0], scene.grid);
  return scene;
}

Scene long_wave_in_gas(const Space& in) {
  Scene scene = gas(in);
  set_long_wave(scene.bodies[0], scene.grid);
  const auto energy = scene.bodies[0].points.values(column::energy);
  std::fill(energy.begin(), energy.end(), 1 / (1.4 * 0.4));
  return scene;
}

const Maps unfiltered{"quadratic", "flip"}, filtered{"quadratic", "apic"};
constexpr int long_cells = 32;
const double filtered_in_a_step = std::pow(std::numbers::pi / long_cells, 4);

}  // namespace

const std::vector<SmallScene>& small_scenes() {
  static const std::vector<SmallScene> all{
      {"bar", "a linear elastic bar with a wall, a free end and gravity", 2,
       [] { return solid<LinearElastic>(line, -0.01); }, unfiltered},
      {"bar-variable-steps", "the same with steps that alternate between 1 and 0.7 of a size", 2,
       [] { return solid<LinearElastic>(line, -0.01); }, unfiltered, most_left_over, true},
      {"bar-loaded", "the same with a body force that changes with place and time", 2, loaded, unfiltered},
      {"plate", "a neo-Hookean plate in a corner of two walls", 2, [] { return solid<NeoHookean>(plane, 0.01); },
       unfiltered},
      {"plate-turning", "a neo-Hookean plate that turns, swells and moves on", 2, turning, unfiltered},
      {"two-bodies", "two neo-Hookean plates of different density in one velocity field", 2, two_bodies, unfiltered},
      {"solid-rings", "a neo-Hookean solid of revolution", 2, [] { return solid<NeoHookean>(rings, 0.01); },
       unfiltered},
      {"block", "a neo-Hookean block in space", 1, [] { return solid<NeoHookean>(space, 0.01); }, unfiltered},
      {"gas", "gas between two walls", 2, [] { return gas(line); }, unfiltered},
      {"gas-viscous", "viscous gas between two walls", 2, [] { return gas(line, 0.2); }, unfiltered},
      {"gas-plane", "gas in a box", 2, [] { return gas(plane); }, unfiltered},
      {"gas-rings", "gas in a can, axisymmetric", 2, [] { return gas(rings); }, unfiltered},
      {"bar-filtered", "half a wave in a bar between two walls, velocities filtered once a step", 8,
       [] {
         return long_wave_in_solid({1, false, long_cells});
       },
       filtered, filtered_in_a_step},
      {"plate-filtered", "half a wave in a plate between four walls, velocities filtered once a step", 4,
       [] {
         return long_wave_in_solid({2, false, long_cells});
       },
       filtered, filtered_in_a_step},
      {"gas-filtered", "half a wave in a gas between two walls, velocities filtered once a step", 8,
       [] {
         return long_wave_in_gas({1, false, long_cells});
       },
       filtered, filtered_in_a_step},
      {"gas-plane-filtered", "half a wave in a gas between four walls, velocities filtered once a step", 4,
       [] {
         return long_wave_in_gas({2, false, long_cells});
       },
       filtered, filtered_in_a_step},
      {"free-bar", "a linear elastic bar without walls", 4, free_bar, unfiltered},
      {"string", "a taut string of segments in the plane with gravity", 2, string, unfiltered}};
  return all;
}

const SmallScene& small_scene(const std::string& name) {
  const auto& all = small_scenes();
  const auto found = std::find_if(all.begin(), all.end(), [&](const SmallScene& s) { return s.name == name; });
  if (found == all.end()) throw std::out_of_range("no small scene " + name);
  return *found;
}

Scene workable(const SmallScene& small, const std::string& integrator) {
  Scene scene = small.make();
  scene.shape = small.maps.shape;
  scene.transfer = small.maps.transfer;
  std::vector<Lack> missing = lacks(*find_integrator(integrator), scene);
  if (!missing.empty()) throw CannotWork(std::move(missing));
  return scene;
}

SmallScene with_some_maps(SmallScene small, const std::string& integrator) {
  const IntegratorEntry& entry = *find_integrator(integrator);
  small.maps = filtered;  // under which points that drift move as the grid does
  const bool can = lacks(entry, unfiltered.shape, unfiltered.transfer).empty();
  if (can && !traits_of(entry).drifts) small.maps = unfiltered;
  return small;
}

Scene with_axes_exchanged(Scene scene) {
  std::swap(scene.grid.cells[0], scene.grid.cells[1]);
  std::swap(scene.grid.walls[0], scene.grid.walls[1]);
  std::swap(scene.gravity[0], scene.gravity[1]);
  for (Body& body : scene.bodies) {
    for (const ColumnId* id : {&column::position, &column::velocity}) {
      std::swap_ranges(body.points(*id, 0), body.points(*id, 0) + body.points.points(), body.points(*id, 1));
    }
  }
  return scene;
}

Scene mirrored(Scene scene) {
  const double side = scene.grid.cells[0] * scene.grid.h;
  std::swap(scene.grid.walls[0][0], scene.grid.walls[0][1]);
  scene.gravity[0] = -scene.gravity[0];
  for (Body& body : scene.bodies) {
    for (int p = 0; p < body.points.points(); ++p) {
      body.points(column::position)[p] = side - body.points(column::position)[p];
      body.points(column::velocity)[p] = -body.points(column::velocity)[p];
    }
  }
  return scene;
}

}  // namespace plumbline
