#include "cases/catalog/stability/orders_in_time.hpp"

#include <cmath>

#include "cases/harness/verdict/order.hpp"

namespace plumbline {

std::map<std::string, MeasuredOrder> orders_in_time(const std::vector<std::string>& quantities, double t, int steps,
                                                    int halvings, double bound,
                                                    const std::function<std::vector<double>(int steps)>& error_of) {
  std::vector<std::vector<Level>> levels(quantities.size());
  for (int k = 0; k <= halvings; ++k, steps *= 2) {
    const std::vector<double> errors = error_of(steps);
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      Level level;
      level.h = t / steps;
      level.error = errors[q];
      level.rounding = 1.1e-16 * std::sqrt(steps);  // half a unit a step, adding up as a random walk does
      level.reference_bound = bound;
      levels[q].push_back(level);
    }
  }
  std::map<std::string, MeasuredOrder> orders;
  for (std::size_t q = 0; q < quantities.size(); ++q) {
    const OrderFit fit = fit_order(levels[q], Weighting::equal);
    orders[quantities[q]] = {fit.order, fit.low, fit.high};
  }
  return orders;
}

}  // namespace plumbline
