#include "cases/harness/judge/gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace plumbline {
namespace {

Measured failed(std::string note) {
  Measured measured;
  measured.invalid = true;
  measured.note = std::move(note);
  return measured;
}

// What to say of a study whose run at some level stopped.
std::optional<Measured> stopped_level(const StudyResult& study) {
  for (const StudyLevel& at : study.levels) {
    if (!at.run.stop) continue;
    Measured measured;
    measured.stopped = Measured::Stop{at.run.stop->step, at.run.stop->field};
    measured.note = at.run.stop->reason;
    return measured;
  }
  return std::nullopt;
}

// Calls read(run, measure) for the measure at a level; a stopped run or a missing level or measure says so.
template <class Read>
Measured at_level(const StudyResult& study, const std::string& measure, double level, Read&& read) {
  const StudyLevel* at = study.level(level);
  if (!at) return failed(fmt::format("the study has no level {}", level));
  if (at->run.stop) {
    Measured measured;
    measured.stopped = Measured::Stop{at->run.stop->step, at->run.stop->field};
    measured.note = at->run.stop->reason;
    return measured;
  }
  const Measure* found = at->run.find(measure);
  if (!found) return failed(fmt::format("the run has no measure {}", measure));
  return read(at->run, *found);
}

Gate named(Gate gate, const std::string& quantity) {
  gate.quantity = quantity;
  return gate;
}

}  // namespace

Gate declare(std::string id, Range expected, Origin origin, std::string reason) {
  Gate gate;
  gate.id = std::move(id);
  gate.expected = expected;
  gate.origin = origin;
  gate.reason = std::move(reason);
  return gate;
}

Gate expected_failure(Gate gate, std::string cause, Range band, std::string measured_on) {
  gate.expected_failure = ExpectedFailure{std::move(cause), band, {}, std::move(measured_on)};
  return gate;
}

Gate regression(std::string id, double value, double share, const std::string& stamp, std::string reason) {
  const double room = share * std::abs(value);
  Gate gate = declare(std::move(id), {value - room, value + room}, Origin::regression, std::move(reason));
  gate.measured_on = stamp;
  return gate;
}

CaseGate error_gate(std::string study, const std::string& measure, double level, Gate gate, Tier tier) {
  return {std::move(study),
          named(std::move(gate), fmt::format("{} at {}", measure, level)),
          {level},
          [=](const StudyResult& s) {
            return at_level(s, measure, level, [](const RunResult&, const Measure& m) {
              Measured measured;
              measured.value = m.error;
              measured.reference_bound = m.reference_bound;
              measured.scale = m.scale;
              return measured;
            });
          },
          tier};
}

CaseGate value_gate(std::string study, const std::string& measure, double level, Gate gate, Tier tier) {
  return {std::move(study),
          named(std::move(gate), fmt::format("value of {} at {}", measure, level)),
          {level},
          [=](const StudyResult& s) {
            return at_level(s, measure, level, [&](const RunResult&, const Measure& m) {
              if (!m.value) return failed(measure + " has no value");
              Measured measured;
              measured.value = *m.value;
              measured.scale = m.scale;
              return measured;
            });
          },
          tier};
}

CaseGate measure_gate(std::string study, Gate gate, const std::string& measure, double level,
                      std::function<Measured(const RunResult&, const Measure&)> read, Tier tier) {
  return study_gate(
      std::move(study), std::move(gate), [=](const StudyResult& s) { return at_level(s, measure, level, read); },
      {level}, tier);
}

CaseGate ratio_gate(std::string study, const std::string& measure, double level, double over, Gate gate, Tier tier) {
  const std::string quantity = fmt::format("{} at {} over {}", measure, level, over);
  return {std::move(study),
          named(std::move(gate), quantity),
          {level, over},
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
          tier};
}

CaseGate order_gate(std::string study, const std::string& measure, Gate gate, Tier tier) {
  gate.order = true;
  return study_gate(
      std::move(study), named(std::move(gate), "order of " + measure),
      [=](const StudyResult& s) {
        if (const auto stopped = stopped_level(s)) return *stopped;
        const OrderFit* fit = s.fit(measure);
        return fit ? measured_order(*fit) : failed("no fit of " + measure);
      },
      {}, tier);
}

CaseGate fitted_order_gate(std::string study, const std::string& measure, Gate gate, Tier tier) {
  return study_gate(
      std::move(study), named(std::move(gate), "fitted order of " + measure),
      [=](const StudyResult& s) {
        if (const auto stopped = stopped_level(s)) return *stopped;
        const OrderFit* fit = s.fit(measure);
        if (!fit || fit->invalid) return failed("no fit of " + measure);
        Measured measured = measured_order(*fit);
        measured.inconclusive = !fit->usable;
        return measured;
      },
      {}, tier);
}

CaseGate drift_gate(std::string study, Gate gate, Tier tier) {
  return study_gate(
      std::move(study), named(std::move(gate), "relative drift of energy"),
      [](const StudyResult& s) {
        if (s.levels.empty()) return failed("the study has no runs");
        Measured measured;
        double largest = 0;
        for (const StudyLevel& at : s.levels) {
          largest = larger(largest, at.run.ledger.energy.relative_drift(false));
        }
        measured.value = largest;
        return measured;
      },
      {}, tier);
}

CaseGate study_gate(std::string study, Gate gate, std::function<Measured(const StudyResult&)> measure,
                    std::vector<double> levels, Tier tier) {
  return {std::move(study), std::move(gate), std::move(levels), std::move(measure), tier};
}

namespace {

// The largest of read(run) over all runs of the study; NaN wins.
template <class Read>
std::function<Measured(const StudyResult&)> largest_over_runs(Read read) {
  return [read](const StudyResult& s) {
    if (s.levels.empty()) return failed("the study has no runs");
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

CaseGate identity(const std::string& study, const std::string& id, const std::string& quantity,
                  const std::string& reason, std::function<Measured(const StudyResult&)> measure) {
  Gate gate;
  gate.id = id;
  gate.quantity = quantity;
  gate.expected.high = 1e-12;
  gate.origin = Origin::identity;
  gate.reason = reason;
  return study_gate(study, std::move(gate), std::move(measure));
}

}  // namespace

// The first measure of a run that is no number though the case gives no reason why it may be none; empty if there is none.
std::string undefined_measure(const Case& entry, const RunResult& run) {
  const auto allowed = entry.may_be_undefined();
  for (const Measure& m : run.measures) {
    if (!std::isfinite(m.error) && allowed.count(m.name) == 0) return m.name;
  }
  return "";
}

namespace {

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
  const std::string long_runs = "; beyond 4500 steps, over what they round, steps/4500";
  std::vector<CaseGate> gates;
  Gate finite;
  finite.id = study + "/finite";
  finite.quantity = "runs that stopped";
  finite.expected = {0.0, 0.0};
  finite.origin = Origin::identity;
  finite.reason = "every run arrives at its end with admissible values, and its measures are numbers";
  gates.push_back(study_gate(study, finite, [](const StudyResult& s) {
    if (s.levels.empty()) return failed("the study has no runs");
    Measured measured;
    double stopped = 0;
    const auto look = [&](const RunResult& run) {
      stopped += run.finished ? 0 : 1;
      if (run.stop) {
        measured.note = fmt::format("stopped at step {} in {}: {}", run.stop->step, run.stop->field, run.stop->reason);
      } else if (const std::string name = undefined_measure(*s.entry, run); !name.empty()) {
        measured.invalid = true;
        measured.note = fmt::format("{} is not a number at {} cells", name, run.settings.number("cells"));
      }
    };
    for (const StudyLevel& at : s.levels) {
      look(at.run);
      for (const RunResult& other : at.offsets) look(other);
    }
    measured.value = stopped;
    return measured;
  }));
  gates.push_back(identity(study, study + "/mass", "relative difference of grid mass and point mass",
                           "shape functions sum to one, " + why,
                           largest_over_runs([](const RunResult& r) { return r.ledger.mass.relative_drift(false); })));
  gates.push_back(identity(study, study + "/momentum", "relative drift of momentum",
                           "shape gradients sum to zero, " + why + long_runs, largest_over_runs([](const RunResult& r) {
                             double drift = 0;
                             for (int d = 0; d < r.dim; ++d) {
                               drift = larger(drift,
                                              r.ledger.momentum[static_cast<std::size_t>(d)].relative_drift(true));
                             }
                             return over_rounding(r, drift);
                           })));
  if (dim > 1 && !axisymmetric) {
    gates.push_back(identity(study, study + "/angular-momentum", "relative drift of angular momentum",
                             "stresses are symmetric and every transfer is booked, " + why + long_runs,
                             largest_over_runs([](const RunResult& r) {
                               double drift = 0;
                               for (const Account& a : r.ledger.angular_momentum)
                                 drift = larger(drift, a.relative_drift(true));
                               return over_rounding(r, drift);
                             })));
  }
  gates.push_back(identity(
      study, study + "/ledger", "relative residual of the energy ledger",
      "every exchange of energy is booked by its own formula, " + why + long_runs,
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
    result.case_name = study.entry->name();
    result.scheme = study.scheme;
    result.study = study.plan.id;
    try {
      result.measured = study.failure.empty() ? declared.measure(study) : failed(study.failure);
    } catch (const std::exception& error) {
      result.measured = failed(error.what());
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
