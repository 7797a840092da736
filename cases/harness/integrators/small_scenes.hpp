// Small scenes on which integrators are compared: smooth states, points that stay in their cells, so that what a step does
// depends on its size smoothly. Lengths in cells, speeds of compression waves, densities and cell sizes are about one.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/harness/integrators/measured_limit.hpp"
#include "kernel/scene.hpp"

namespace plumbline {

// How velocities are mapped.
struct Maps {
  std::string shape, transfer;
};

struct SmallScene {
  std::string name, what;
  double end = 2;               // h/c
  std::function<Scene()> make;  // maps are chosen by whoever runs it
  Maps maps = {};
  // What may be left of a difference between integrators for dt -> 0: rounding and kinks; of filtered waves what the filter
  // takes of them in one step, a share (k h)^4.
  double left_over = most_left_over;
  bool variable_steps = false;  // steps alternate between 1 and 0.7 of a size
};

// Solids, gases and membranes, on a line, in the plane, on rings and in space, with walls, gravity, loads and two bodies.
const std::vector<SmallScene>& small_scenes();
const SmallScene& small_scene(const std::string& name);  // std::out_of_range

// The scene under its maps. Throws CannotWork where the integrator cannot work so.
Scene workable(const SmallScene& scene, const std::string& integrator);

// The scene without a filter, or with one where the integrator needs that or points drift: for what holds under either.
SmallScene with_some_maps(SmallScene scene, const std::string& integrator);

// What a plate of solid on the two walls of a corner looks like when the axes are exchanged, or mirrored at x = mirror.
Scene with_axes_exchanged(Scene scene);
Scene mirrored(Scene scene);

}  // namespace plumbline
