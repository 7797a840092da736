// The known limits of a time integrator: one list over all problems of the laboratory, so that none is shown without the
// others.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cases/laboratory/problem.hpp"

namespace plumbline {

struct KnownLimit {
  const StabilityProblem* problem = nullptr;
  std::optional<Settings> settings = {};  // none: the integrator cannot work with the problem
  std::vector<Override> listed = {};      // what the row sets beside the problem's own choices
  std::string unit = "h/c";
  double limit = 0;     // infinite: every step of the scan is stable; 0: none is; NaN: not found, `note` says why
  double scanned = 0;   // the largest step that was looked at
  Growth growth = {};   // where no step is stable: at the smallest step of the scan
  std::optional<ClosedForm> closed_form = {};
  bool smallest = false;  // of all rows in h/c with a limit above zero
  std::string note = {};

  bool has_limit() const { return limit > 0; }            // false: NaN, too
  bool no_stable_step() const { return limit == 0; }
  std::string words() const;  // shape, transfer, points and places: "linear flip, ppc 2, depth 0.01"
};

// The rows of one integrator, not looked at yet: every problem's listed() choices, its own transfer or, where the
// integrator refuses that, FLIP. problems: empty for all.
std::vector<KnownLimit> rows_of(const IntegratorChoice& integrator,
                                const std::vector<const StabilityProblem*>& problems = {});
// Finds the limit of a row, and why there is none.
void find_limit(KnownLimit& row);
// The smallest in h/c first, then what has no limit there, then other units; marks the smallest.
void put_in_order(std::vector<KnownLimit>& rows);

// All three, rows shared between threads.
std::vector<KnownLimit> limits_of(const IntegratorChoice& integrator, int threads,
                                  const std::vector<const StabilityProblem*>& problems = {});

// The row marked smallest; null: no row has a limit in h/c.
const KnownLimit* smallest_of(const std::vector<KnownLimit>& rows);

// Shape, transfer and points of a problem's settings, then its own keys: "linear flip, ppc 2, depth 0.01".
std::string choices_in_words(const Settings& settings, const std::vector<Override>& own = {});

}  // namespace plumbline
