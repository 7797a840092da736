#pragma once
// Tubes with an exact solution, on which the numerical solvers are judged, and the mean errors they make there.
#include <cmath>
#include <string>
#include <vector>

#include "reference/gas_problem.hpp"
#include "reference/riemann.hpp"

namespace plumbline::reference {

struct RiemannTube {
  std::string name;
  RiemannProblem problem;
  double diaphragm, end_time;
  GasProblem gas(double low = 0, double high = 1) const {
    return riemann_tube(problem, diaphragm, end_time, low, high);
  }
};

/// Toro, 3rd ed., table 4.1 and section 6.4: data, diaphragm and time. Test 1 is his; Sod's is York's.
inline std::vector<RiemannTube> toro_tubes() {
  return {{"toro-1", {{1, 0.75, 1}, {0.125, 0, 0.1}, 1.4}, 0.3, 0.2},
          {"toro-2", {{1, -2, 0.4}, {1, 2, 0.4}, 1.4}, 0.5, 0.15},
          {"toro-3", {{1, 0, 1000}, {1, 0, 0.01}, 1.4}, 0.5, 0.012},
          {"toro-4", {{5.99924, 19.5975, 460.894}, {5.99242, -6.19633, 46.0950}, 1.4}, 0.4, 0.035},
          {"toro-5", {{1, -19.59745, 1000}, {1, -19.59745, 0.01}, 1.4}, 0.8, 0.012}};
}
inline RiemannTube sod_tube() { return {"sod", {{1, 0, 1}, {0.125, 0, 0.1}, 1.4}, 0.5, 0.143}; }

class ExactTube {
 public:
  explicit ExactTube(const RiemannTube& tube) : tube_(tube), solution_(tube.problem) {}
  Sample sample(double x) const { return solution_.sample((x - tube_.diaphragm) / tube_.end_time); }
  GasState operator()(double x) const {
    const Sample s = sample(x);
    return {s.density.value, s.velocity.value, s.pressure.value};
  }

 private:
  RiemannTube tube_;
  RiemannSolution solution_;
};

/// Mean |error| of `at(x)` (GasFields) against `exact(x)` (Sample) over [low, high] by 20000 midpoints.
template <class At, class Exact>
GasFields mean_distance(const At& at, const Exact& exact, double low, double high) {
  GasFields sum;
  const int points = 20000;
  for (int i = 0; i < points; ++i) {
    const double x = low + (high - low) * (i + 0.5) / points;
    const GasFields a = at(x);
    const Sample b = exact(x);
    sum.density += std::abs(a.density - b.density.value) / points;
    sum.velocity += std::abs(a.velocity - b.velocity.value) / points;
    sum.pressure += std::abs(a.pressure - b.pressure.value) / points;
    sum.energy += std::abs(a.energy - b.energy.value) / points;
  }
  return sum;
}

}  // namespace plumbline::reference
