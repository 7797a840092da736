// An elastic bar on a line against an exact motion of linear elasticity.
#pragma once

#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "cases/harness/description/case.hpp"
#include "cases/harness/description/parameters.hpp"
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
  double margin = 0;                                   // of the grid beyond a free end, m
  double end_time = 0;                                 // s
  std::function<BarSample(double x, double time)> exact = {};
  std::function<double(double x)> velocity_gradient = {};  // at the start, where it is smooth; else empty: zero
  // Further measures, of the histories over the steps.
  struct History {
    std::vector<double> time, mean_velocity, displacement_error, energy;
  };
  std::function<std::vector<Measure>(const History&)> further = {};
};

// The parameters of every bar, the values of its reference as defaults; whoever derives from it reads the end time.
template <class Reference>
struct BarParameters : Parameters {
  Reference bar;
  double end_time = 0;  // s

  explicit BarParameters(Parameters given) : Parameters(std::move(given)) {
    bar.youngs_modulus = positive("youngs_modulus", bar.youngs_modulus, "Pa", "E");
    bar.density = positive("initial_density", bar.density, "kg/m^3", "density");
    bar.length = positive("length", bar.length, "m", "length of the bar");
  }

  // The same bar, free at both ends, its motion to be given.
  ElasticBar elastic() const {
    return {.youngs_modulus = bar.youngs_modulus, .density = bar.density, .length = bar.length, .end_time = end_time};
  }
};

// displacement, velocity, stress: .L1 .L2 .Linf of a body along x, its points judged as particles. start: X by the
// point's number; stress: of point p.
std::vector<Measure> bar_norms(const Body& body, const std::vector<double>& start,
                               const std::function<BarSample(double x)>& exact,
                               const std::function<double(int p)>& stress);

// Points start in the exact state of t = 0. Measures:
//   bar_norms                       at the end
//   displacement.worst              largest over the steps of sqrt(sum_p V_p e_p^2), m^1.5
//   energy_rise                     largest rise of the energy of the points in a step, over that of the start
//   energy_lost                     share of it that is gone at the end
std::unique_ptr<Problem> elastic_bar_problem(ElasticBar bar, const Settings& settings);

}  // namespace plumbline
