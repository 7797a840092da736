#include "cases/harness/judge/study.hpp"

#include <cmath>
#include <limits>

namespace plumbline {
namespace {

// Rounding that a sum over `steps` steps can gather in a quantity of this size.
double rounding_level(const RunResult& run, const Measure& measure) {
  return std::numeric_limits<double>::epsilon() * measure.scale * static_cast<double>(run.steps);
}

Settings with_step_factor(Settings settings, double factor, const std::string& owner) {
  const char* key = settings.is_set("dt") ? "dt" : "cfl";
  settings.set(key, settings.number(key) * factor, owner);
  return settings;
}

double refined_length(Vary vary, const RunResult& run, double value) {
  switch (vary) {
    case Vary::dt:
      return run.dt;
    case Vary::ppc:
      return run.h / value;
    default:
      return run.h;
  }
}

// Distance of a run from the same run with the next smaller step, column by column of the profile; points keep their
// numbers, so they are compared one by one and no exact solution is needed. Successive distances fall with the order
// of the step even where the mesh's own error does not.
void add_step_measures(RunResult& run, const RunResult& finer) {
  const ProfileColumn* weight = run.profile.find("mass");
  for (const ProfileColumn& column : run.profile.columns) {
    const ProfileColumn* other = finer.profile.find(column.name);
    if (!run.profile.find(column.name + "_reference") || !other || !weight) continue;
    double distance = 0, scale = 0, total = 0;
    for (std::size_t p = 0; p < column.values.size(); ++p) {
      const double m = weight->values[p];
      distance += m * std::abs(column.values[p] - other->values[p]);
      scale += m * std::abs(column.values[p]);
      total += m;
    }
    run.measures.push_back({column.name + ".step", distance / total, scale / total, {}, {}, 0, column.unit});
  }
  const std::size_t known = run.measures.size();
  for (std::size_t k = 0; k < known; ++k) {
    const Measure measure = run.measures[k];
    const Measure* other = finer.find(measure.name);
    if (!measure.value || !other || !other->value) continue;
    run.measures.push_back({measure.name + ".step",
                            std::abs(*measure.value - *other->value),
                            std::abs(*measure.value),
                            {},
                            {},
                            0,
                            measure.unit});
  }
}

void fit_measures(StudyResult& study) {
  if (study.plan.vary == Vary::offset || study.levels.empty() || !study.entry->trials.empty()) return;
  for (const Measure& measure : study.levels.front().run.measures) {
    std::vector<Level> levels;
    bool weighted = true;
    for (const StudyLevel& at : study.levels) {
      const Measure* m = at.run.find(measure.name);
      Level level;
      level.h = at.h;
      level.error = m ? m->error : std::nan("");
      level.rounding = m ? rounding_level(at.run, *m) : 0;
      level.reference_bound = m ? m->reference_bound : 0;
      if (!at.offsets.empty()) level.offset_errors.push_back(level.error);
      for (const RunResult& other : at.offsets) {
        const Measure* o = other.find(measure.name);
        level.offset_errors.push_back(o ? o->error : std::nan(""));
      }
      weighted = weighted && !at.offsets.empty();
      levels.push_back(std::move(level));
    }
    study.fits.emplace_back(measure.name, fit_order(levels, weighted ? Weighting::offsets : Weighting::equal));
  }
}

}  // namespace

const StudyResult* StudyResult::sibling(const std::string& id) const {
  if (!siblings) return nullptr;
  for (const StudyResult& other : *siblings) {
    if (other.plan.id == id) return &other;
  }
  return nullptr;
}

const StudyLevel* StudyResult::level(double value) const {
  for (const StudyLevel& at : levels) {
    if (at.value == value) return &at;
  }
  return nullptr;
}

const OrderFit* StudyResult::fit(const std::string& measure) const {
  for (const auto& [name, fit] : fits) {
    if (name == measure) return &fit;
  }
  return nullptr;
}

namespace {

// Points of a snapshot for the report: more cannot be told apart in a picture.
constexpr long most_drawn_points = 20000;

void ask_for_frames(const StudyPlan& plan, double last, std::vector<PlannedRun>& planned) {
  if (plan.frames == 0) return;
  for (PlannedRun& run : planned) {
    if (!run.is_offset && run.value == plan.frames_at.value_or(last)) run.frames = {plan.frames, most_drawn_points};
  }
}

}  // namespace

std::vector<PlannedRun> planned_runs(const Case& entry, const StudyPlan& plan, Tier tier,
                                     const std::vector<std::string>& typed) {
  const bool full = tier == Tier::full;
  const auto& values = full && !plan.full_values.empty() ? plan.full_values : plan.values;
  std::vector<PlannedRun> planned;
  for (const double value : values) {
    std::vector<Override> overrides = plan.overrides;
    if (plan.vary != Vary::dt && entry.trials.empty()) overrides.emplace_back(plumbline::name(plan.vary), value);
    Settings settings = entry.settings(plan.scheme, overrides, typed);
    if (plan.vary == Vary::dt) settings = with_step_factor(std::move(settings), value, entry.name);
    planned.push_back({value, settings});
    for (const double offset : further_offsets) {
      if (!full || !plan.offsets_in_full) break;
      Settings shifted = settings;
      shifted.set("offset", offset, entry.name);
      planned.push_back({value, std::move(shifted), true});
    }
  }
  if (!values.empty()) ask_for_frames(plan, values.back(), planned);
  if (plan.vary == Vary::dt && !values.empty()) {
    // One more run, with half the finest step: the one the finest level is measured against.
    planned.push_back({values.back() / 2, with_step_factor(entry.settings(plan.scheme, plan.overrides, typed),
                                                           values.back() / 2, entry.name)});
  }
  return planned;
}

StudyResult assemble_study(const Case& entry, const StudyPlan& plan, const std::vector<PlannedRun>& planned,
                           std::vector<RunResult> runs) {
  StudyResult study{&entry, plan, plan.scheme, {}, {}, {}, nullptr};
  for (std::size_t k = 0; k < planned.size(); ++k) {
    if (planned[k].is_offset) {
      study.levels.back().offsets.push_back(std::move(runs[k]));
    } else {
      const double value = planned[k].value;
      study.levels.push_back({value, refined_length(plan.vary, runs[k], value), std::move(runs[k]), {}});
    }
  }
  if (plan.vary == Vary::dt && study.levels.size() > 1) {
    for (std::size_t k = 0; k + 1 < study.levels.size(); ++k) {
      add_step_measures(study.levels[k].run, study.levels[k + 1].run);
    }
    study.levels.pop_back();
  }
  fit_measures(study);
  return study;
}

}  // namespace plumbline
