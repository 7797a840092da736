#include "cases/harness/undeclared.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

// The largest error over its scale of all runs, and of which measure. A scale that the reference is not known to is none.
Measured largest_error(const StudyResult& study) {
  Measured measured;
  measured.value = 0;
  for (const StudyLevel& at : study.levels) {
    for (const Measure& m : at.run.measures) {
      if (!std::isfinite(m.error) || m.scale <= m.reference_bound || m.error / m.scale <= *measured.value) continue;
      measured.value = m.error / m.scale;
      measured.note = fmt::format("{} at {} cells", m.name, at.run.settings.number("cells"));
    }
  }
  return measured;
}

bool has_a_limit(const std::string& integrator) {
  const IntegratorEntry* entry = find_integrator(integrator);
  return !entry || entry->make()->claims().limit.value_or(0) < std::numeric_limits<double>::infinity();
}

// Limits of waves are Courant numbers below 3 for every method in `plumbline stability`: omega dt is at most 2.83 for explicit
// methods [Butcher 2016, 4th-order Runge-Kutta], and a mesh whose highest frequency were below c/h would not resolve a cell.
constexpr double far_above = 4;

Measured courant_number(const StudyResult& study) {
  Measured measured;
  measured.value = 0;
  for (const StudyLevel& at : study.levels) {
    if (has_a_limit(at.run.settings.text("integrator"))) measured.value = larger(*measured.value, at.run.courant);
  }
  measured.inconclusive = *measured.value > far_above;
  if (measured.inconclusive) {
    measured.note = fmt::format("a first step of {:g} h/c is far above every limit that `plumbline stability` finds",
                                *measured.value);
  }
  return measured;
}

Gate described(Gate gate, const char* quantity) {
  gate.quantity = quantity;
  return gate;
}

}  // namespace

std::vector<CaseGate> undeclared_gates(const std::string& study) {
  return {
      study_gate(study,
                 described(declare(study + "/errors", {{}, 3.0}, Origin::theory,
                                   "an error three times as large as the reference is one of a run that has lost it"),
                           "largest error over the size of its reference"),
                 largest_error),
      study_gate(study,
                 described(declare(study + "/step", {{}, far_above}, Origin::theory,
                                   "explicit methods lose stability at Courant numbers below 3"),
                           "Courant number"),
                 courant_number)};
}

}  // namespace plumbline
