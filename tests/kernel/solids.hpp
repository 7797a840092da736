// Small solid bodies for the tests of the kernel, one for every elastic law.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "kernel/materials/linear_elastic.hpp"
#include "kernel/materials/neo_hookean.hpp"
#include "kernel/materials/segment_membrane.hpp"
#include "tests/kernel/scenes.hpp"

namespace plumbline::scenes {

enum class Law { hooke, plane_stress, neo_hookean, segments, closed_segments };
inline constexpr Law laws[] = {Law::hooke, Law::plane_stress, Law::neo_hookean, Law::segments, Law::closed_segments};
inline std::ostream& operator<<(std::ostream& out, Law law) {
  constexpr const char* names[] = {"hooke", "plane_stress", "neo_hookean", "segments", "closed_segments"};
  return out << names[static_cast<int>(law)];
}
inline bool is_chain(Law law) { return law == Law::segments || law == Law::closed_segments; }
// Chains live on lines, in the plane and in space; plane stress in the plane alone.
inline bool lives_in(Law law, Space space) {
  if (law == Law::plane_stress) return space == Space::plane;
  return !is_chain(law) || space != Space::axisymmetric;
}

// rho_0 = 1, waves of a speed of one to two.
inline std::shared_ptr<const Material> material_of(Law law) {
  if (law == Law::neo_hookean) {
    auto material = std::make_shared<NeoHookean>();
    material->youngs_modulus = 1.5;
    material->poissons_ratio = 0.3;
    material->density = 1;
    return material;
  }
  if (is_chain(law)) {
    auto material = std::make_shared<SegmentMembrane>();
    material->youngs_modulus = 1.5;
    material->density = 1;
    material->section = 0.02;
    material->closed = law == Law::closed_segments;
    return material;
  }
  auto material = std::make_shared<LinearElastic>();
  material->youngs_modulus = 1.5;
  material->poissons_ratio = 0.3;
  material->density = 1;
  material->plane_stress = law == Law::plane_stress;
  return material;
}

// A body of the law at given places, at rest and undeformed. volume: of each point, of a ring its section.
inline Body solid_body(Law law, Space space, const std::vector<Place>& places, double volume) {
  const bool rings = space == Space::axisymmetric;
  Body body = make_body("solid", material_of(law), static_cast<int>(places.size()), dim_of(space), rings);
  for (std::size_t p = 0; p < places.size(); ++p) {
    for (int d = 0; d < dim_of(space); ++d) body.points(column::position, d)[p] = places[p][d];
    body.points(column::mass)[p] = body.points(column::volume)[p] = rings ? volume * places[p][0] : volume;
  }
  if (!is_chain(law)) return body;
  for (std::size_t p = 0; p < places.size(); ++p) {
    const Place &a = places[p], &b = places[(p + 1) % places.size()];
    double square = 0;
    for (int d = 0; d < dim_of(space); ++d) square += (b[d] - a[d]) * (b[d] - a[d]);
    body.points(column::rest_length)[p] = std::sqrt(square);
  }
  return body;
}

// Random strains, all components of them; segments partly taut and partly slack. [York 5.2]
inline void strain_at_random(Body& body, Law law, double amplitude) {
  Random random(21);
  Columns& points = body.points;
  const ColumnId& id = is_chain(law)             ? column::rest_length
                       : law == Law::neo_hookean ? column::deformation
                                                 : column::strain;
  for (int p = 0; p < points.points(); ++p) {
    for (int k = 0; k < points.components(id); ++k) {
      const double change = random(-amplitude, amplitude);
      if (is_chain(law))
        points(id)[p] *= 1 + change;
      else
        points(id, k)[p] += change;
    }
  }
}

// In the places and with the velocities of a rough gas; chains wind through the same box. Strained at random.
inline Scene rough_solid(Law law, const Scene& gas, double strain = 0.1) {
  Scene scene = gas;
  const Space space = space_of(gas.grid);
  const Columns& from = gas.bodies[0].points;
  std::vector<Place> places(static_cast<std::size_t>(from.points()));
  for (std::size_t p = 0; p < places.size(); ++p) {
    for (int d = 0; d < dim_of(space); ++d) places[p][d] = from(column::position, d)[p];
  }
  double volume = from(column::volume)[0] / (space == Space::axisymmetric ? places[0][0] : 1);
  if (is_chain(law)) {
    places.clear();
    // Neither here nor in the motions of the tests does a point stand on a node line: see LinearShapes in solids_test.cpp.
    for (int k = 0; k < 12; ++k) {
      places.push_back({0.13 + 0.0223 * k, 0.21 + 0.07 * std::sin(0.9 * k), 0.187 + 0.05 * std::cos(1.1 * k)});
    }
    volume = 0.02 * 0.0223;
  }
  scene.bodies = {solid_body(law, space, places, volume)};
  Columns& points = scene.bodies[0].points;
  Random random(22);
  for (int d = 0; d < dim_of(space); ++d) {
    for (int p = 0; p < points.points(); ++p) points(column::velocity, d)[p] = random(-0.3, 0.3);
  }
  strain_at_random(scene.bodies[0], law, strain);
  return scene;
}

// Its body, of one of the two laws of finite bodies, takes nu = 0.45 and lets cells share dilatation: lambda = 9 mu.
inline void let_hardly_compress(Scene& scene) {
  scene.mean_dilatation = true;
  const auto changed = [](auto material) {
    material.poissons_ratio = 0.45;
    return std::make_shared<decltype(material)>(material);
  };
  std::shared_ptr<const Material>& material = scene.bodies[0].material;
  if (const auto* neo = dynamic_cast<const NeoHookean*>(material.get())) material = changed(*neo);
  if (const auto* hooke = dynamic_cast<const LinearElastic*>(material.get())) material = changed(*hooke);
}

}  // namespace plumbline::scenes
