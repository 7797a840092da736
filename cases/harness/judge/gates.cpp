#include "cases/harness/judge/gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plumbline {

std::optional<Measured> stop_of(const RunResult& run) {
  if (!run.stop) return std::nullopt;
  Measured measured;
  measured.stopped = Measured::Stop{run.stop->step, run.stop->field};
  measured.note = run.stop->reason;
  return measured;
}

namespace {

// What to say of a study whose run at some level stopped.
std::optional<Measured> stopped_level(const StudyResult& study) {
  for (const StudyLevel& at : study.levels) {
    if (std::optional<Measured> stop = stop_of(at.run)) return stop;
  }
  return std::nullopt;
}

// Calls read(run, measure) for the measure at a level; a stopped run or a missing level or measure says so.
template <class Read>
Measured at_level(const StudyResult& study, const std::string& measure, double level, Read&& read) {
  const StudyLevel* at = study.level(level);
  if (!at) return Measured::failed(fmt::format("the study has no level {}", level));
  if (const std::optional<Measured> stop = stop_of(at->run)) return *stop;
  const Measure* found = at->run.find(measure);
  if (!found) return Measured::failed(fmt::format("the run has no measure {}", measure));
  return read(at->run, *found);
}

}  // namespace

CaseGate gate(std::string id, Number number, Range expected, Because because) {
  CaseGate made;
  made.study = id.substr(0, id.find('/'));
  made.gate.id = std::move(id);
  made.gate.quantity = std::move(number.quantity);
  made.gate.expected = expected;
  made.gate.origin = because.origin;
  made.gate.reason = std::move(because.reason);
  made.gate.order = number.interval;
  made.levels = std::move(number.levels);
  made.measure = std::move(number.measure);
  return made;
}

CaseGate recorded(std::string id, Number number, double value, double share, std::string stamp, std::string reason) {
  const double margin = share * std::abs(value);
  CaseGate made = gate(std::move(id), std::move(number), between(value - margin, value + margin),
                       {Origin::regression, std::move(reason)});
  made.gate.measured_on = std::move(stamp);
  return made;
}

Range at_most(double high) { return {{}, high}; }
Range at_least(double low) { return {low, {}}; }
Range between(double low, double high) { return {low, high}; }
Range exactly(double value) { return {value, value}; }

Because theory(std::string reason) { return {Origin::theory, std::move(reason)}; }
Because literature(std::string reason) { return {Origin::literature, std::move(reason)}; }
Because reference_bound(std::string reason) { return {Origin::reference_bound, std::move(reason)}; }
Because identity(std::string reason) { return {Origin::identity, std::move(reason)}; }
Because requirement(std::string reason) { return {Origin::requirement, std::move(reason)}; }
Because reference_run(std::string reason) { return {Origin::regression, std::move(reason)}; }

Number number_at(std::string quantity, const std::string& measure, double level,
                 std::function<Measured(const RunResult&, const Measure&)> read) {
  return {std::move(quantity), [=](const StudyResult& s) { return at_level(s, measure, level, read); }, {level}};
}

Number number_of(std::string quantity, std::function<Measured(const StudyResult&)> read, std::vector<double> levels) {
  return {std::move(quantity), std::move(read), std::move(levels)};
}

Number largest_difference(const std::string& quantity, const std::string& as, double level,
                          const std::vector<std::string>& fields,
                          double (*difference)(const Measure& here, const Measure& there)) {
  const auto largest = [=](const StudyResult& s) {
    const StudyLevel *here = s.level(level), *there = s.sibling(as)->level(level);
    double found = here && there ? 0 : std::nan("");
    for (const std::string& field : fields) {
      for (const char* norm : {".L1", ".L2", ".Linf"}) {
        const Measure *a = here ? here->run.find(field + norm) : nullptr,
                      *b = there ? there->run.find(field + norm) : nullptr;
        found = larger(found, a && b ? difference(*a, *b) : std::nan(""));
      }
    }
    return Measured::of(found);
  };
  return number_of(fmt::format("largest {} to those of {} at {}", quantity, as, level), largest, {level});
}

Number error_at(const std::string& measure, double level) {
  return number_at(fmt::format("{} at {}", measure, level), measure, level, [](const RunResult&, const Measure& m) {
    Measured measured;
    measured.value = m.error;
    measured.reference_bound = m.reference_bound;
    measured.scale = m.scale;
    return measured;
  });
}

Number value_at(const std::string& measure, double level) {
  return number_at(fmt::format("value of {} at {}", measure, level), measure, level,
                   [measure](const RunResult&, const Measure& m) {
                     if (!m.value) return Measured::failed(measure + " has no value");
                     Measured measured;
                     measured.value = *m.value;
                     measured.scale = m.scale;
                     return measured;
                   });
}

Number ratio_of(const std::string& measure, double level, double over) {
  return {fmt::format("{} at {} over {}", measure, level, over),
          [=](const StudyResult& s) {
            return at_level(s, measure, level, [&](const RunResult&, const Measure& a) {
              return at_level(s, measure, over, [&](const RunResult&, const Measure& b) {
                Measured measured;
                measured.value = a.error / b.error;
                measured.reference_bound = (a.reference_bound + *measured.value * b.reference_bound) / b.error;
                measured.scale = 1;
                return measured;
              });
            });
          },
          {level, over}};
}

Number order_of(const std::string& measure) {
  Number number = number_of("order of " + measure, [=](const StudyResult& s) {
    if (const auto stopped = stopped_level(s)) return *stopped;
    const OrderFit* fit = s.fit(measure);
    return fit ? measured_order(*fit) : Measured::failed("no fit of " + measure);
  });
  number.interval = true;
  return number;
}

Number fitted_order_of(const std::string& measure) {
  return number_of("fitted order of " + measure, [=](const StudyResult& s) {
    if (const auto stopped = stopped_level(s)) return *stopped;
    const OrderFit* fit = s.fit(measure);
    if (!fit || fit->invalid) return Measured::failed("no fit of " + measure);
    Measured measured = measured_order(*fit);
    measured.inconclusive = !fit->usable;
    return measured;
  });
}

Number energy_drift() {
  return number_of("relative drift of energy", [](const StudyResult& s) {
    if (s.levels.empty()) return Measured::failed("the study has no runs");
    Measured measured;
    double largest = 0;
    for (const StudyLevel& at : s.levels) largest = larger(largest, at.run.ledger.energy.relative_drift(false));
    measured.value = largest;
    return measured;
  });
}

Number stopped_run() {
  return number_of("runs that stopped", [](const StudyResult& s) {
    const RunResult& run = s.levels.front().run;
    Measured measured = Measured::of(run.finished ? 0.0 : 1.0);
    if (run.stop) measured.stopped = Measured::Stop{run.stop->step, run.stop->field};
    return measured;
  });
}

std::vector<CaseGate> joined(std::initializer_list<std::vector<CaseGate>> lists) {
  std::vector<CaseGate> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

namespace {

// The largest of read(run) over all runs of the study; NaN wins.
template <class Read>
std::function<Measured(const StudyResult&)> largest_over_runs(Read read) {
  return [read](const StudyResult& s) {
    if (s.levels.empty()) return Measured::failed("the study has no runs");
    Measured measured;
    double largest = 0;
    const auto take = [&](const RunResult& run) { largest = larger(largest, read(run)); };
    for (const StudyLevel& at : s.levels) {
      take(at.run);
      for (const RunResult& other : at.offsets) take(other);
    }
    measured.value = largest;
    return measured;
  };
}

CaseGate held_exactly(std::string id, std::string quantity, std::string reason,
                      std::function<Measured(const StudyResult&)> measure) {
  return gate(std::move(id), number_of(std::move(quantity), std::move(measure)), at_most(1e-12),
              identity(std::move(reason)));
}

// The first measure of a run that is no number though the case gives no reason why it may be none; empty if there is none.
std::string undefined_measure(const Case& entry, const RunResult& run) {
  for (const Measure& m : run.measures) {
    if (!std::isfinite(m.error) && entry.may_be_undefined.count(m.name) == 0) return m.name;
  }
  return "";
}

// How many runs of a study stopped; the note says where and why, and which measure is no number.
Measured stopped_runs(const StudyResult& s) {
  if (s.levels.empty()) return Measured::failed("the study has no runs");
  Measured measured = Measured::of(0);
  const auto look = [&](const RunResult& run) {
    *measured.value += run.finished ? 0 : 1;
    if (run.stop) {
      measured.note = fmt::format("stopped at step {} in {}: {}", run.stop->step, run.stop->field, run.stop->reason);
    } else if (const std::string name = undefined_measure(*s.entry, run); !name.empty()) {
      measured.invalid = true;
      measured.note = fmt::format("{} is not a number", name);
      if (run.settings.has("cells")) measured.note += fmt::format(" at {} cells", run.settings.number("cells"));
    }
  };
  for (const StudyLevel& at : s.levels) {
    look(at.run);
    for (const RunResult& other : at.offsets) look(other);
  }
  return measured;
}

// A drift over what the steps of the run may round, where that is more than 1e-12.
double over_rounding(const RunResult& run, double drift) {
  const double rounding = static_cast<double>(run.steps) * std::numeric_limits<double>::epsilon();
  return drift / std::max(1.0, rounding / 1e-12);
}

}  // namespace

// 1e-12: a sum over n points has a relative rounding of about sqrt(n) 1e-16, and no run here has above 1e7 of them;
// flows carry a correction, so their sums over steps add nothing. The points' velocities do: each step rounds them once, by
// 2^-53, which is 2^-52 of kinetic energy, and steps that add the same, as in free fall, round alike. So n steps may add
// n 2^-52, more than 1e-12 beyond 4500 steps. The weakest seeded bug, one weight off by 5e-3, shows at 1e-3.
std::vector<CaseGate> generic_gates(const std::string& study, int dim, bool axisymmetric) {
  const std::string why = "exact but for rounding: sqrt(n) 1e-16 for sums over n <= 1e7 points";
  const std::string long_runs = why + "; beyond 4500 steps, over what they round, steps/4500";
  const auto momentum = [](const RunResult& r) {
    double drift = 0;
    for (int d = 0; d < r.dim; ++d)
      drift = larger(drift, r.ledger.momentum[static_cast<std::size_t>(d)].relative_drift(true));
    return over_rounding(r, drift);
  };
  const auto angular_momentum = [](const RunResult& r) {
    double drift = 0;
    for (const Account& a : r.ledger.angular_momentum) drift = larger(drift, a.relative_drift(true));
    return over_rounding(r, drift);
  };
  std::vector<CaseGate> gates{
      gate(study + "/finite", number_of("runs that stopped", stopped_runs), exactly(0),
           identity("every run arrives at its end with admissible values, and its measures are numbers"))};
  if (dim == 0) return gates;
  gates.push_back(held_exactly(
      study + "/mass", "relative difference of grid mass and point mass", "shape functions sum to one, " + why,
      largest_over_runs([](const RunResult& r) { return r.ledger.mass.relative_drift(false); })));
  gates.push_back(held_exactly(study + "/momentum", "relative drift of momentum",
                               "shape gradients sum to zero, " + long_runs, largest_over_runs(momentum)));
  if (dim > 1 && !axisymmetric) {
    gates.push_back(held_exactly(study + "/angular-momentum", "relative drift of angular momentum",
                                 "stresses are symmetric and every transfer is booked, " + long_runs,
                                 largest_over_runs(angular_momentum)));
  }
  gates.push_back(held_exactly(
      study + "/ledger", "relative residual of the energy ledger",
      "every exchange of energy is booked by its own formula, " + long_runs,
      largest_over_runs([](const RunResult& r) { return over_rounding(r, r.ledger.energy.relative_drift(false)); })));
  return gates;
}

std::vector<JudgedGate> judge_gates(const std::vector<CaseGate>& gates, const StudyResult& study) {
  std::vector<JudgedGate> judged;
  for (const CaseGate& declared : gates) {
    bool complete = true;
    for (const double level : declared.levels) complete = complete && study.level(level);
    for (const std::string& other : declared.also) complete = complete && study.sibling(other);
    if (!complete && study.failure.empty()) continue;
    JudgedGate result;
    result.gate = declared.gate;
    result.case_name = study.entry->name;
    result.scheme = study.scheme;
    result.study = study.plan.id;
    try {
      result.measured = study.failure.empty() ? declared.measure(study) : Measured::failed(study.failure);
    } catch (const std::exception& error) {
      result.measured = Measured::failed(error.what());
    }
    result.judgement = judge(declared.gate, result.measured);
    for (const StudyLevel& at : study.levels) {
      const bool read = declared.levels.empty() ||
                        std::find(declared.levels.begin(), declared.levels.end(), at.value) != declared.levels.end();
      if (read) result.run_ids.push_back(at.run.file);
    }
    judged.push_back(std::move(result));
  }
  return judged;
}

}  // namespace plumbline
