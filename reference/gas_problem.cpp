#include "reference/gas_problem.hpp"

#include <algorithm>
#include <cmath>

#include "reference/parameter.hpp"

namespace plumbline::reference {

double shell_volume(double inner, double outer, int dimension) {
  const double sum = inner + outer;
  if (dimension == 1) return outer - inner;
  if (dimension == 2) return (outer - inner) * sum / 2;
  return (outer - inner) * (sum * sum - inner * outer) / 3;  // (outer^3 - inner^3)/3 without cancellation
}

GasState mean_state(const GasProblem& problem, double inner, double outer) {
  std::vector<double> ends = {inner};
  for (double jump : problem.jumps) {
    if (jump > inner && jump < outer) ends.push_back(jump);
  }
  ends.push_back(outer);
  std::sort(ends.begin(), ends.end());
  const double node = std::sqrt(0.6), nodes[] = {-node, 0, node}, weights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  double mass = 0, momentum = 0, energy = 0, volume = 0;
  for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece) {
    const double middle = (ends[piece] + ends[piece + 1]) / 2, half = (ends[piece + 1] - ends[piece]) / 2;
    for (int i = 0; i < 3; ++i) {
      const double x = middle + half * nodes[i], weight = 2 * half * weights[i] * std::pow(x, problem.dimension - 1);
      const GasState gas = problem.initial(x);
      volume += weight;
      mass += weight * gas.density;
      momentum += weight * gas.density * gas.velocity;
      energy += weight * (gas.pressure / (problem.gamma - 1) + gas.density * gas.velocity * gas.velocity / 2);
    }
  }
  const double velocity = momentum / mass;
  const double pressure = (problem.gamma - 1) * (energy - momentum * velocity / 2) / volume;
  return {mass / volume, velocity, std::max(pressure, 0.0)};  // a cold gas leaves rounding of either sign
}

void check_problem(const GasProblem& problem) {
  const double infinity = std::numeric_limits<double>::infinity();
  check({"gamma", 0, 1, infinity, true, true, "1", ""}, problem.gamma);
  check({"end_time", 0, 0, infinity, true, true, "s", ""}, problem.end_time);
  check({"dimension", 0, 1, 3, false, false, "1", ""}, problem.dimension);
  check({"low", 0, problem.dimension > 1 ? 0 : -infinity, problem.high, false, true, "m", ""}, problem.low);
}

GasProblem riemann_tube(const RiemannProblem& riemann, double diaphragm, double end_time, double low, double high,
                        GasBoundary ends) {
  auto initial = [=](double x) { return x < diaphragm ? riemann.left : riemann.right; };
  return {low, high, ends, ends, riemann.gamma, end_time, 1, initial, {diaphragm}, false};
}

GasProblem shu_osher_problem() {
  auto initial = [](double x) {
    return x < -4 ? GasState{3.857143, 2.629369, 10.33333} : GasState{1 + 0.2 * std::sin(5 * x), 0, 1};
  };
  return {-5, 5, GasBoundary::outflow, GasBoundary::outflow, 1.4, 1.8, 1, initial, {-4}, false};
}

GasProblem woodward_colella_problem() {
  auto initial = [](double x) { return GasState{1, 0, x < 0.1 ? 1000.0 : x < 0.9 ? 0.01 : 100.0}; };
  return {0, 1, GasBoundary::reflecting, GasBoundary::reflecting, 1.4, 0.038, 1, initial, {0.1, 0.9}, false};
}

GasProblem gas_expansion_problem(double radius, double end_time, int dimension) {
  auto initial = [](double) { return GasState{1, 0, 100}; };
  return {0, radius, GasBoundary::reflecting, GasBoundary::vacuum, 1.4, end_time, dimension, initial, {}, true};
}

}  // namespace plumbline::reference
