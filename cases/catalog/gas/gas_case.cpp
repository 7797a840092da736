#include "cases/catalog/gas/gas_case.hpp"

#include <cmath>

namespace plumbline {

std::vector<Override> york_points(const std::string& scheme) {
  if (scheme == "york1997") return {{"ppc", 3.0}};
  return {};
}

void york_step(Settings& settings, const std::string& scheme) {
  if (scheme == "york1997" && !settings.is_set("dt") && !settings.is_set("cfl")) settings.set("cfl", 0.021, "gas");
}

std::vector<CaseGate> required_order(const std::string& study, const std::string& measure, double order,
                                     const std::string& reason) {
  const std::string id = study + "/" + measure.substr(0, measure.find('.'));
  return {fitted_order_gate(study, measure, declare(id + "-order", {order, {}}, Origin::requirement, reason)),
          order_gate(study, measure,
                     declare(id + "-order-interval", {order - 0.1, {}}, Origin::requirement,
                             "the low end of the 95 % interval of the fit, 0.1 below what the estimate must reach"))};
}

CaseGate energy_gate(const std::string& study) {
  return drift_gate(study,
                    declare(study + "/drift", {{}, 1e-12}, Origin::identity,
                            "the step closes the energy ledger to rounding; 1e-12 is 1e4 units in the last place"));
}

CaseGate same_numbers_gate(const std::string& study, const std::string& as, double level) {
  CaseGate g = study_gate(
      study,
      declare(study + "/as-" + as + "-" + to_text(level), {{}, 1e-10}, Origin::identity,
              "sums across the flow are one but for rounding, 1e-16 a step and point; steps carry it on and jumps "
              "sharpen it, 1e6 times at most"),
      [as, level](const StudyResult& s) {
        Measured measured;
        const StudyLevel *here = s.level(level), *there = s.sibling(as)->level(level);
        double largest = here && there ? 0 : std::nan("");
        for (const char* field : {"density", "velocity", "pressure", "energy"}) {
          for (const char* norm : {".L1", ".L2", ".Linf"}) {
            const Measure *a = here ? here->run.find(std::string(field) + norm) : nullptr,
                          *b = there ? there->run.find(std::string(field) + norm) : nullptr;
            largest = larger(largest, a && b ? std::abs(a->error / b->error - 1) : std::nan(""));
          }
        }
        measured.value = largest;
        return measured;
      },
      {level});
  g.gate.quantity = "largest relative difference of the errors' norms to those of " + as + " at " + to_text(level);
  g.also = {as};
  return g;
}

CaseGate coverage_gate(const std::string& study, double level) {
  return value_gate(study, "coverage", level,
                    declare(study + "/coverage-" + to_text(level), {0.99, 1.01}, Origin::theory,
                            "volumes of all points against their space; a kernel of three cells blurs each of three "
                            "waves by less than 0.3 % of the tube at 100 cells"));
}

}  // namespace plumbline
