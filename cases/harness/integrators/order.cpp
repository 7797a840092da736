// Of which order the error falls with the step.
#include <algorithm>
#include <array>
#include <cmath>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/integrators/integrator_gates.hpp"
#include "cases/harness/integrators/pairs.hpp"
#include "cases/harness/laboratory/problem.hpp"
#include "cases/harness/verdict/order.hpp"
#include "cases/harness/verify/verification.hpp"

namespace plumbline {
namespace {

using Orders = std::map<std::string, MeasuredOrder>;

constexpr double least_order = 0.9;  // 1, and 0.1 for steps that are not yet small
constexpr const char* causes_of_lost_order =
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
  const bool unfiltered = !subject.traits().drifts && lacks(subject.entry(), "quadratic", "flip").empty();
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
  if (levels.back().error == 0) {
    Measured none;
    none.inconclusive = true;
    none.note = "the same as the consistent integrator beside it, to the bit";
    return none;
  }
  return measured_order(fit_order(levels, Weighting::equal));
}

IntegratorGate order_row(const std::string& name, const std::string& quantity, double least, const std::string& why,
                         std::function<Measured(const Subject&)> measure, Effort effort) {
  IntegratorGate row{"order", gate_row("order", name, quantity, {least, {}}, Origin::theory, why), causes_of_lost_order,
                     std::move(measure), effort};
  row.gate.order = true;
  return row;
}

// The case under FLIP, mesh and step refined together.
Measured order_under_refinement(const std::string& case_name, const std::string& field, const Subject& subject) {
  const Case& entry = find_case(case_name);
  StudyPlan plan = integrator_plan(entry, subject.name());
  plan.values = {16, 24, 32, 48, 64};
  plan.overrides.emplace_back("transfer", "flip");
  for (const auto& [key, value] : subject.choice().parameters) plan.overrides.emplace_back(key, value);
  const StudyResult study = run_study(entry, plan, planned_runs(entry, plan, Tier::quick), 1);
  const OrderFit* fit = study.fit(field + ".L2");
  Measured measured = plain(fit ? fit->order : std::nan(""));
  measured.invalid = !fit || fit->invalid;
  if (fit)
    measured.interval = {fit->low, fit->high};
  else
    measured.note = case_name + " measures no " + field;
  return measured;
}

struct ClaimedProblem {
  const char *of, *problem;
  Measured (*order_of)(const std::string& problem, const std::string& field, const Subject&);
  Effort effort;
};
constexpr std::array<ClaimedProblem, 3> claimed_problems{
    {{"oscillator", "oscillator", order_on, Effort::core},
     {"fixed mesh", "wave", order_on, Effort::whole},
     {"h and dt", "mms-bar", order_under_refinement, Effort::whole}}};

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
    const auto at = std::find_if(claimed_problems.begin(), claimed_problems.end(),
                                 [&](const ClaimedProblem& one) { return claim.of == one.of; });
    if (at == claimed_problems.end()) {
      throw UsageError("orders", claim.of, "oscillator, fixed mesh, h and dt", {},
                       "a claim of integrator " + subject.name() + " is of no class of orders: '" + claim.of +
                           "' (known: oscillator, fixed mesh, h and dt)");
    }
    const auto order_of = at->order_of;
    const std::string problem = at->problem, field = claim.field;
    all.push_back(order_row(
        "claimed/" + problem + "/" + field, "order of the " + field + ", " + claim.of, claim.order - 0.1,
        "claimed by the integrator, less 0.1",
        [order_of, problem, field](const Subject& s) { return order_of(problem, field, s); }, at->effort));
  }
  return all;
}

}  // namespace plumbline
