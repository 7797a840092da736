#include "cases/catalog/gas/gas_case.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace plumbline {

const std::vector<Override> york_points{{"ppc", 3.0}};

Override york_step(const Settings&) { return {"cfl", 0.021}; }

std::function<std::unique_ptr<Problem>(const Settings&)> gas_run(std::function<GasFlow(const Settings&)> flow_of) {
  return [flow_of = std::move(flow_of)](const Settings& settings) { return gas_problem(flow_of(settings), settings); };
}

GasFlow with_mirror_image(GasFlow flow) {
  const auto axis = static_cast<std::size_t>(flow.axis);
  const double wall = flow.low[axis], high = flow.high[axis];
  const double sign = flow.direction ? 1 : -1;  // of the image's velocity: one across the axis is the same
  const auto image = [wall](double s) { return 2 * wall - s; };
  flow.judged = Interval{wall, high};
  flow.low[axis] = image(high);
  flow.margin[0] = flow.margin[1];
  std::vector<double> jumps = flow.jumps;
  for (const double at : flow.jumps) jumps.insert(jumps.begin(), image(at));
  flow.jumps = jumps;
  flow.initial = [=, initial = flow.initial](double s) {
    if (s >= wall) return initial(s);
    reference::GasState state = initial(image(s));
    state.velocity *= sign;
    return state;
  };
  flow.exact = [=, exact = flow.exact](double s, double t) {
    if (s >= wall) return exact(s, t);
    reference::Sample at = exact(image(s), t);
    at.velocity.value *= sign;
    return at;
  };
  return flow;
}

std::vector<CaseGate> required_order(const std::string& study, const std::string& measure, double order,
                                     const std::string& reason) {
  const std::string id = study + "/" + measure.substr(0, measure.find('.'));
  return {gate(id + "-order", fitted_order_of(measure), at_least(order), requirement(reason)),
          gate(id + "-order-interval", order_of(measure), at_least(order - 0.1),
               requirement("the low end of the 95 % interval of the fit, 0.1 below what the estimate must reach"))};
}

CaseGate energy_gate(const std::string& study) {
  return gate(study + "/drift", energy_drift(), at_most(1e-12),
              identity("the step closes the energy ledger to rounding; 1e-12 is 1e4 units in the last place"));
}

namespace {

const std::vector<std::string> fields{"density", "velocity", "pressure", "energy"};

}  // namespace

CaseGate same_numbers_gate(const std::string& study, const std::string& as, double level) {
  return gate(study + "/as-" + as + "-" + to_text(level),
              largest_difference("relative difference of the errors' norms", as, level, fields,
                                 [](const Measure& a, const Measure& b) { return std::abs(a.error / b.error - 1); }),
              at_most(1e-10),
              identity("sums across the flow are one but for rounding, 1e-16 a step and point; steps carry it on "
                       "and jumps sharpen it, 1e6 times at most"))
      .beside({as});
}

CaseGate mirror_gate(const std::string& study, const std::string& as, double level) {
  return gate(
             study + "/as-" + as + "-" + to_text(level),
             largest_difference("difference of the errors' norms over the larger of the field's and its error's", as,
                                level, fields,
                                [](const Measure& a, const Measure& b) {
                                  return std::abs(a.error - b.error) / std::max(b.scale, b.error);
                                }),
             at_most(1e-9),
             identity(
                 "what a wall reflects is what the gas in its place is, but for rounding: 1e-16 of the gas is 1e-10 of "
                 "errors that are a millionth of it, and steps carry it on"))
      .beside({as});
}

double error_in(const StudyResult& s, const std::string& measure, double level) {
  const StudyLevel* at = s.level(level);
  const Measure* m = at ? at->run.find(measure) : nullptr;
  if (!m) throw std::runtime_error("study " + s.plan.id + " has no " + measure + " at " + to_text(level));
  return m->error;
}

Number error_over(const std::string& measure, const std::string& other, const std::string& named, double level) {
  return number_of(measure + " over that of " + named + ", at " + to_text(level),
                   [=](const StudyResult& s) {
                     return Measured::of(error_in(s, measure, level) / error_in(*s.sibling(other), measure, level));
                   },
                   {level});
}

CaseGate coverage_gate(const std::string& study, double level) {
  return gate(study + "/coverage-" + to_text(level), value_at("coverage", level), between(0.99, 1.01),
              theory("volumes of all points against their space; a kernel of three cells blurs each of three "
                     "waves by less than 0.3 % of the tube at 100 cells"));
}

}  // namespace plumbline
