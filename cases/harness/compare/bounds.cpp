#include "cases/harness/compare/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace plumbline {
namespace {

bool beyond(double value, double limit) {
  return value - limit > bound_slack * std::max(std::abs(value), std::abs(limit));
}

// `after` contains a value that `before` does not.
bool exceeds(const Range& before, const Range& after) {
  const bool low = before.low && (!after.low || beyond(*before.low, *after.low));
  const bool high = before.high && (!after.high || beyond(*after.high, *before.high));
  return low || high;
}

bool exceeds(const StopBand& before, const StopBand& after) {
  return before.field != after.field || after.step_low < before.step_low || after.step_high > before.step_high;
}

// An unbounded range contains nothing, not everything.
bool has_end(const std::optional<Range>& range) { return range && (range->low || range->high); }

std::string why_widened(const Bounds& before, const Bounds& after) {
  if (exceeds(before.expected, after.expected)) return "the expected range";
  const bool failed_before = before.band || before.stops, fails_after = after.band || after.stops;
  if (fails_after && !failed_before) return "a failure is expected where none was";
  if (has_end(after.band) && (!has_end(before.band) || exceeds(*before.band, *after.band)))
    return "the band of the expected failure";
  if (after.stops && (!before.stops || exceeds(*before.stops, *after.stops))) return "the stop that is expected";
  if (before.order && !after.order) return "the value is judged, no longer its 95 % interval";
  return {};
}

std::string number(double value) { return fmt::format("{}", value); }

}  // namespace

Shift shift(const Bounds& before, const Bounds& after, std::string* why) {
  const std::string found = why_widened(before, after);
  if (why) *why = found;
  if (!found.empty()) return Shift::widened;
  return why_widened(after, before).empty() ? Shift::same : Shift::narrowed;
}

std::string range_words(const Range& range) {
  if (range.low && range.high) return "[" + number(*range.low) + ", " + number(*range.high) + "]";
  if (range.low) return "at least " + number(*range.low);
  return range.high ? "at most " + number(*range.high) : "nothing";
}

std::string bounds_words(const Bounds& bounds) {
  std::string words = range_words(bounds.expected);
  if (bounds.order) words += " (95 % interval)";
  if (has_end(bounds.band)) words += ", known to fail in " + range_words(*bounds.band);
  if (bounds.stops) {
    words += fmt::format(", known to stop between step {} and {} in {}", bounds.stops->step_low,
                         bounds.stops->step_high, bounds.stops->field);
  }
  return words;
}

}  // namespace plumbline
