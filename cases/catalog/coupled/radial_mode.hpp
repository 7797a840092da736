// Radial modes of oscillation, of rings and spheres with gas inside: how a run starts with one, and how much of it there is.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cases/harness/description/archive.hpp"
#include "cases/harness/description/measures.hpp"
#include "kernel/scene.hpp"
#include "reference/bounded.hpp"

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

// A mode's share over a run that starts with it.
class ModeRecord {
 public:
  ModeRecord(RadialMode mode, double velocity) : mode_(std::move(mode)), times_{0}, shares_{velocity} {}

  // start: makes the scene of the start, which says where the points were; asked for once.
  void observe(double time, const Scene& now, const std::function<Scene()>& start);
  void history(Archive& archive);
  // "omega", rad/s, and "damping", over the critical one; not numbers where nothing swings.
  std::vector<Measure> measures(reference::Bounded omega) const;
  // The share and the exact one, at `where`: "ring".
  Profile profile(const std::string& where, double omega) const;

 private:
  RadialMode mode_;
  std::optional<ModeShare> share_;
  std::vector<double> times_, shares_;
};

}  // namespace plumbline
