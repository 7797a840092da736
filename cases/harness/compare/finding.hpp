// One compared thing and what became of it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/harness/results/documents.hpp"

namespace plumbline {

// Most serious first.
enum class Change { worse, widened, missing, inconclusive, better, added, same };
inline constexpr std::array all_changes{Change::worse,  Change::widened, Change::missing, Change::inconclusive,
                                        Change::better, Change::added,   Change::same};

// Spelled as in documents: "worse", "new" for `added`.
std::string_view name(Change change);

struct Finding {
  Change change = Change::same;
  std::string kind;  // verdict, bound, run, order, constant, error, limit, cost, machine
  std::string case_name, scheme, study, quantity;
  Json before = nullptr, after = nullptr;  // a number, a word, or a range {"low", "high"}
  // What the change is judged by: difference of orders; relative change of errors, constants and limits; ratio of
  // costs. `interval`: of 95 %, where it has one.
  std::optional<double> size;
  std::optional<std::pair<double, double>> interval;
  bool equal = true;  // of `same`: equal but for rounding; otherwise moved by less than what counts
  std::string note;
  std::string recorded;  // of `widened`: the reason that the tolerance ledger gives for it
};

Json to_json(const Finding& finding);

// {"low", "high"}, null for an end that is absent.
Json range_json(const Range& range);

// `before`, `after` and size in a few words for people.
std::string words(const Finding& finding);

}  // namespace plumbline
