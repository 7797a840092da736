// Which nodal arrays the bodies of a scene put their mass on, and what a scene must be for a geometry.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "kernel/contact/pair_potential.hpp"
#include "kernel/engine/discretisation.hpp"
#include "kernel/stages.hpp"

namespace plumbline {

// Bodies that name the same field share it.
template <int dim>
struct Layout {
  using Field = VelocityField<dim>;
  std::vector<Body>& bodies;
  std::vector<Field> fields = {};
  std::vector<std::size_t> field_of_body = {};
  std::vector<Weights<dim>> weights = {};  // of each body's points
  std::vector<bool> own_mass = {};         // per body: what its field has mapped, or of gas, is its mass alone

  // Whether forces of a body's pressures are corrected. [Quadrature 2]
  template <class Space>
  bool corrected(const Space& space, std::size_t body) const {
    return space.corrects(bodies[body], own_mass[body]);
  }
  Field& field(std::size_t body) { return fields[field_of_body[body]]; }
  static const std::vector<typename Field::Vec>& velocity(const Field& field, NodalVelocity which) {
    if (which == NodalVelocity::remapped && field.remapped.empty()) {
      throw std::logic_error("a remapped velocity is wanted: map_momentum comes first");
    }
    switch (which) {
      case NodalVelocity::end:
        return field.end;
      case NodalVelocity::midpoint:
        return field.midpoint;
      case NodalVelocity::remapped:
        return field.remapped;
      default:
        return field.start;
    }
  }

  // Without its weights a stage would read and write anywhere.
  void want_places(const char* stage) const {
    if (std::all_of(weights.begin(), weights.end(), [](const auto& at) { return at.known(); })) return;
    throw std::logic_error(std::string(stage) + " wants the points located: locate_points comes first");
  }
  bool places_kept() const {
    return std::any_of(weights.begin(), weights.end(), [](const auto& at) { return at.kept(); });
  }
};

template <int dim>
Layout<dim> layout_of(std::vector<Body>& bodies, const Grid<dim>& grid) {
  Layout<dim> layout{bodies};
  std::vector<std::string> names;
  for (const Body& body : bodies) {
    const auto found = std::find(names.begin(), names.end(), body.field);
    layout.field_of_body.push_back(static_cast<std::size_t>(found - names.begin()));
    if (found == names.end()) {
      names.push_back(body.field);
      layout.fields.emplace_back(grid);
    }
    layout.weights.emplace_back();
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    int companions = 0, gases = 0;  // of the same field
    for (std::size_t o = 0; o < bodies.size(); ++o) {
      if (o == b || layout.field_of_body[o] != layout.field_of_body[b]) continue;
      ++companions;
      gases += bodies[o].material->takes_heat();
    }
    const bool gas = bodies[b].material->takes_heat();
    VelocityField<dim>& field = layout.fields[layout.field_of_body[b]];
    if (!field.mixed() && (gas ? gases < companions : gases > 0)) field.add_gas_arrays(grid);
    layout.own_mass.push_back(gases == 0);
  }
  return layout;
}

// A body made for another dimension or geometry would be read beyond its columns.
template <class Geometry>
void refuse_other_geometry(const Body& body) {
  constexpr int dim = Geometry::dim;
  if (body.points.points() == 0) return;
  const auto expect = [&](const ColumnId& id, int components) {
    const int found = body.points.components(id);
    if (found == components) return;
    throw std::invalid_argument("body " + body.name + " has " + std::to_string(found) + " components of " + id.name() +
                                "; its material and the grid's geometry want " + std::to_string(components));
  };
  expect(column::position, dim);
  expect(column::velocity, dim);
  expect(column::stress, stress_components(body.material->measure(), dim, Geometry::axisymmetric));
  const bool tangents = body.material->measure() != StressMeasure::point_force;
  if (body.chain && tangents && (Geometry::axisymmetric || dim > 2)) {
    throw std::invalid_argument("body " + body.name + ": a chain of membrane points lives on a line or in the plane");
  }
}

// What shapes cannot do whose weights are those of the points' places at the start.
template <class Geometry>
void refuse_weights_of_start(const Scene& scene) {
  const auto refuse = [&](const std::string& why) {
    throw std::invalid_argument("the shape " + scene.shape + " " + why);
  };
  if (Geometry::axisymmetric) refuse("works on a line, in the plane and in space, not about an axis");
  if (scene.contact != "none" && scene.bodies.size() > 1 && !meets_by_pairs(scene)) {
    refuse("cannot work with the contact law " + scene.contact +
           ": nodes are shared by points that stood beside each other "
           "at the start");
  }
  if (!scene.pistons.empty()) refuse("cannot work with pistons, which find their nodes where they stand now");
  for (const Body& body : scene.bodies) {
    const Material& material = *body.material;
    if (material.takes_heat() || material.has_density() || body.chain || material.surface()) {
      refuse("is one of solids, which body " + body.name + " is not");
    }
  }
}

// What the parts of a scene want of each other. Throws std::invalid_argument.
template <class Geometry>
void refuse_what_cannot_work(const Scene& scene, const Discretisation<Geometry>& space) {
  if ((space.transfer.keep > 0 || space.transfer.order > 0) && !scene.pistons.empty()) {
    throw std::invalid_argument("pistons cannot work with the transfer " + scene.transfer +
                                ": its points do not take the velocity that a piston gives its nodes");
  }
  // Moving points without their velocities changes the inertia of boxes, and with it energy that is nobody's.
  if (space.transfer.affine && !space.shape.fixed_inertia && scene.chain_relaxation > 0) {
    throw std::invalid_argument("chains cannot be relaxed with the shape " + scene.shape + " and the transfer " +
                                scene.transfer + ": the affine inertia of points would change as they are moved");
  }
  if (space.shape.at_start) refuse_weights_of_start<Geometry>(scene);
  if (!space.pressure.none() && !shape_named(scene.shape).flows) {
    throw std::invalid_argument("pressures of gases cannot act at the nodes with the shape " + scene.shape +
                                ": the integrals of its kernels, by which points would move, are not known");
  }
  for (const Body& body : scene.bodies) {
    refuse_other_geometry<Geometry>(body);
    if (body.enclosure && Geometry::dim != 2) {
      throw std::invalid_argument("body " + body.name +
                                  ": only in two dimensions does a chain of points enclose a gas");
    }
    if (body.enclosure && scene.density != DensityMethod::grid) {
      throw std::invalid_argument("body " + body.name + ": an enclosed gas needs the density method grid");
    }
  }
}

}  // namespace plumbline
