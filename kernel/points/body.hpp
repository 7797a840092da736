// A body: points of one material that share a velocity field.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kernel/materials/material.hpp"
#include "kernel/points/columns.hpp"

namespace plumbline {

struct Body {
  std::string name;
  std::string field = "common";  // the velocity field it moves with; bodies in contact name their own
  std::shared_ptr<const Material> material;
  Columns points;
  std::vector<int> id;          // a point's number as the scene made it, 0 ... points - 1; stays when points are sorted
  std::vector<int> split_from;  // of the points that came later, in the order of their numbers: whose half each is
  bool chain = false;           // points stand in the order of their connectivity and are never sorted
};

// A body of `points` points with the columns that every body has and those the material, as it is now, asks for.
// dim: 1, 2 or 3; axisymmetric: with dim 2 only.
Body make_body(std::string name, std::shared_ptr<const Material> material, int points, int dim,
               bool axisymmetric = false);

}  // namespace plumbline
