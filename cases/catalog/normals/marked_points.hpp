// Membrane points on a curve that knows its normals, and how far off each method's normals are.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cases/harness/judge/gates.hpp"

namespace plumbline {

// Points along a curve, in its order, with unit normals from the curve's formula. Lengths in m.
struct MarkedPoints {
  std::vector<double> x, y, normal_x, normal_y;
  std::vector<double> other_x, other_y;  // points inside the membrane, which carry colour
  int first = 0, judged = -1;            // the points judged: `judged` from `first` on; negative: all

  // (normal_x, normal_y): not zero, of any length.
  void add(double px, double py, double nx, double ny);
};

// Angle between two lines with unit normals a and b, degrees, 0 to 90: normals have no sign. 90 where a is
// no direction.
double angle_between(double ax, double ay, double bx, double by);

// How far rounding of the points alone can turn a normal, degrees: eps times the largest coordinate over the smallest
// distance between two points.
double rounding_of_normals(const MarkedPoints& points);

// A membrane at rest, without stress, for one step: what is measured are the normals of where its points stand, of
// every method: `<method>.max_angle_error_deg` and `<method>.mean_angle_error_deg`. The profile has the points,
// `judged` (1 or 0), the exact normals, and of each method the normals, turned to the side of the exact ones, and the
// angle between both.
std::unique_ptr<Problem> normals_problem(const Settings& settings, const GridSpec& grid, MarkedPoints points);

// `prefix`max_angle_error_deg and `prefix`mean_angle_error_deg of angles in degrees.
void add_angles(std::vector<Measure>& all, const std::string& prefix, const std::vector<double>& angles, double bound);

// Of normals as a drawn arrow would show them, degrees: half a millimetre at the end of an arrow of ten.
inline constexpr double drawn = 3;
inline const std::string as_drawn = "normals as a drawn arrow would show them, within three degrees";
inline const std::string undrawn = "at most 0.1 degrees, a thirtieth of what a drawn arrow shows";

// STUDY/METHOD-max, or another of its angles than the largest: at most `bound` degrees.
CaseGate angle_gate(const std::string& study, const std::string& method, double level, double bound, Because because,
                    const std::string& what = "max");

}  // namespace plumbline
