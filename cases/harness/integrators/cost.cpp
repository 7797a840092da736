#include "cases/harness/integrators/cost.hpp"

#include <algorithm>
#include <cmath>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/verify/verification.hpp"

namespace plumbline {
namespace {

constexpr int repetitions = 3;

struct TimedRefinement {
  const char *case_name, *measure;
  std::vector<double> cells;
};
const std::vector<TimedRefinement>& timed_refinements() {
  static const std::vector<TimedRefinement> all{{"mms-bar", "displacement.worst", {8, 16, 32, 64}},
                                                {"bar-riemann", "velocity.L1", {50, 100, 200}},
                                                {"acoustic-pulse", "velocity.L1", {20, 40, 80, 160}},
                                                {"sod", "density.L1", {50, 100, 200}},
                                                {"string-vibration", "period", {10, 20, 40}}};
  return all;
}

// Adds the seconds of one more repetition to a curve; the first fills in errors.
void run_once(const Subject& subject, const TimedRefinement& refinement, std::size_t levels, CostCurve& curve) {
  const Case& entry = find_case(refinement.case_name);
  StudyPlan plan = integrator_plan(entry, subject.name());
  plan.values.assign(refinement.cells.begin(), refinement.cells.begin() + static_cast<std::ptrdiff_t>(levels));
  for (const auto& [key, value] : subject.choice().parameters) plan.overrides.emplace_back(key, value);
  const StudyResult study = run_study(entry, plan, planned_runs(entry, plan, Tier::quick), 1);
  curve.levels.resize(study.levels.size());
  for (std::size_t k = 0; k < study.levels.size(); ++k) {
    const RunResult& run = study.levels[k].run;
    const Measure* measure = run.find(curve.measure);
    if (run.stop || !measure) {
      curve.note = run.stop ? "stopped: " + run.stop->reason : "no measure " + curve.measure;
      curve.levels.clear();
      return;
    }
    CostLevel& level = curve.levels[k];
    level.cells = study.levels[k].value;
    level.error = measure->error;
    level.particle_steps = run.points * run.steps;
    level.wall_s.push_back(run.wall_s);
  }
}

// ln seconds at an error, between the levels that have it; nothing outside.
std::optional<double> log_seconds_at(const CostCurve& curve, std::size_t repetition, double log_error) {
  for (std::size_t k = 1; k < curve.levels.size(); ++k) {
    const CostLevel &a = curve.levels[k - 1], &b = curve.levels[k];
    const double ea = std::log(a.error), eb = std::log(b.error);
    if (!((log_error <= ea && log_error >= eb) || (log_error >= ea && log_error <= eb)) || ea == eb) continue;
    const double share = (log_error - ea) / (eb - ea);
    return (1 - share) * std::log(a.wall_s[repetition]) + share * std::log(b.wall_s[repetition]);
  }
  return std::nullopt;
}

std::optional<double> factor_of(const CostCurve& mine, std::size_t i, const CostCurve& other, std::size_t j) {
  std::vector<double> differences;
  for (const CostCurve* curve : {&mine, &other}) {
    for (const CostLevel& level : curve->levels) {
      const auto a = log_seconds_at(mine, i, std::log(level.error)),
                 b = log_seconds_at(other, j, std::log(level.error));
      if (a && b) differences.push_back(*a - *b);
    }
  }
  if (differences.empty()) return std::nullopt;
  double sum = 0;
  for (const double d : differences) sum += d;
  return std::exp(sum / static_cast<double>(differences.size()));
}

double middle(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : std::sqrt(values[n / 2 - 1] * values[n / 2]);
}

}  // namespace

std::vector<std::vector<CostCurve>> cost_curves(const std::vector<const Subject*>& subjects) {
  std::vector<std::vector<CostCurve>> all(subjects.size());
  for (auto& curves : all) {
    for (const TimedRefinement& refinement : timed_refinements())
      curves.push_back({refinement.case_name, refinement.measure});
  }
  // Of costly steps runs are timed once, without the finest mesh.
  const bool costly = std::any_of(subjects.begin(), subjects.end(),
                                  [](const Subject* subject) { return subject->has_inner_solver(); });
  for (int repetition = 0; repetition < (costly ? 1 : repetitions); ++repetition) {
    for (std::size_t r = 0; r < timed_refinements().size(); ++r) {
      for (std::size_t s = 0; s < subjects.size(); ++s) {
        CostCurve& curve = all[s][r];
        if (!curve.note.empty()) continue;
        try {
          run_once(*subjects[s], timed_refinements()[r], timed_refinements()[r].cells.size() - (costly ? 1 : 0), curve);
        } catch (const MissingTraits& parts) {
          curve.note = CannotWork(parts.lacks).what();
        }
      }
    }
  }
  return all;
}

CostFactor cost_factor(const CostCurve& mine, const CostCurve& other) {
  CostFactor found{mine.case_name};
  for (const CostCurve* curve : {&mine, &other}) {
    if (!curve->note.empty()) found.note = curve->note;
  }
  if (!found.note.empty()) return found;
  std::vector<double> factors;
  for (std::size_t i = 0; i < mine.levels.front().wall_s.size(); ++i) {
    for (std::size_t j = 0; j < other.levels.front().wall_s.size(); ++j) {
      if (const auto factor = factor_of(mine, i, other, j)) factors.push_back(*factor);
    }
  }
  if (factors.empty()) {
    const bool better = mine.levels.back().error < other.levels.back().error;
    found.note = better ? "every error is below the other's" : "every error is above the other's";
    return found;
  }
  found.factor = middle(factors);
  found.low = *std::min_element(factors.begin(), factors.end());
  found.high = *std::max_element(factors.begin(), factors.end());
  return found;
}

std::optional<CostFactor> median_of(const std::vector<CostFactor>& factors) {
  std::vector<double> middles, lows, highs;
  for (const CostFactor& one : factors) {
    if (!one.factor) continue;
    middles.push_back(*one.factor);
    lows.push_back(one.low);
    highs.push_back(one.high);
  }
  if (middles.empty()) return std::nullopt;
  return CostFactor{"median", middle(middles), middle(lows), middle(highs)};
}

}  // namespace plumbline
