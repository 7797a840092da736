// An elastic bar on a line against an exact motion of linear elasticity.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "cases/harness/description/case.hpp"
#include "reference/bounded.hpp"

namespace plumbline {

// Exact state of the particle that stands at X in the unstretched bar. Tension positive.
struct BarSample {
  reference::Bounded displacement, velocity, stress;
};

// The bar is [0, length] on the grid's x axis; energies per unit section.
struct ElasticBar {
  double youngs_modulus = 1, density = 1, length = 1;  // Pa, kg/m^3, m
  bool fixed = false;                                  // at x = 0; else both ends are free
  double margin = 0;                                   // room beyond a free end, m
  std::function<BarSample(double x, double time)> exact;
  std::function<double(double x)> velocity_gradient;  // at the start, where it is smooth; else empty: zero
  // Further measures, of the histories over the steps.
  struct History {
    std::vector<double> time, mean_velocity, displacement_error, energy;
  };
  std::function<std::vector<Measure>(const History&)> further;
};

// Points start in the exact state of t = 0. Measures:
//   displacement, velocity, stress: .L1 .L2 .Linf at the end, points judged as particles
//   displacement.worst              largest over the steps of sqrt(sum_p V_p e_p^2), m^1.5
//   energy_rise                     largest rise of the energy of the points in a step, over that of the start
//   energy_lost                     share of it that is gone at the end
std::unique_ptr<Problem> elastic_bar_problem(ElasticBar bar, const Settings& settings);

}  // namespace plumbline
