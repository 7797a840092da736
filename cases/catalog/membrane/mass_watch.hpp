// A mass at the lower end of points on a line that hang from a fixed support, watched while it bounces.
#pragma once

#include <span>
#include <vector>

#include "cases/harness/run/extremes.hpp"
#include "kernel/scene.hpp"
#include "kernel/simulation.hpp"

namespace plumbline {

class Archive;

constexpr double support = 2.0;  // height of the fixed top of the grid, m [York 5.5]

// The line below the support in cells of h, without bodies.
Scene scene_below_support(double h, double gravity);

struct MassWatch {
  double start;                                       // height of the mass at t = 0, m
  std::vector<double> times = {}, displacement = {};  // s; m, positive downwards
  std::vector<double> kinetic = {}, elastic = {};     // energies of all points, J

  explicit MassWatch(const Body& body);        // as it starts; its last point carries the mass
  void observe(const Simulation& simulation);  // of its first body
  void history(Archive& archive);
};

// NaN where there is no maximum.
double largest_maximum(std::span<const Extreme> extremes);

}  // namespace plumbline
