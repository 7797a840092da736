#include "cases/laboratory/known_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "cases/harness/errors.hpp"
#include "cases/harness/pool.hpp"

namespace plumbline {
namespace {

constexpr double width = 1e-6;  // relative, of limits
constexpr const char* common_unit = "h/c";

// The rows of one problem. An integrator that refuses the problem's transfer may take FLIP.
KnownLimit row_of(const StabilityProblem& problem, const std::vector<Override>& listed,
                  const IntegratorChoice& integrator) {
  KnownLimit row;
  row.problem = &problem;
  row.listed = listed;
  row.unit = problem.unit();
  row.limit = std::numeric_limits<double>::quiet_NaN();
  for (const char* transfer : {"", "flip"}) {
    if (*transfer != 0 && !problem.has_grid()) continue;
    std::vector<Override> overrides = listed;
    overrides.emplace_back("integrator", integrator.name);
    for (const auto& [name, value] : integrator.parameters) overrides.emplace_back(name, value);
    if (*transfer != 0) overrides.emplace_back("transfer", transfer);
    try {
      row.settings = stability_settings(problem, "default", overrides);
      row.note.clear();
      return row;
    } catch (const UsageError& refused) {
      if (row.note.empty()) row.note = refused.what();
    }
  }
  return row;
}

bool comparable(const KnownLimit& row) { return row.unit == common_unit && row.has_limit(); }

// Rows in h/c with a limit first, then those there without one, then other units.
int rank(const KnownLimit& row) { return comparable(row) ? 0 : row.unit == common_unit ? 1 : 2; }

}  // namespace

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
  Scan scan = row.problem->scan(*row.settings);
  scan.first_limit_only = true;
  row.scanned = scan.high;
  row.closed_form = row.problem->closed_form(*row.settings);
  try {
    const Prediction prediction = row.problem->predicted(*row.settings, scan, width);
    row.limit = prediction.limit();
    row.growth = prediction.growth.front();
  } catch (const std::runtime_error& error) {  // a step that cannot be taken, or has no derivative
    row.note = error.what();
  } catch (const CannotWork& parts) {
    row.note = parts.what();
  }
}

void put_in_order(std::vector<KnownLimit>& rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const KnownLimit& a, const KnownLimit& b) {
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    return rank(a) == 0 && a.limit < b.limit;
  });
  for (KnownLimit& row : rows) row.smallest = false;
  if (!rows.empty() && comparable(rows.front())) rows.front().smallest = true;
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

std::string KnownLimit::words() const { return settings ? choices_in_words(*settings, listed) : std::string(); }

std::string choices_in_words(const Settings& settings, const std::vector<Override>& own) {
  std::string words;
  if (settings.has("shape")) {
    words = settings.text("shape") + " " + settings.text("transfer");
    const std::string& transfer = settings.text("transfer");
    if (transfer == "xpic" || transfer == "fmpm") words += to_text(settings["transfer_order"]);
    if (settings.has("ppc")) words += ", ppc " + to_text(settings["ppc"]);
  }
  for (const auto& [key, value] : own) {
    if (key != "ppc") words += (words.empty() ? "" : ", ") + key + " " + to_text(value);
  }
  return words;
}

}  // namespace plumbline
