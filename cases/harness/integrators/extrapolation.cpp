#include "cases/harness/integrators/extrapolation.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cases/harness/description/measures.hpp"

namespace plumbline {
namespace {

double largest(const std::vector<double>& values) {
  double found = 0;
  for (const double value : values) found = larger(found, std::abs(value));
  return found;
}

}  // namespace

StepLimit limit_of_halvings(const std::vector<std::vector<double>>& values) {
  if (values.size() < 3) throw std::invalid_argument("a limit needs three step sizes");
  const std::size_t last = values.size() - 1;
  StepLimit limit;
  limit.finest = largest(values[last]);
  limit.before = largest(values[last - 2]);
  // `column` holds entries j of all rows k >= j; its last two are compared.
  std::vector<std::vector<double>> column = values;
  limit.uncertainty = HUGE_VAL;
  for (std::size_t j = 0; column.size() >= 2; ++j) {
    const std::vector<double>&fine = column.back(), &coarse = column[column.size() - 2];
    double change = 0;
    for (std::size_t i = 0; i < fine.size(); ++i) change = larger(change, std::abs(fine[i] - coarse[i]));
    if (!(change >= limit.uncertainty)) {
      limit.uncertainty = change;
      limit.size = largest(fine);
    }
    std::vector<std::vector<double>> next;
    const double weight = 1 / (std::ldexp(1.0, static_cast<int>(j) + 1) - 1);
    for (std::size_t k = 1; k < column.size(); ++k) {
      next.push_back(column[k]);
      for (std::size_t i = 0; i < next.back().size(); ++i) next.back()[i] += weight * (column[k][i] - column[k - 1][i]);
    }
    column = std::move(next);
  }
  return limit;
}

}  // namespace plumbline
