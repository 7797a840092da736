#include "cases/catalog/gas/gas_case.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

namespace plumbline {

const std::vector<Override> york_points{{"ppc", 3.0}};

Override york_step(const Settings&) { return {"cfl", 0.021}; }

std::function<std::unique_ptr<Problem>(const Settings&)> gas_run(std::function<GasFlow(const Settings&)> flow_of) {
  return [flow_of = std::move(flow_of)](const Settings& settings) { return gas_problem(flow_of(settings), settings); };
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

CaseGate same_numbers_gate(const std::string& study, const std::string& as, double level) {
  const auto largest_difference = [as, level](const StudyResult& s) {
    const StudyLevel *here = s.level(level), *there = s.sibling(as)->level(level);
    double largest = here && there ? 0 : std::nan("");
    for (const char* field : {"density", "velocity", "pressure", "energy"}) {
      for (const char* norm : {".L1", ".L2", ".Linf"}) {
        const Measure *a = here ? here->run.find(std::string(field) + norm) : nullptr,
                      *b = there ? there->run.find(std::string(field) + norm) : nullptr;
        largest = larger(largest, a && b ? std::abs(a->error / b->error - 1) : std::nan(""));
      }
    }
    return Measured::of(largest);
  };
  const std::string at = to_text(level);
  return gate(study + "/as-" + as + "-" + at,
              number_of("largest relative difference of the errors' norms to those of " + as + " at " + at,
                        largest_difference, {level}),
              at_most(1e-10),
              identity("sums across the flow are one but for rounding, 1e-16 a step and point; steps carry it on "
                       "and jumps sharpen it, 1e6 times at most"))
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
