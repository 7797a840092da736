// The known limits of a time integrator: one list over all problems of the laboratory, so that none is shown without the
// others.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cases/harness/laboratory/problem.hpp"

namespace plumbline {

struct KnownLimit {
  const StabilityProblem* problem = nullptr;
  std::optional<Settings> settings = {};  // none: the integrator cannot work with the problem
  std::vector<Override> listed = {};      // what the row sets beside the problem's own choices
  std::string unit = "h/c";
  double limit = 0;    // infinite: every step of the scan is stable; 0: none is; NaN: not found, `note` says why
  double scanned = 0;  // the largest step that was looked at
  Growth growth = {};  // where no step is stable: at the smallest step of the scan
  std::optional<ClosedForm> closed_form = {};
  bool smallest = false;  // of all rows with a limit in h/c
  std::string note = {};

  bool has_limit() const { return limit > 0 && limit < HUGE_VAL; }
  bool no_stable_step() const { return limit == 0; }
  double comparable() const;  // the limit where c is the speed of the fastest wave of all
  std::string words() const;  // shape, transfer, points and places: "linear flip, ppc 2, depth 0.01"
};

// A problem's settings with the first of its own choices and its concessions() that the integrator can work with.
struct WorkableSettings {
  std::optional<Settings> settings = {};
  std::vector<Override> overrides = {};  // those given, and the concession
  std::string refusal = {};              // where there are none: why not with the problem's own choices
};
WorkableSettings workable_settings(const StabilityProblem& problem, const std::vector<Override>& overrides);

// The rows of one integrator, not looked at yet: every problem's listed() choices. problems: empty for all.
std::vector<KnownLimit> rows_of(const IntegratorChoice& integrator,
                                const std::vector<const StabilityProblem*>& problems = {});
// Finds the limit of a row, and why there is none.
void find_limit(KnownLimit& row);

// Whether a step makes every point depend on every other, as implicit ones do. Their limits cost much.
bool reaches_far(const IntegratorChoice& integrator);
// The scan by which a problem's first limit is looked for: its own up to there, of steps that reach far a coarse one.
Scan scan_of_first_limit(const StabilityProblem& problem, const Settings& settings);
// The smallest in h/c first, then what has no limit there, then other units. Marks the smallest.
void put_in_order(std::vector<KnownLimit>& rows);

// All three, rows shared between threads.
std::vector<KnownLimit> limits_of(const IntegratorChoice& integrator, int threads,
                                  const std::vector<const StabilityProblem*>& problems = {});

// The row marked smallest; null: no row has a limit in h/c.
const KnownLimit* smallest_of(const std::vector<KnownLimit>& rows);

// A list as it is shown: which integrator, over which problems it was taken.
struct KnownList {
  IntegratorChoice integrator;
  std::vector<const StabilityProblem*> problems;
  std::vector<KnownLimit> rows;
};

// The smallest limit in h/c of a list and of one more result beside it; limit 0: neither has one.
struct SmallestKnown {
  double limit = 0;
  std::string problem, words;
  bool is_this = false;  // the result itself
};
SmallestKnown smallest_known(const Configuration& result, const KnownList& list);

// "0.7071 h/c", "no stable step", "none below 4 h/c".
std::string limit_in_words(const Configuration& result);

// Shape, transfer and points of a problem's settings, then its own keys: "linear flip, ppc 2, depth 0.01".
std::string choices_in_words(const Settings& settings, const std::vector<Override>& own = {});

}  // namespace plumbline
