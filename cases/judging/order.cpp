// Of which order the error falls with the step.
#include <cmath>

#include "cases/harness/order.hpp"
#include "cases/judging/integrator_gates.hpp"
#include "cases/judging/pairs.hpp"
#include "cases/laboratory/problem.hpp"

namespace plumbline {
namespace {

using Orders = std::map<std::string, MeasuredOrder>;

constexpr double least_order = 0.9;  // 1, and 0.1 for steps that are not yet small
constexpr const char* usual_causes =
    "a force, strain or motion that is not dt times its rate (order 0), or one that is taken at another instant than "
    "assumed (an order less than expected)";

Measured as_measured(const MeasuredOrder& order) {
  Measured measured;
  measured.inconclusive = !std::isfinite(order.order) || !std::isfinite(order.low);
  if (measured.inconclusive) {
    measured.note = "too few steps above rounding for an order";
    return measured;
  }
  measured.value = order.order;
  measured.interval = {order.low, order.high};
  return measured;
}

// Of a laboratory problem that measures orders of the integrator alone.
const Orders& orders_on(const std::string& problem, const Subject& subject) {
  return subject.once<Orders>("orders/" + problem, [&] {
    const StabilityProblem& entry = find_stability_problem(problem);
    std::vector<Override> overrides{{"integrator", subject.name()}};
    for (const auto& [key, value] : subject.choice().parameters) overrides.emplace_back(key, value);
    return entry.orders(stability_settings(entry, "default", overrides));
  });
}

Measured order_on(const std::string& problem, const std::string& field, const Subject& subject) {
  const Orders& orders = orders_on(problem, subject);
  const auto found = orders.find(field);
  if (found != orders.end()) return as_measured(found->second);
  Measured none;
  none.invalid = true;
  none.note = "no order of " + field + " is measured on " + problem;
  return none;
}

// How the difference from a consistent integrator falls: with the lower of the two orders.
Measured order_of_difference(const Subject& subject) {
  std::vector<Level> levels;
  const bool unfiltered = lacks(subject.entry(), "quadratic", "flip").empty();
  const SmallScene& scene = small_scene(unfiltered ? "bar" : "bar-filtered");
  for (int k = 0, steps = 16; k < 6; ++k, steps *= 2) {
    double sum = 0;
    const std::vector<double> difference = difference_at(subject, scene, steps);
    for (const double d : difference) sum += d * d;
    Level level;
    level.h = scene.end / steps;
    level.error = std::sqrt(sum / static_cast<double>(difference.size()));
    level.rounding = 1.1e-16 * steps;
    levels.push_back(level);
  }
  return measured_order(fit_order(levels, Weighting::equal));
}

IntegratorGate order_row(const std::string& name, const std::string& quantity, double least, const std::string& why,
                         std::function<Measured(const Subject&)> measure, Effort effort) {
  IntegratorGate row{"order", gate_row("order", name, quantity, {least, {}}, Origin::theory, why), usual_causes,
                     std::move(measure), effort};
  row.gate.order = true;
  return row;
}

struct ClaimedProblem {
  const char *of, *problem;
  Effort effort;
};
constexpr ClaimedProblem claimed_problems[] = {{"oscillator", "oscillator", Effort::core},
                                               {"fixed mesh", "wave", Effort::whole}};

}  // namespace

std::vector<IntegratorGate> order_gates(const Subject& subject) {
  std::vector<IntegratorGate> all;
  for (const char* field : {"displacement", "velocity"}) {
    all.push_back(order_row(
        std::string("oscillator/") + field, std::string("order in dt of the ") + field, least_order,
        "a consistent scheme is of order 1 at least; 0.1 for steps that are not yet small",
        [field](const Subject& s) { return order_on("oscillator", field, s); }, Effort::core));
  }
  all.push_back(
      order_row("difference/bar", "order in dt of the difference from a consistent integrator", least_order,
                "differences of consistent schemes fall with order 1 at least; 0.1 for steps that are not yet small",
                order_of_difference, Effort::whole));
  for (const OrderClaim& claim : subject.claims().orders) {
    for (const ClaimedProblem& at : claimed_problems) {
      if (claim.of != at.of) continue;
      const std::string problem = at.problem, field = claim.field;
      all.push_back(order_row(
          "claimed/" + problem + "/" + field, "order in dt of the " + field + ", " + claim.of, claim.order - 0.1,
          "claimed by the integrator, less 0.1",
          [problem, field](const Subject& s) { return order_on(problem, field, s); }, at.effort));
    }
  }
  return all;
}

}  // namespace plumbline
