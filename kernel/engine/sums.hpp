// What loops over points sum up: values that add, chunk by chunk, in an order that no thread changes.
#pragma once

#include <array>

#include "kernel/survey.hpp"

namespace plumbline {

using Turn = std::array<double, 3>;  // about x, y, z

// Of points that moved.
struct MotionSums {
  double lost = 0;                     // energy of the grid's motion that points do not take, J
  Turn torque{}, moved{};              // angular momentum: what points do not take, what their motion adds, kg m^2/s
  Turn reflected{}, reflected_turn{};  // momenta given by walls that sent points back
  int too_far = -1;                    // first point that moved more than a cell
  MotionSums& operator+=(const MotionSums& o) {
    lost += o.lost;
    for (std::size_t k = 0; k < 3; ++k) {
      torque[k] += o.torque[k];
      moved[k] += o.moved[k];
      reflected[k] += o.reflected[k];
      reflected_turn[k] += o.reflected_turn[k];
    }
    if (too_far < 0) too_far = o.too_far;
    return *this;
  }
  friend MotionSums operator+(MotionSums a, const MotionSums& b) { return a += b; }
};

// Of the maps of a step's start: what they lose, J, and what hoop stress adds to the radial momentum, N.
struct StartSums {
  double lost = 0, hoop_force = 0;
  StartSums& operator+=(const StartSums& o) {
    lost += o.lost;
    hoop_force += o.hoop_force;
    return *this;
  }
  friend StartSums operator+(StartSums a, const StartSums& b) { return a += b; }
};

// Of strained points, J: the work of the stresses, what of it is viscous, and what the materials store.
struct PowerSums {
  double power = 0, viscous = 0, stored = 0;
  PowerSums& operator+=(const PowerSums& o) {
    power += o.power;
    viscous += o.viscous;
    stored += o.stored;
    return *this;
  }
  friend PowerSums operator+(PowerSums a, const PowerSums& b) { return a += b; }
};

}  // namespace plumbline
