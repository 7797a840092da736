#include "cases/harness/laboratory/known_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/pool.hpp"
#include "cases/harness/laboratory/bar_patch.hpp"
#include "kernel/integrator_traits.hpp"
#include "kernel/transfers/transfer.hpp"

namespace plumbline {
namespace {

constexpr double known_width = 1e-6;  // relative, of limits
constexpr const char* common_unit = "h/c";
constexpr int problem_margin = 2;  // periods: enough to have every body

// Whether the integrator can step the problem's scene; else why not.
std::string refusal_of(const StabilityProblem& problem, const Settings& settings) {
  if (!problem.has_grid()) return {};
  try {
    const Patch patch = problem.patch(settings, {1, problem_margin});
    const auto missing = lacks(*find_integrator(settings.text("integrator")), patch.scene);
    return missing.empty() ? std::string() : CannotWork(missing).what();
  } catch (const CannotWork& parts) {  // some scenes are brought to rest by steps
    return parts.what();
  }
}

KnownLimit row_of(const StabilityProblem& problem, const std::vector<Override>& listed,
                  const IntegratorChoice& integrator) {
  std::vector<Override> overrides = listed;
  overrides.emplace_back("integrator", integrator.name);
  for (const auto& [name, value] : integrator.parameters) overrides.emplace_back(name, value);
  WorkableSettings found = workable_settings(problem, overrides);
  KnownLimit row;
  row.problem = &problem;
  row.settings = std::move(found.settings);
  row.listed = listed;
  row.unit = problem.unit();
  row.limit = std::numeric_limits<double>::quiet_NaN();
  row.note = found.refusal;
  return row;
}

bool in_h_over_c(const KnownLimit& row) { return row.unit == common_unit && row.has_limit(); }

// The problem's own keys.
std::vector<Override> own_choices(const Configuration& result) {
  std::vector<Override> own;
  for (const Key& key : result.problem->keys()) own.emplace_back(key.name, result.settings[key.name]);
  return own;
}

// Rows in h/c with a limit first, then those there without one, then other units.
int rank(const KnownLimit& row) { return in_h_over_c(row) ? 0 : row.unit == common_unit ? 1 : 2; }

}  // namespace

WorkableSettings workable_settings(const StabilityProblem& problem, const std::vector<Override>& overrides) {
  WorkableSettings found;
  std::vector<std::vector<Override>> attempts = problem.concessions();
  attempts.insert(attempts.begin(), std::vector<Override>{});
  for (const std::vector<Override>& concession : attempts) {
    found.overrides = overrides;
    found.overrides.insert(found.overrides.end(), concession.begin(), concession.end());
    std::string refusal;
    try {
      const Settings settings = stability_settings(problem, "default", found.overrides);
      refusal = refusal_of(problem, settings);
      if (refusal.empty()) return {settings, found.overrides, {}};
    } catch (const MissingTraits& missing) {
      refusal = missing.what();
    }
    if (found.refusal.empty()) found.refusal = refusal;
  }
  return found;
}

std::vector<KnownLimit> rows_of(const IntegratorChoice& integrator,
                                const std::vector<const StabilityProblem*>& problems) {
  std::vector<KnownLimit> rows;
  for (const StabilityProblem* problem : problems.empty() ? stability_problems() : problems) {
    for (const std::vector<Override>& listed : problem->listed()) rows.push_back(row_of(*problem, listed, integrator));
  }
  return rows;
}

void find_limit(KnownLimit& row) {
  if (!row.settings) return;
  const Scan scan = scan_of_first_limit(*row.problem, *row.settings);
  row.scanned = scan.high;
  row.closed_form = row.problem->closed_form(*row.settings);
  try {
    const Prediction prediction = row.problem->predicted(*row.settings, scan, known_width);
    row.limit = prediction.limit();
    row.growth = prediction.growth.front();
  } catch (const std::runtime_error& error) {  // a step that cannot be taken, or has no derivative
    row.note = error.what();
  }
}

bool reaches_far(const IntegratorChoice& integrator) {
  constexpr double large = 3;  // h/c
  for (const MapChoice& maps : {MapChoice{"linear", "flip", 2}, MapChoice{"quadratic", "apic", 2}}) {
    const auto patch = [maps](const Extent& extent) { return bar_patch(maps, 1, 0.5, extent); };
    try {
      return reach_of_step({patch, integrator, Positions::frozen}, large) > far_reach;
    } catch (const CannotWork&) {
      continue;
    } catch (const NotStepped&) {
      return false;
    } catch (const std::runtime_error&) {  // further than the largest patch
      return true;
    }
  }
  return false;
}

Scan scan_of_first_limit(const StabilityProblem& problem, const Settings& settings) {
  constexpr int few = 4;
  Scan scan = problem.scan(settings);
  scan.first_limit_only = true;
  const IntegratorChoice integrator{settings.text("integrator"), integrator_parameters(settings)};
  if (problem.has_grid() && reaches_far(integrator)) scan.steps = std::min(scan.steps, few);
  return scan;
}

void put_in_order(std::vector<KnownLimit>& rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const KnownLimit& a, const KnownLimit& b) {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    return rank(a) == 0 && a.comparable() < b.comparable();
  });
  for (KnownLimit& row : rows) row.smallest = false;
  if (!rows.empty() && in_h_over_c(rows.front())) rows.front().smallest = true;
}

std::vector<KnownLimit> limits_of(const IntegratorChoice& integrator, int threads,
                                  const std::vector<const StabilityProblem*>& problems) {
  std::vector<KnownLimit> rows = rows_of(integrator, problems);
  for_all(rows.size(), threads, [&](std::size_t k) { find_limit(rows[k]); });
  put_in_order(rows);
  return rows;
}

const KnownLimit* smallest_of(const std::vector<KnownLimit>& rows) {
  const auto found = std::find_if(rows.begin(), rows.end(), [](const KnownLimit& row) { return row.smallest; });
  return found == rows.end() ? nullptr : &*found;
}

double KnownLimit::comparable() const { return settings ? limit * problem->fastest(*settings) : limit; }

std::string KnownLimit::words() const { return settings ? choices_in_words(*settings, listed) : std::string(); }

SmallestKnown smallest_known(const Configuration& result, const KnownList& list) {
  constexpr double same = 1e-4;  // relative: limits of a list are not found as finely
  SmallestKnown smallest;
  if (const KnownLimit* row = smallest_of(list.rows)) {
    smallest = {row->comparable(), row->problem->name(), row->words(), false};
  }
  const double own = result.predicted.limit() * result.problem->fastest(result.settings);
  if (result.unit != common_unit || !(own > 0) || std::isinf(own)) return smallest;
  if (smallest.limit > 0 && own > smallest.limit * (1 + same)) return smallest;
  return {own, result.problem->name(), choices_in_words(result.settings, own_choices(result)), true};
}

std::string limit_in_words(const Configuration& result) {
  const double limit = result.predicted.limit();
  if (!result.note.empty()) return "not found";
  if (limit == 0) return "no stable step";
  if (std::isinf(limit)) return fmt::format("none up to {:.4g} {}", result.scan.high, result.unit);
  return fmt::format("{:.4g} {}", limit, result.unit);
}

std::string choices_in_words(const Settings& settings, const std::vector<Override>& own) {
  std::string words;
  if (settings.has("shape")) {
    words = settings.text("shape") + " " +
            transfer_in_words(settings.text("transfer"), static_cast<int>(settings.number("transfer_order")));
    if (settings.has("ppc")) words += ", ppc " + to_text(settings["ppc"]);
  }
  for (const auto& [key, value] : own) {
    if (key != "ppc") words += (words.empty() ? "" : ", ") + key + " " + to_text(value);
  }
  return words;
}

}  // namespace plumbline
