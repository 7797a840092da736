// York's five points, one a cell, and how their energy goes. York, section 8.5.
#pragma once

#include <string>
#include <vector>

#include "cases/harness/description/measures.hpp"
#include "cases/harness/laboratory/patch.hpp"

namespace plumbline {

struct YorkBar {
  static constexpr int points = 5, kicked = 2;  // from 0
  static constexpr double youngs_modulus = 1e6, density = 1, kick = 1e-8, end_time = 0.03;
  static constexpr double wave_speed = 1e3, courant_step = 1e-3;  // c, h/c
  double offset = 0.5;                                            // of the points in their cells of 1 m
  bool held = true;                                               // the nodes at both ends

  // At rest.
  Patch patch() const;
};

// The steps of Fig. 91 over h/c. at: "centres", "sides".
std::vector<double> york_steps(const std::string& at);
double york_offset(const std::string& at);  // 0.5, 1e-4

// Total energy over that of the kick after each step of York's scheme, 0.03 s long.
std::vector<double> energy_history(const YorkBar& bar, double courant);

// The same bar in a loop of its own, as York's input may hold its ends: nodal velocities there are set to zero after
// forces have acted and after the second map, but not before. Points then see the node stopped in every step.
class LateHeldBar {
 public:
  LateHeldBar(double offset, double courant) : offset_(offset), courant_(courant) {}
  // v and eps of all points, in units of c.
  std::vector<double> step(const std::vector<double>& state) const;
  double spectral_radius() const;
  std::vector<double> energy_history() const;

 private:
  double offset_, courant_;
};

// Histories of several steps drawn against one time axis; what leaves York's axis, 1e-15 J, is drawn at its end.
Profile energy_profile(const std::vector<double>& courants, const std::vector<std::vector<double>>& histories);

}  // namespace plumbline
