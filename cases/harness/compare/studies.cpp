#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cases/harness/compare/parts.hpp"
#include "cases/harness/verdict/line_fit.hpp"
#include "cases/harness/verdict/student.hpp"

namespace plumbline {
namespace {

constexpr std::size_t least_common_levels = 3;

Finding finding_of(const StudyRecord& study, const std::string& kind, const std::string& quantity) {
  Finding f;
  f.kind = kind;
  f.case_name = study.case_name;
  f.scheme = study.scheme;
  f.study = study.id.empty() ? study.vary : study.id;
  f.quantity = quantity;
  return f;
}

// Levels of the same value in both studies, coarse first.
struct Common {
  const LevelRecord *before, *after;
  std::size_t at_before, at_after;
};

std::vector<Common> common_levels(const StudyRecord& before, const StudyRecord& after) {
  std::vector<Common> common;
  for (std::size_t i = 0; i < before.levels.size(); ++i) {
    for (std::size_t j = 0; j < after.levels.size(); ++j) {
      if (before.levels[i].value == after.levels[j].value)
        common.push_back({&before.levels[i], &after.levels[j], i, j});
    }
  }
  std::stable_sort(common.begin(), common.end(),
                   [](const Common& a, const Common& b) { return a.before->h > b.before->h; });
  return common;
}

const ErrorRecord* error_of(const LevelRecord& level, const std::string& measure) {
  const auto found = level.errors.find(measure);
  return found == level.errors.end() || !std::isfinite(found->second.error) ? nullptr : &found->second;
}

// Differences that rounding or the reference may have made.
bool within_rounding(const ErrorRecord& a, const ErrorRecord& b) {
  const double floor = rounding_share * std::max(a.scale, b.scale) + a.reference_bound + b.reference_bound;
  const double difference = std::abs(b.error - a.error);
  return difference <= floor || difference <= equal_share * std::max(a.error, b.error);
}

// --- orders -------------------------------------------------------------------------------------------------------

// ln(E_after/E_before) over ln h: what the later order exceeds the earlier by, and the mean.
struct Shifted {
  double slope = 0, half_width = unbounded, mean = 0;
};

bool enters(const FitRecord& fit, std::size_t level) { return fit.used.size() <= level || fit.used[level]; }

std::optional<Shifted> shifted(const std::vector<Common>& common, const std::string& measure, const FitRecord& before,
                               const FitRecord& after) {
  std::vector<FitPoint> points;
  bool all_equal = true;
  for (const Common& at : common) {
    const ErrorRecord *a = error_of(*at.before, measure), *b = error_of(*at.after, measure);
    if (!a || !b || !(a->error > 0) || !(b->error > 0) || !(at.before->h > 0)) continue;
    if (!enters(before, at.at_before) || !enters(after, at.at_after)) continue;
    points.push_back({std::log(at.before->h), std::log(b->error / a->error)});
    all_equal = all_equal && within_rounding(*a, *b);
  }
  if (points.size() < least_common_levels) return std::nullopt;
  if (all_equal) return Shifted{0, 0, 0};
  const StraightLine line = fit_line(points);
  if (!std::isfinite(line.slope)) return std::nullopt;
  const double n = static_cast<double>(points.size());
  double mean = 0;
  for (const FitPoint& point : points) mean += point.y / n;
  return Shifted{line.slope, student_quantile(n - 2) * line.slope_error, mean};
}

// Welch's test of two slopes from their intervals: each is t(n - 2) standard errors either side.
Shifted welch(const FitRecord& before, const FitRecord& after, std::size_t levels_before, std::size_t levels_after) {
  const auto spread = [](const FitRecord& fit, std::size_t levels) {
    std::size_t used = fit.used.empty() ? levels : 0;
    for (const bool enters : fit.used) used += enters ? 1 : 0;
    const double degrees = static_cast<double>(used) - 2;
    const double half = fit.low && fit.high ? (*fit.high - *fit.low) / 2 : unbounded;
    return std::pair(degrees > 0 ? half / student_quantile(degrees) : unbounded, degrees);
  };
  const auto [a, a_degrees] = spread(before, levels_before);
  const auto [b, b_degrees] = spread(after, levels_after);
  Shifted result{*after.order - *before.order, unbounded, 0};
  if (!std::isfinite(a) || !std::isfinite(b)) return result;
  result.half_width = 0;
  const double variance = a * a + b * b;
  if (!(variance > 0)) return result;
  const double degrees = variance * variance / (std::pow(a, 4) / a_degrees + std::pow(b, 4) / b_degrees);
  result.half_width = student_quantile(degrees) * std::sqrt(variance);
  return result;
}

Change order_change(const Shifted& by) {
  if (std::abs(by.slope) <= order_difference) return Change::same;
  if (std::abs(by.slope) <= by.half_width) return Change::inconclusive;
  return by.slope > 0 ? Change::better : Change::worse;
}

bool has_order(const FitRecord& fit) { return fit.order && fit.low && fit.high; }

void compare_fit(const StudyRecord& before, const StudyRecord& after, const std::vector<Common>& common,
                 const std::string& measure, std::vector<Finding>& findings) {
  const FitRecord& a = before.fits.at(measure);
  const auto other = after.fits.find(measure);
  const bool had = has_order(a), has = other != after.fits.end() && has_order(other->second);
  if (!had && !has) return;
  Finding f = finding_of(before, "order", measure);
  if (had) f.before = *a.order;
  if (has) f.after = *other->second.order;
  if (!had || !has) {
    f.change = had ? Change::missing : Change::added;
    if (had) f.note = "no order can be fitted any more";
    findings.push_back(std::move(f));
    return;
  }
  const FitRecord& b = other->second;
  const std::optional<Shifted> paired = shifted(common, measure, a, b);
  const Shifted by = paired ? *paired : welch(a, b, before.levels.size(), after.levels.size());
  f.size = by.slope;
  if (std::isfinite(by.half_width)) f.interval = {by.slope - by.half_width, by.slope + by.half_width};
  f.change = order_change(by);
  f.equal = std::abs(by.slope) <= equal_share;
  if (!paired) f.note = "the levels differ: Welch's test of both orders";
  const bool same_order = f.change == Change::same;
  findings.push_back(std::move(f));
  if (!same_order || !paired || !a.constant) return;
  Finding constant = finding_of(before, "constant", measure);
  constant.before = *a.constant;
  constant.after = *a.constant * std::exp(by.mean);
  constant.size = std::expm1(by.mean);
  constant.equal = std::abs(*constant.size) <= equal_share;
  if (std::abs(*constant.size) > error_share) constant.change = *constant.size < 0 ? Change::better : Change::worse;
  findings.push_back(std::move(constant));
}

// --- errors -------------------------------------------------------------------------------------------------------

Finding error_finding(const StudyRecord& study, const Common& at, const std::string& measure, const ErrorRecord& a,
                      const ErrorRecord* b) {
  Finding f = finding_of(study, "error", measure);
  f.note = fmt::format("at {} = {:g}", study.vary.empty() ? "level" : study.vary, at.before->value);
  f.before = a.error;
  if (!b) {
    f.change = at.after->finished ? Change::missing : Change::worse;
    return f;
  }
  f.after = b->error;
  if (within_rounding(a, *b)) return f;
  f.equal = false;
  f.size = a.error > 0 ? std::optional(b->error / a.error - 1) : std::nullopt;
  if (f.size && std::abs(*f.size) <= error_share) return f;
  f.change = b->error < a.error ? Change::better : Change::worse;
  return f;
}

void compare_errors(const StudyRecord& before, const std::vector<Common>& common, std::vector<Finding>& findings) {
  const Common& finest = common.back();
  for (const auto& [measure, error] : finest.before->errors) {
    if (!std::isfinite(error.error)) continue;
    findings.push_back(error_finding(before, finest, measure, error, error_of(*finest.after, measure)));
  }
}

void compare_runs(const StudyRecord& before, const std::vector<Common>& common, std::vector<Finding>& findings) {
  for (const Common& at : common) {
    if (at.before->finished == at.after->finished) continue;
    Finding f = finding_of(before, "run", fmt::format("{} = {:g}", before.vary, at.before->value));
    f.before = at.before->finished ? "finished" : "stopped";
    f.after = at.after->finished ? "finished" : "stopped";
    f.change = at.after->finished ? Change::better : Change::worse;
    f.note = at.after->stop;
    findings.push_back(std::move(f));
  }
}

std::string changed_settings(const StudyRecord& before, const StudyRecord& after) {
  std::string text;
  const auto tell = [&](const std::string& key, const std::string& a, const std::string& b) {
    text += fmt::format("{}{} {} -> {}", text.empty() ? "" : ", ", key, a, b);
  };
  for (const auto& [key, value] : before.settings) {
    const auto other = after.settings.find(key);
    if (other == after.settings.end()) tell(key, value, "none");
    if (other != after.settings.end() && other->second != value) tell(key, value, other->second);
  }
  for (const auto& [key, value] : after.settings) {
    if (before.settings.count(key) == 0) tell(key, "none", value);
  }
  return text;
}

void compare_pair(const StudyRecord& before, const StudyRecord& after, std::vector<Finding>& findings) {
  const std::size_t first = findings.size();
  const std::vector<Common> common = common_levels(before, after);
  if (common.empty()) {
    findings.push_back(finding_of(before, "study", "levels"));
    findings.back().change = Change::missing;
    findings.back().note = "no level is in both studies";
    return;
  }
  compare_runs(before, common, findings);
  if (before.vary != "offset") {
    for (const auto& [measure, fit] : before.fits) compare_fit(before, after, common, measure, findings);
  }
  compare_errors(before, common, findings);
  const std::string choices = changed_settings(before, after);
  for (std::size_t k = first; k < findings.size() && !choices.empty(); ++k) {
    if (findings[k].change != Change::same)
      findings[k].note += (findings[k].note.empty() ? "" : "; ") + ("settings: " + choices);
  }
}

// --- which study belongs to which ---------------------------------------------------------------------------------

void lone_study(const StudyRecord& study, Change change, std::vector<Finding>& findings) {
  findings.push_back(finding_of(study, "study", "study in " + study.vary));
  findings.back().change = change;
}

// Equal levels first, then those with most levels.
void compare_rivals(std::vector<StudyRecord> before, std::vector<StudyRecord> after, std::vector<Finding>& findings) {
  for (auto a = before.begin(); a != before.end();) {
    const auto b = std::find_if(after.begin(), after.end(),
                                [&](const StudyRecord& other) { return other.values() == a->values(); });
    if (b == after.end()) {
      ++a;
      continue;
    }
    compare_pair(*a, *b, findings);
    a = before.erase(a);
    after.erase(b);
  }
  const auto by_levels = [](const StudyRecord& x, const StudyRecord& y) { return x.levels.size() > y.levels.size(); };
  std::stable_sort(before.begin(), before.end(), by_levels);
  std::stable_sort(after.begin(), after.end(), by_levels);
  const std::size_t pairs = std::min(before.size(), after.size());
  for (std::size_t k = 0; k < pairs; ++k) compare_pair(before[k], after[k], findings);
  for (std::size_t k = pairs; k < before.size(); ++k) lone_study(before[k], Change::missing, findings);
  for (std::size_t k = pairs; k < after.size(); ++k) lone_study(after[k], Change::added, findings);
}

}  // namespace

void compare_studies(const Snapshot& before, const Snapshot& after, std::vector<Finding>& findings) {
  for (const auto& [key, studies] : before.studies) {
    const auto found = after.studies.find(key);
    compare_rivals(studies, found == after.studies.end() ? std::vector<StudyRecord>{} : found->second, findings);
  }
  for (const auto& [key, studies] : after.studies) {
    if (before.studies.count(key) == 0) compare_rivals({}, studies, findings);
  }
}

}  // namespace plumbline
