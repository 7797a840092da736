// Shapes that are wrong by known amounts, as gates of shapes see them.
#pragma once

#include <functional>
#include <memory>

#include "cases/harness/parts/shape_probe.hpp"

namespace plumbline {

// By how much each answer of a probe is wrong; all zero: by nothing. Lengths in cells.
struct ShapeFlaws {
  double value = 0;           // added to sum_i N_ip u_i
  double slope = 0;           // added to h times the gradient, of constant fields left out
  double constant_slope = 0;  // and of constant fields alone
  int direction = -1;         // along which gradients are wrong; -1: along all
  // Beyond the place `from` along the first direction, m: added to values, and a kink, from which on values rise by so much a
  // cell, and the gradient along the first direction with them.
  double from = 0, jump = 0, kink = 0;
  double inertia = 0;                                        // added to D_p / h^2
  double taken_velocity = 0, taken_slope = 0;                // added to the velocity, and to h C_p
  double volume = 0, blur = 0;                               // volumes times 1 + volume; added to the blur
  int lowest = 0;                                            // added to the lowest node along the first direction
  std::function<bool(const ProbePoint& point)> inside = {};  // what is said of a place
};

// A shape of the kernel, and the flaws.
std::unique_ptr<ShapeProbe> flawed(std::unique_ptr<ShapeProbe> shape, const ShapeFlaws& flaws);

// Relative, of what points put on the nodes and read off.
struct MapFlaws {
  double spread = 0, mass = 0, force = 0, density = 0, specific = 0, loss = 0;
};

// One node, whose weight is 1 everywhere and whose gradient is 1/m along all directions, or 0 around an axis: whatever
// points give or take is a sum over them.
std::unique_ptr<ShapeProbe> one_node(std::size_t geometry, const MapFlaws& flaws);

}  // namespace plumbline
