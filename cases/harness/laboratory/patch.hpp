// A piece of a scene that repeats, and how its points repeat.
#pragma once

#include <array>
#include <vector>

#include "kernel/scene.hpp"

namespace plumbline {

// What lengths, speeds and densities of a scene are measured by, so that all numbers of a state are of order one.
struct Units {
  double length = 1, speed = 1, density = 1;  // m, m/s, kg/m^3; > 0
  double time() const { return length / speed; }
};

// How many periods of a lattice a patch holds: `core` of them, and `margin` more on every side.
struct Extent {
  int core = 1, margin = 0;
};

// A scene whose points form a lattice in 0 (all that there is), 1 or 2 directions. Every period has the same points, and
// lies to the grid as every other does.
struct Patch {
  using Period = std::array<int, 2>;
  struct Place {
    Period period{};  // the core: 0 ... Extent::core - 1 in each direction of the lattice
    int member = 0;   // which point of its period
  };

  Scene scene;
  Units units = {};
  int directions = 0;
  std::vector<std::vector<Place>> places = {};     // of each body's points by their numbers
  std::array<std::array<double, 3>, 2> step = {};  // from a period to the next, m
};

}  // namespace plumbline
