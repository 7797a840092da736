#include "cases/catalog/coupled/grid_convergence.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace plumbline {

GridConvergence grid_convergence(std::vector<std::pair<double, double>> levels, double order) {
  std::sort(levels.begin(), levels.end());
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  const bool repeated = std::adjacent_find(levels.begin(), levels.end(), same) != levels.end();
  if (levels.size() < 3 || repeated || !(levels.front().first > 0)) {
    throw std::invalid_argument("a grid convergence needs three levels of different h > 0");
  }
  const auto n = static_cast<double>(levels.size());
  double mean_x = 0, mean_f = 0;
  for (const auto& [h, f] : levels) {
    mean_x += std::pow(h, order) / n;
    mean_f += f / n;
  }
  double xx = 0, xf = 0;
  for (const auto& [h, f] : levels) {
    const double x = std::pow(h, order) - mean_x;
    xx += x * x;
    xf += x * (f - mean_f);
  }
  GridConvergence result;
  result.finest = levels.front().second;
  result.slope = xf / xx;
  result.limit = mean_f - result.slope * mean_x;
  const auto fitted = [&](double h) { return result.limit + result.slope * std::pow(h, order); };
  double squares = 0;
  for (const auto& [h, f] : levels) squares += (f - fitted(h)) * (f - fitted(h));
  const double at = fitted(levels.front().first), sigma = std::sqrt(squares / (n - 2));
  result.uncertainty = 1.25 * std::abs(at - result.limit) + sigma + std::abs(result.finest - at);  // [GCI 1]
  return result;
}

}  // namespace plumbline
