// What a gate lets pass, and whether a second declaration of it lets pass more than the first.
#pragma once

#include <optional>
#include <string>

#include "cases/harness/verdict/verdict.hpp"

namespace plumbline {

struct Bounds {
  Range expected;
  std::optional<Range> band;      // of an expected failure
  std::optional<StopBand> stops;  // likewise
  bool order = false;             // the interval is judged, not the value
};

enum class Shift { same, narrowed, widened };

// Declared numbers may be computed: two compilers agree on them within this share of the larger one.
inline constexpr double bound_slack = 1e-12;

// Widened: the expected range or the band of the expected failure contains a value that it did not contain before, a
// failure is expected where none was, its stop is wider, or the interval is no longer judged. A range that moved is
// widened: it lets pass what it did not. `why`, if given, says which.
Shift shift(const Bounds& before, const Bounds& after, std::string* why = nullptr);

// "[0.9, 1.1]", "at most 0.007", "at least 0.9", "nothing".
std::string range_words(const Range& range);
// The same with what is expected to fail.
std::string bounds_words(const Bounds& bounds);

}  // namespace plumbline
