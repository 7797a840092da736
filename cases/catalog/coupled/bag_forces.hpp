// Forces on a bag of revolution that no grid brings: the pressure outside, and a tether inside.
#pragma once

#include <array>
#include <vector>

#include "kernel/points/columns.hpp"

namespace plumbline {

// Derivative of the volume per radian that a chain of points from axis to axis bounds, of straight segments, with
// respect to each place: r of all points, then y; m^2. Positive outward where the chain runs counter-clockwise about
// the gas.
// V = sum over segments (a^2 + a b + b^2)/6 (y_b - y_a), a and b the radii of their ends.                 [Airbag 1]
std::vector<double> volume_gradient(const Columns& chain);

// Adds to the column body_force what a uniform pressure outside does, -p dV/dx_p / m_p: its work is -p times the change
// of the volume. pressure: Pa                                                                              [Airbag 1]
void add_outside_pressure(Columns& chain, double pressure);

// A sheet without mass from a ring on the bag down to a point of the axis; the gas does not feel it. One-way:
// T = k (d - L), d the distance from the ring to that point.                                               [Airbag 2]
struct Tether {
  int after = 0;                       // the ring lies between the points `after` and `after` + 1 of the chain,
  double share = 0;                    // at this share of the segment
  std::array<double, 2> anchor{0, 0};  // m
  double length = 0;                   // L, m
  double stiffness = 0;                // k, N/m per radian
};
// Adds its pull to the column body_force.
void add_tether(Columns& chain, const Tether& tether);
double tension(const Columns& chain, const Tether& tether);  // T, N per radian

}  // namespace plumbline
