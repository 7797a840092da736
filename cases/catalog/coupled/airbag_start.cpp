#include "cases/catalog/coupled/airbag_start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "cases/harness/description/drag.hpp"
#include "cases/harness/description/schemes.hpp"
#include "cases/harness/files/whole.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {
namespace {

constexpr double gauge = 4000, atmosphere = 101325;  // Pa York, Table 8
constexpr double skin_modulus = 6e7, skin_poisson = 0.4, skin_thickness = 5e-4, bag_mass = 0.3672;
constexpr double box_height = 0.5, box_radius = 0.36, room_above = 0.75;  // m
constexpr double drag = 300;                                              // 1/s
constexpr double pump_interval = 1e-3;                                    // s

// The tether is ten times as stiff as a sheet of the skin's material as wide as its ring.
constexpr double tether_stiffness = 10 * skin_modulus * skin_thickness * tether_radius;

Tether tether_of(const Curve& points) {
  Tether tether;
  // the ring is met on the way down from the upper pole
  for (std::size_t p = points.size() - 1; p > 0; --p) {
    if (points[p - 1][0] < tether_radius) continue;
    tether.after = static_cast<int>(p - 1);
    tether.share = (points[p - 1][0] - tether_radius) / (points[p - 1][0] - points[p][0]);
    break;
  }
  tether.length = std::hypot(tether_radius, tether_height);
  tether.stiffness = tether_stiffness;
  return tether;
}

void clear_forces(Columns& points) {
  for (int d = 0; d < 2; ++d) std::fill_n(points(column::body_force, d), points.points(), 0.0);
}

// One temperature, and with it the pressure that is wanted in the volume there is.
void pump(Body& gas, double volume, double pressure) {
  const double* mass = gas.points(column::mass);
  double whole = 0;
  for (int p = 0; p < gas.points.points(); ++p) whole += mass[p];
  std::fill_n(gas.points(column::energy), gas.points.points(), pressure * volume / ((bag_gamma - 1) * whole));
}

// As if the points had been put where they stand.
Body put_anew(const Body& found, const std::vector<const ColumnId*>& columns) {
  const int n = found.points.points();
  Body body = make_body(found.name, found.material, n, 2, true);
  body.spacing = found.spacing;
  body.enclosure = found.enclosure;
  for (const ColumnId* id : columns) {
    for (int c = 0; c < found.points.components(*id); ++c) {
      for (int p = 0; p < n; ++p) {
        body.points(*id, c)[found.id[static_cast<std::size_t>(p)]] = found.points(*id, c)[p];
      }
    }
  }
  return body;
}

// The curve moved inwards, to its left, by a distance; its ends stay on the axis.
Curve inset(const Curve& curve, double by) {
  Curve inner = curve;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const auto &before = curve[k > 0 ? k - 1 : k], &after = curve[std::min(k + 1, curve.size() - 1)];
    const double x = after[0] - before[0], y = after[1] - before[1], chord = std::hypot(x, y);
    const bool end = k == 0 || k + 1 == curve.size();
    inner[k] = {end ? 0.0 : curve[k][0] - by * y / chord, curve[k][1] + by * x / chord};
  }
  return inner;
}

}  // namespace

BagPressures bag_pressures(const std::string& name) {
  if (name == "york") return {gauge, 0};
  return {atmosphere + gauge, atmosphere};
}

Curve york_outline(double crown) {
  return {{0.0, 0.002},  {0.14, 0.01},  {0.22, 0.037}, {0.26, 0.077}, {0.28, 0.139},
          {0.26, 0.219}, {0.22, 0.261}, {0.18, 0.289}, {0.14, 0.299}, {tether_radius, tether_height},
          {0.0, crown}};
}

MembraneMaterial bag_skin(const Curve& outline) {
  double area = 0;
  for (std::size_t k = 0; k + 1 < outline.size(); ++k) {
    const auto &a = outline[k], &b = outline[k + 1];
    area += std::numbers::pi * (a[0] + b[0]) * std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return {.youngs_modulus = skin_modulus,
          .poissons_ratio = skin_poisson,
          .density = bag_mass / (area * skin_thickness),
          .thickness = skin_thickness};
}

GridSpec airbag_grid(int cells) {
  GridSpec grid;
  grid.dim = 2;
  grid.axisymmetric = true;
  grid.h = box_height / cells;
  grid.cells = {whole(std::ceil(box_radius / grid.h - 1e-9)), whole(std::ceil(room_above / grid.h - 1e-9)), 1};
  grid.walls[0] = {Wall::symmetry, Wall::symmetry};
  grid.walls[1] = {Wall::symmetry, Wall::free};
  return grid;
}

Bag unstretched_bag(const GridSpec& grid, int ppc, double membrane_ppc, double crown, const BagPressures& pressures,
                    std::shared_ptr<const IdealGas> gas) {
  const Curve outline = york_outline(crown);
  const int segments = std::max(8, whole(std::round(length(outline) * membrane_ppc / grid.h)));
  const Curve points = evenly(outline, segments);
  const double energy = pressures.inside / ((bag_gamma - 1) * bag_density);  // [York 4.4]
  // no point nearer to the skin than half of what lies between points: on average they are as far in
  const double spacing = grid.h / std::sqrt(static_cast<double>(ppc));
  const Curve inner = inset(points, 0.25 * spacing);
  Bag bag{fill_polygon("gas", std::move(gas), grid, ppc, inner, bag_density, energy),
          revolved_body("bag", bag_skin(points), points), tether_of(points)};
  bag.gas.spacing = spacing;
  const double share = enclosed(points, true) / enclosed(inner, true);  // of the space at the skin, too
  for (const ColumnId* id : {&column::mass, &column::volume}) {
    for (int p = 0; p < bag.gas.points.points(); ++p) bag.gas.points(*id)[p] *= share;
  }
  return bag;
}

double enclosed_volume(const Body& skin) { return enclosed(outline(skin, {}), true); }

Bag inflate(const Bag& bag, const GridSpec& grid, const BagPressures& pressures) {
  const Settings choices(kind_keys(Kind::coupled));
  Scene scene;
  scene.grid = grid;
  scene.bodies = {bag.gas, bag.skin};
  apply_choices(choices, scene);
  scene.bodies[0].load = [](double, Columns& points, std::span<const int>) {
    clear_forces(points);
    add_drag(points, drag);
  };
  scene.bodies[1].load = [tether = bag.tether, outside = pressures.outside](double, Columns& points,
                                                                            std::span<const int>) {
    clear_forces(points);
    add_outside_pressure(points, outside);
    add_tether(points, tether);
    add_drag(points, drag);
  };
  StepControl control;
  control.cfl = choices.number("cfl");
  for (double blown = 0; blown < blowing_time - 0.5 * pump_interval; blown += pump_interval) {
    Simulation simulation(scene, choices.text("integrator"), control);
    simulation.run_until(pump_interval);
    scene = simulation.scene();
    pump(scene.bodies[0], enclosed_volume(scene.bodies[1]), pressures.inside);
  }
  Bag blown{put_anew(scene.bodies[0], {&column::position}),
            put_anew(scene.bodies[1],
                     {&column::position, &column::volume, &column::mass, &column::rest_length, &column::rest_radius}),
            bag.tether};
  const double volume = enclosed_volume(blown.skin), before = enclosed_volume(bag.skin);
  for (int p = 0; p < blown.gas.points.points(); ++p) {
    blown.gas.points(column::mass)[p] = bag.gas.points(column::mass)[p] * volume / before;
    blown.gas.points(column::volume)[p] = bag.gas.points(column::volume)[p] * volume / before;
    blown.gas.points(column::density)[p] = bag_density;
    blown.gas.points(column::energy)[p] = pressures.inside / ((bag_gamma - 1) * bag_density);  // [York 4.4]
  }
  return blown;
}

}  // namespace plumbline
