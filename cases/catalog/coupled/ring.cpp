#include "cases/catalog/coupled/ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "cases/catalog/gas/ideal_gas.hpp"
#include "cases/harness/files/whole.hpp"
#include "reference/bessel.hpp"

namespace plumbline {
namespace {

constexpr int beyond = 3;  // cells of the grid outside the ring: the kernel reaches two

int chords_of(const Settings& settings) {
  const double arc = 0.5 * std::numbers::pi * settings.integer("cells");  // in cells
  return std::max(4, whole(std::round(arc * settings.number("membrane.ppc"))));
}

Curve lattice_cell(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

}  // namespace

RadialMode ring_mode(const reference::GasRing& exact, int mode, double radius) {
  const double k = exact.wavenumber(mode).value / radius, at_ring = reference::bessel_J1(k * radius).value;
  return RadialMode([=](double r) {
    const double outward = reference::bessel_J1(k * r).value / at_ring;
    return std::array<double, 2>{outward, k * reference::bessel_J0(k * r).value / at_ring - outward / r};
  });
}

Override york_ring_step(const Settings& settings) {
  const MembraneMaterial material = resting_ring(settings).material;
  const double speed = std::sqrt(material.youngs_modulus / material.density);
  return {"dt", 0.99 * ring_problem(settings).radius / settings.number("cells") / speed};  // [York A.4.7]
}

void RingParameters::read() {
  problem.youngs_modulus = positive("youngs_modulus", problem.youngs_modulus, "Pa",
                                    "Young's modulus of the ring, held out of the plane");
  problem.radius = positive("radius", problem.radius, "m", "of the ring at rest under the pressure");
  problem.pressure = positive("pressure", problem.pressure, "Pa", "of the gas; none outside");
  cut = one_of("edge", "cut", {"cut", "whole"},
               "gas points along the ring: cells of their lattice cut by it, or whole ones inside") == "cut";
}

RingParameters::RingParameters(const Settings& settings) : Parameters(settings) {
  read();
  problem.law = settings.text("membrane.strain") == "segments" ? reference::RingLaw::segments
                                                               : reference::RingLaw::accumulated;
}

reference::GasRingProblem ring_problem(const Settings& settings) { return RingParameters(settings).problem; }

RestingRing resting_ring(const reference::GasRingProblem& problem, int chords, bool segments) {
  RestingRing ring;
  const double half_angle = 0.25 * std::numbers::pi / chords;
  for (int k = 0; k <= chords; ++k) {
    ring.curve.push_back(
        {problem.radius * std::cos(2 * half_angle * k), problem.radius * std::sin(2 * half_angle * k)});
  }
  ring.curve.front()[1] = ring.curve.back()[0] = 0;
  MembraneMaterial& m = ring.material;
  m.youngs_modulus = problem.youngs_modulus;
  m.poissons_ratio = problem.poisson_ratio;
  ring.apothem = problem.radius * std::cos(half_angle);
  ring.strain = problem.pressure * ring.apothem / (m.plane_modulus() * problem.thickness);
  // The reference's thickness is that of the unstretched ring for segments, at rest under the pressure else.
  m.thickness = problem.thickness * (segments ? 1 : 1 + ring.strain);
  m.density = problem.line_mass * (1 + ring.strain) / m.thickness;
  Curve whole = ring.curve;
  whole.push_back({0, 0});
  ring.area = enclosed(whole);
  ring.gas_energy = problem.pressure / ((problem.gamma - 1) * problem.gas_density);
  return ring;
}

Curve cut(const Curve& polygon, double a, double b, double c) {
  Curve rest;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    const double here = a * from[0] + b * from[1] - c, there = a * to[0] + b * to[1] - c;
    if (here <= 0) rest.push_back(from);
    if ((here < 0 && there > 0) || (here > 0 && there < 0)) {
      const double at = here / (here - there);
      rest.push_back({from[0] + at * (to[0] - from[0]), from[1] + at * (to[1] - from[1])});
    }
  }
  return rest;
}

// About the first vertex: far from the origin small areas keep their digits.
std::array<double, 2> centroid(const Curve& polygon) {
  double area = 0, x = 0, y = 0;
  const auto& base = polygon.front();
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const double ax = polygon[k][0] - base[0], ay = polygon[k][1] - base[1];
    const double bx = polygon[k + 1][0] - base[0], by = polygon[k + 1][1] - base[1], twice = ax * by - bx * ay;
    area += twice;
    x += twice * (ax + bx) / 3;
    y += twice * (ay + by) / 3;
  }
  return {base[0] + x / area, base[1] + y / area};
}

Body fill_cut(const std::string& name, std::shared_ptr<const IdealGas> gas, const GridSpec& grid, int ppc,
              const Curve& polygon, double density, double energy) {
  const double side = grid.h / std::sqrt(static_cast<double>(ppc));
  double reach[2] = {};
  for (const auto& v : polygon) {
    for (std::size_t d = 0; d < 2; ++d) reach[d] = std::max(reach[d], v[d] - grid.origin[d]);
  }
  Curve places;
  std::vector<double> areas;
  for (int j = 0; j * side < reach[1]; ++j) {
    for (int i = 0; i * side < reach[0]; ++i) {
      Curve cell = lattice_cell(grid.origin[0] + i * side, grid.origin[1] + j * side, side);
      for (std::size_t k = 0; k < polygon.size() && !cell.empty(); ++k) {
        const auto &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
        const double a = to[1] - from[1], b = from[0] - to[0];
        cell = cut(cell, a, b, a * from[0] + b * from[1]);
      }
      const double area = cell.size() < 3 ? 0.0 : enclosed(cell);
      if (!(area > 1e-9 * side * side)) continue;  // a corner that rounding alone may cut off
      places.push_back(centroid(cell));
      areas.push_back(area);
    }
  }
  if (places.empty()) throw std::invalid_argument("no cell of the lattice reaches into the space of " + name);
  Body body = make_body(name, std::move(gas), static_cast<int>(places.size()), 2);
  for (std::size_t p = 0; p < places.size(); ++p) {
    body.points(column::position)[p] = places[p][0];
    body.points(column::position, 1)[p] = places[p][1];
    body.points(column::volume)[p] = areas[p];
    body.points(column::mass)[p] = density * areas[p];
    body.points(column::density)[p] = density;
    body.points(column::energy)[p] = energy;
  }
  return body;
}

Scene ring_scene(const Settings& settings, const RestingRing& ring) {
  const RingParameters at(settings);
  const reference::GasRingProblem& problem = at.problem;
  Scene scene;
  scene.grid.dim = 2;
  scene.grid.h = problem.radius / settings.number("cells");
  scene.grid.cells = {settings.integer("cells") + beyond, settings.integer("cells") + beyond, 1};
  for (std::size_t d = 0; d < 2; ++d) scene.grid.walls[d] = {Wall::symmetry, Wall::symmetry};
  auto gas = chosen_gas(settings, problem.gamma);
  Curve polygon = ring.curve;
  polygon.push_back({0, 0});
  const int ppc = settings.integer("ppc");
  const auto fill = at.cut ? fill_cut : fill_polygon;
  scene.bodies.push_back(fill("gas", gas, scene.grid, ppc, polygon, problem.gas_density, ring.gas_energy));
  scene.bodies.push_back(membrane_body(settings, "ring", ring.material, ring.curve, ring.strain));
  if (problem.law == reference::RingLaw::segments && settings.text("density") == "grid")
    scene.bodies[0].enclosure = Enclosure{"ring", {{0, 0}}};
  apply_choices(settings, scene);
  return scene;
}

RestingRing resting_ring(const Settings& settings) {
  const reference::GasRingProblem problem = ring_problem(settings);
  return resting_ring(problem, chords_of(settings), problem.law == reference::RingLaw::segments);
}

}  // namespace plumbline
