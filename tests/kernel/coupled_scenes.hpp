// Gas and membranes that share a velocity field, and shapes worked out point by point, for the tests of what they
// exchange.
#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "kernel/materials/segment_membrane.hpp"
#include "kernel/shapes/cubic.hpp"
#include "kernel/shapes/quadratic.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::scenes {

// How a membrane knows its strain: from its segments, or carried by its points.
enum class Skin { segments, closed_segments, uniaxial, plane_stress };
inline constexpr Skin skins[] = {Skin::segments, Skin::closed_segments, Skin::uniaxial, Skin::plane_stress};
inline std::ostream& operator<<(std::ostream& out, Skin skin) {
  constexpr const char* names[] = {"segments", "closed_segments", "uniaxial", "plane_stress"};
  return out << names[static_cast<int>(skin)];
}
inline bool of_segments(Skin skin) { return skin == Skin::segments || skin == Skin::closed_segments; }
inline bool lives_in(Skin skin, Space space) {
  return of_segments(skin) || space == Space::line || space == Space::plane;
}

inline std::shared_ptr<const Material> skin_law(Skin skin, Space space) {
  const auto carried = [](auto law) {
    law->youngs_modulus = 1.5;
    law->density = 1;
    return law;
  };
  if (skin == Skin::uniaxial) return carried(std::make_shared<UniaxialMembrane>());
  if (skin == Skin::plane_stress) {
    const auto law = carried(std::make_shared<PlaneStressMembrane>());
    law->poissons_ratio = 0.3;
    return law;
  }
  auto law = carried(std::make_shared<SegmentMembrane>());
  law->section = 0.02;
  law->closed = skin == Skin::closed_segments;
  law->revolved = space == Space::axisymmetric;
  law->poissons_ratio = law->revolved ? 0.3 : 0.0;
  return law;
}

inline double distance(const Place& a, const Place& b, int dim) {
  double square = 0;
  for (int d = 0; d < dim; ++d) square += (b[d] - a[d]) * (b[d] - a[d]);
  return std::sqrt(square);
}

// A membrane of unit density through the places, at rest and undeformed. volume: of each point, of a ring its section.
inline Body skin_body(Skin skin, Space space, const std::vector<Place>& places, double volume) {
  const bool rings = space == Space::axisymmetric;
  Body body = make_body("membrane", skin_law(skin, space), static_cast<int>(places.size()), dim_of(space), rings);
  for (std::size_t p = 0; p < places.size(); ++p) {
    const Place &a = places[p], &b = places[(p + 1) % places.size()];
    for (int d = 0; d < dim_of(space); ++d) body.points(column::position, d)[p] = a[d];
    body.points(column::mass)[p] = body.points(column::volume)[p] = rings ? volume * a[0] : volume;
    if (!of_segments(skin)) continue;
    body.points(column::rest_length)[p] = distance(a, b, dim_of(space));
    if (rings) body.points(column::rest_radius)[p] = 0.5 * (a[0] + b[0]);
  }
  return body;
}

// A winding membrane of 12 points with random velocities and strains, partly taut and partly slack.
inline Body rough_skin(Skin skin, Space space, double shift_x = 0) {
  std::vector<Place> places;
  for (int k = 0; k < 12; ++k) {
    places.push_back({shift_x + 0.13 + 0.0223 * k, 0.21 + 0.07 * std::sin(0.9 * k), 0.19 + 0.05 * std::cos(1.1 * k)});
  }
  Body body = skin_body(skin, space, places, 0.02 * 0.0223);
  Random random(23);
  for (int p = 0; p < 12; ++p) {
    for (int d = 0; d < dim_of(space); ++d) body.points(column::velocity, d)[p] = random(-0.3, 0.3);
    if (of_segments(skin))
      body.points(column::rest_length)[p] *= 1 + random(-0.1, 0.1);
    else
      body.points(column::strain)[p] = random(-0.1, 0.1);
    if (body.points.has(column::rest_radius)) body.points(column::rest_radius)[p] *= 1 + random(-0.1, 0.1);
  }
  return body;
}

// Rough gas, slow and cool enough to stay on the grid for a while, with a rough membrane in its midst, or shifted along
// x: in a closed box or in empty space, without gravity.
inline Scene gas_and_skin(Skin skin, Space space, const std::string& shape, const std::string& transfer, bool walled,
                          double shift = 0, const IdealGas& gas = rough_law()) {
  Scene scene = walled ? rough_gas(space, shape, transfer, no_gravity, gas)
                       : rough_gas_in_space(space, shape, transfer, no_gravity, gas);
  for (std::size_t d = 0; d < static_cast<std::size_t>(scene.grid.dim); ++d) {
    for (Wall& wall : scene.grid.walls[d]) {
      if (walled && wall == Wall::free) wall = Wall::symmetry;
    }
    if (walled) continue;
    const int margin = 2;  // cells
    scene.grid.origin[d] -= margin * scene.grid.h;
    scene.grid.cells[d] += 2 * margin;
  }
  Columns& points = scene.bodies[0].points;
  for (int p = 0; p < points.points(); ++p) points(column::energy)[p] *= 0.1;
  scene.bodies.push_back(rough_skin(skin, space, shift + (space == Space::axisymmetric && !walled ? 0.5 : 0)));
  return scene;
}
// The same shift, by which part of the membrane stands beyond the gas.
inline double half_out(Space space) { return space == Space::solid ? 0.15 : 0.35; }

// What the points have of a column, sum_p, or of its product with another.
inline double sum_of(const Body& body, const ColumnId& id) {
  double sum = 0;
  for (int p = 0; p < body.points.points(); ++p) sum += body.points(id)[p];
  return sum;
}

// N_ip of one place by node, far from walls; nodes by their numbers along the axes.
using Node = std::array<int, 3>;
template <class Shape>
std::map<Node, double> weights_at(const GridSpec& grid, const Place& place) {
  std::map<Node, double> all{{{0, 0, 0}, 1.0}};
  for (std::size_t d = 0; d < static_cast<std::size_t>(grid.dim); ++d) {
    double local, n[Shape::support];
    const int anchor = Shape::anchor((place[d] - grid.origin[d]) / grid.h, grid.cells[d], local);
    Shape::weights(local, n);
    std::map<Node, double> more;
    for (const auto& [node, weight] : all) {
      for (int k = 0; k < Shape::support; ++k) {
        Node next = node;
        next[d] = anchor + Shape::first + k;
        more[next] = weight * n[k];
      }
    }
    all = std::move(more);
  }
  return all;
}
inline std::map<Node, double> weights_at(const std::string& shape, const GridSpec& grid, const Place& place) {
  return shape == "cubic" ? weights_at<Cubic>(grid, place) : weights_at<Quadratic>(grid, place);
}

// Where the points of a body stand, by number, `after` seconds of their own velocities later.
inline std::vector<Place> places_of(const Body& body, int dim, double after = 0) {
  std::vector<Place> places(body.id.size(), Place{0, 0, 0});
  for (int d = 0; d < dim; ++d) {
    const auto x = by_id(body, column::position, d), v = by_id(body, column::velocity, d);
    for (std::size_t p = 0; p < places.size(); ++p) places[p][static_cast<std::size_t>(d)] = x[p] + after * v[p];
  }
  return places;
}

// sum_i N_ip u_i, u_i = sum_q m_q u_q N_iq / sum_q m_q N_iq: what nodes see of a quantity per mass.
inline std::vector<double> seen_by_nodes(const std::string& shape, const GridSpec& grid,
                                         const std::vector<Place>& places, const std::vector<double>& mass,
                                         const std::vector<double>& value) {
  std::map<Node, double> total, sum;
  for (std::size_t p = 0; p < places.size(); ++p) {
    for (const auto& [node, n] : weights_at(shape, grid, places[p])) {
      total[node] += n * mass[p];
      sum[node] += n * mass[p] * value[p];
    }
  }
  std::vector<double> seen(places.size(), 0.0);
  for (std::size_t p = 0; p < places.size(); ++p) {
    for (const auto& [node, n] : weights_at(shape, grid, places[p])) {
      if (n != 0) seen[p] += n * sum[node] / total[node];
    }
  }
  return seen;
}

}  // namespace plumbline::scenes
