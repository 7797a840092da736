// Cases whose trials compare numbers with closed forms, without a run.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cases/harness/description/case.hpp"

namespace plumbline {

struct KnownAnswer {
  std::string name;             // as measures are called: "slope.weighted"
  double found = 0, exact = 0;  // exact: finite
  double scale = 1;             // > 0, of the numbers that enter: roundings are relative to it
};
using KnownAnswers = std::vector<KnownAnswer>;

// Answers that are yes or no.
inline KnownAnswer whether(std::string name, bool found, bool exact) {
  return {std::move(name), found ? 1.0 : 0.0, exact ? 1.0 : 0.0};
}
inline KnownAnswer yes(std::string name, bool found) { return whether(std::move(name), found, true); }
inline KnownAnswer no(std::string name, bool found) { return whether(std::move(name), found, false); }

template <class Error, class Work>
bool throws(const Work& work) {
  try {
    work();
  } catch (const Error&) {
    return true;
  }
  return false;
}

struct KnownTrial {
  const char *name, *title, *why;
  KnownAnswers (*answers)();
  double tolerance;    // what |found - exact| over the scale may be at most
  const char* reason;  // for the tolerance
};

// Closed forms against sums of up to a few hundred numbers of order one.
inline constexpr double few_roundings = 1e-12;
inline constexpr const char* rounded =
    "closed forms, to some thousand roundings of sums of up to a few hundred numbers of order one";

// Each trial is judged by its largest deviation; its measures name answers that are off.
Case known_answers_case(std::string name, const std::vector<KnownTrial>& trials);

}  // namespace plumbline
