// Tangents of membranes that do not know them by connectivity.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kernel/normals/normals.hpp"
#include "kernel/points/body.hpp"

namespace plumbline {

class MembraneTangents {
 public:
  // method: one of normals_methods(); throws std::invalid_argument for another.
  explicit MembraneTangents(const std::string& method);
  // Whether find() sets the tangent columns; with `connectivity` membranes do it themselves.
  static bool given_by(const std::string& method) { return method != "connectivity"; }
  // Sets the column `tangent` of every chain that has one, from where all points stand. In the plane.
  void find(const GridSpec& grid, std::vector<Body>& bodies);

 private:
  std::string method_;
  std::vector<std::unique_ptr<NormalsMethod>> methods_;  // of each body
  std::vector<double> normal_[2], gas_[2];
};

}  // namespace plumbline
