#include "cases/stability/orders_in_time.hpp"

#include <cmath>

#include "cases/harness/order.hpp"

namespace plumbline {
namespace {

using Table = std::map<std::string, OrdersInTheory>;

// Symplectic Euler, leapfrogs, Runge-Kutta methods. central-difference leaves velocities half a step behind: they are off by
// dt/2 times the acceleration. energy holds the stress over a step.
const Table& without_maps() {
  static const Table table{{"usf", {1, 1}},
                           {"usl", {1, 1}},
                           {"musl", {1, 1}},
                           {"energy", {1, 1}},
                           {"usavg", {2, 2}},
                           {"leapfrog", {2, 2}},
                           {"midpoint", {2, 2}},
                           {"central-difference", {2, 1}},
                           {"ssp-rk3", {3, 3}},
                           {"rk4", {4, 4}},
                           {"generalized-alpha", {2, 2}},
                           {"implicit-midpoint", {2, 2}}};
  return table;
}

std::optional<OrdersInTheory> entry_of(const Table& table, const std::string& integrator) {
  const auto found = table.find(integrator);
  return found == table.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::optional<OrdersInTheory> orders_on_oscillator(const std::string& integrator) {
  return entry_of(without_maps(), integrator);
}

// FLIP changes orders where points strain with velocities of nodes that their own do not map to: those of the middle of a
// step, off by dt/2 (1 - P) a. (usl is of first order anyway.) leapfrog and energy refuse FLIP.
std::optional<OrdersInTheory> orders_on_wave(const std::string& integrator) {
  if (integrator == "midpoint") return OrdersInTheory{1, 1};
  if (integrator == "leapfrog" || integrator == "energy") return std::nullopt;
  return orders_on_oscillator(integrator);
}

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
