// Radial modes of oscillation, of rings and spheres with gas inside: how a run starts with one, and how much of it there is.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "kernel/scene.hpp"

namespace plumbline {

// Displacement per displacement of the membrane, and its gradient, 1/m, [component][direction], at a place in the plane (z = 0) or in space.
struct ModeAt {
  std::array<double, 3> displacement{};
  std::array<std::array<double, 3>, 3> gradient{};
};

// A mode u(r) of radial displacement about the origin.
class RadialMode {
 public:
  // u and u' at a radius r > 0; u(0) = 0.
  using Profile = std::function<std::array<double, 2>(double r)>;
  explicit RadialMode(Profile profile) : profile_(std::move(profile)) {}
  ModeAt at(const std::array<double, 3>& place) const;

 private:
  Profile profile_;
};

// Gives all bodies the velocity of a mode, `velocity` at the membrane, and with affine transfers its gradient.
void start_mode(Scene& scene, const RadialMode& mode, double velocity);

// The share of a mode in the velocities of all points: sum m v . phi / sum m phi^2, phi the mode's displacement where
// the points were at the start. Modes are orthogonal under the mass of gas and membrane together.
class ModeShare {
 public:
  ModeShare(const Scene& start, const RadialMode& mode);
  double of(const Scene& scene) const;  // m/s, at the membrane

 private:
  std::vector<std::vector<std::array<double, 3>>> shapes_;  // by body and id
  double weight_ = 0;
};

}  // namespace plumbline
