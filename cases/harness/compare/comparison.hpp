// Two results folders compared: everything that either has, most serious first.
#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

#include "cases/harness/compare/finding.hpp"
#include "cases/harness/compare/snapshot.hpp"
#include "cases/harness/compare/tolerances.hpp"

namespace plumbline {

struct Comparison {
  std::vector<Finding> findings;                  // by `Change`, then kind, case, scheme, study, and the largest first
  std::size_t gates_before = 0, gates_after = 0;  // executed
  std::vector<std::array<std::string, 3>> machine;  // what differs of it: key, before, after
  std::size_t count(Change change) const;
  std::size_t moved() const;    // of `same`: those that are not equal
  double largest_move() const;  // of the relative changes among them
  bool nothing_changed() const;
};

Comparison compare(const Snapshot& before, const Snapshot& after);

// Gives the widened gates whose widening the ledger records, from the bounds before to those after, its reason.
void look_up_widenings(const std::vector<LedgerLine>& ledger, const Snapshot& before, const Snapshot& after,
                       Comparison& comparison);

// The most serious change; `same` where there is none.
Change overall(const Comparison& comparison);

// 4 if a file of either is damaged, else 1 if a change of a kind that is not allowed is worse, widened without a
// recorded reason, missing or inconclusive, else 0.
int exit_status(const Comparison& comparison, const Snapshot& before, const Snapshot& after,
                const std::set<Change>& allowed);

Json document(const Comparison& comparison, const Snapshot& before, const Snapshot& after);

// What people read: a line for each group of findings, the most serious first, a count for what is the same. At most
// `most` lines of a kind of change; 0: all, each finding by itself.
std::vector<std::string> table(const Comparison& comparison, const Snapshot& before, const Snapshot& after,
                               std::size_t most);

}  // namespace plumbline
