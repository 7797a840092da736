// A body: points of one material that share a velocity field.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/materials/material.hpp"
#include "kernel/points/columns.hpp"

namespace plumbline {

// The space that a gas has, where a membrane bounds it: the polygon of a chain's points, closed through `corners`
// from the chain's last point to its first. In the plane or axisymmetric.
struct Enclosure {
  std::string chain;                                // name of the body
  std::vector<std::array<double, 2>> corners = {};  // m, at walls and on the axis
};

struct Body {
  std::string name;
  std::string field = "common";  // the velocity field it moves with; bodies in contact name their own
  std::shared_ptr<const Material> material;
  Columns points;
  std::vector<int> id;          // a point's number as the scene made it, 0 ... points - 1; stays when points are sorted
  std::vector<int> split_from;  // of the points that came later, in the order of their numbers: whose half each is
  // Body force per mass of the points at a time (s): sets the column body_force, m/s^2. Beside Scene::gravity. May be empty.
  std::function<void(double time, Columns& points, std::span<const int> id)> load;
  std::optional<Enclosure>
      enclosure;       // of a gas with the density method `grid`: its volumes fill this space [Coupling 4]
  double spacing = 0;  // between neighbouring points, m; 0: the edge of a cube of the point's volume
  bool chain = false;  // points stand in the order of their connectivity and are never sorted
};

// A body of `points` points with the columns that every body has and those the material, as it is now, asks for.
// dim: 1, 2 or 3; axisymmetric: with dim 2 only.
Body make_body(std::string name, std::shared_ptr<const Material> material, int points, int dim,
               bool axisymmetric = false);

// Distance of point p from its neighbours, m: Body::spacing, or the edge of a cube of its volume.
double point_spacing(const Body& body, int p, int dim, bool axisymmetric);

}  // namespace plumbline
