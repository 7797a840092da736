#include "cases/harness/judge/undeclared.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "cases/harness/run/judged_at_end.hpp"
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

// Where `plumbline stability` finds a limit of waves it is a Courant number below 3: omega dt is at most 2.83 for explicit
// methods [Butcher 2016, 4th-order Runge-Kutta], and a mesh whose highest frequency were below c/h would not resolve a cell.
constexpr double far_above = 4;

Measured largest_courant_number(const StudyResult& study) {
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

// The least error of a field over the one that the start has there; none where the start is near in every field, or a final
// state is not what is judged.
constexpr double far_from_start = 0.3;  // of the field's size
std::optional<double> error_over_start(const Case& entry, const RunResult& run) {
  const auto problem = entry.problem(run.settings);
  if (!dynamic_cast<const JudgedAtEnd*>(problem.get())) return {};
  std::optional<double> least;
  for (const Measure& start : measures_of_start(*problem, run.settings)) {
    const Measure* const own = run.find(start.name);
    if (!own || !start.name.ends_with(".L1") || start.scale <= start.reference_bound) continue;
    if (start.error <= far_from_start * start.scale) continue;
    // The start may have no point where the end is judged, and then no error.
    const double ratio = std::isfinite(start.error) ? own->error / start.error : 0;
    if (!least || ratio < *least) least = ratio;
  }
  return least;
}

// The largest of all runs that arrived.
Measured error_over_start(const StudyResult& study) {
  Measured measured;
  for (const StudyLevel& at : study.levels) {
    if (!at.run.finished) continue;
    if (const auto ratio = error_over_start(*study.entry, at.run))
      measured.value = larger(measured.value.value_or(0), *ratio);
  }
  return measured;
}

}  // namespace

std::vector<CaseGate> undeclared_gates(const StudyResult& study) {
  const std::string id = study.plan.id;
  std::vector<CaseGate> gates{
      gate(id + "/errors", number_of("largest error over the size of its reference", largest_error), at_most(3.0),
           theory("what is at most twice as large as its reference is at most three of its sizes away")),
      gate(id + "/step", number_of("Courant number", largest_courant_number), at_most(far_above),
           theory("explicit methods lose stability at Courant numbers below 3"))};
  if (const Measured of_start = error_over_start(study); of_start.value) {
    gates.push_back(gate(
        id + "/computed",
        number_of("least error of a field over that of the start", [of_start](const StudyResult&) { return of_start; }),
        at_most(1 - 1e-6), theory("some field is nearer to its reference than the start is, or nothing was computed")));
  }
  return gates;
}

}  // namespace plumbline
