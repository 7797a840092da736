// Values recorded of gates whose bound lets pass much more than is measured. Beside each such gate stands another,
// ID/regression, on the recorded value: it is red when the value gets worse by a factor, and when it gets better, so that
// the better value is recorded.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "cases/harness/judge/gates.hpp"

namespace plumbline {

struct RecordedValue {
  struct Moved {
    double from = 0;
    std::string date, why;  // neither empty
  };
  using Key = std::tuple<std::string, std::string, std::string, std::string>;

  std::string case_name, study, id, tier;  // "quick" or "full": studies may have more levels in the latter
  double measured = 0;
  std::optional<Range> within;  // both ends; absent where the gate's own bound is close enough
  std::string since;            // date and commit of the measurement
  std::optional<Moved> moved;   // out of the range recorded before, the last time
  Key key() const { return {case_name, study, id, tier}; }
};

// How far a bound may be from the measured value before a recorded range has to stand beside it, and how far from the recorded
// value that range goes: three, so that a loss or gain of ten is outside. Roundings move numbers that are not chaotic by far
// less.
inline constexpr double loose_factor = 3, recorded_factor = 3;
// Of orders: differences.
inline constexpr double loose_order = 0.3, recorded_order = 0.3;
// A value that is rounding may be anything below the one recorded, and changes with the order of sums: the range goes from 0
// to 30 times it and never ends below 64 units in the last place of 1. Both are choices.
inline constexpr double rounding_factor_recorded = 30, least_rounding = 64 * 0x1p-52;
// Bounds up to here are those of rounding, whatever their origin; all identities are, and values below this share of theirs.
inline constexpr double rounding_bound = 1e-9, rounding_share_recorded = 1e-10;

// The range that stands beside a bound; absent where the bound itself is close enough, and for no number.
std::optional<Range> recorded_range(const Range& expected, Origin origin, bool order, double measured);
// Whether a gate's number is an order: by what it judges, or by its quantity.
bool is_order(const Gate& gate);

class Regressions {
 public:
  explicit Regressions(std::vector<RecordedValue> values);
  const RecordedValue* find(const RecordedValue::Key& key) const;  // null if there is none
  // The gates of a case's own studies that were executed when its values were recorded in a tier.
  std::vector<RecordedValue::Key> of_case(const std::string& case_name, const std::string& tier) const;

 private:
  std::map<RecordedValue::Key, RecordedValue> values_;
};

// The gate on a recorded value, judged on what the gate beside it measured. The reference is the same as at the recording, so
// its bound does not enter.
JudgedGate judge_regression(const JudgedGate& judged, const RecordedValue& recorded);

// The name of the gate on the recorded value of the gate of this name.
std::string regression_of(const std::string& gate);

// Whether a judged gate is one on a recorded value.
bool of_record(const JudgedGate& judged);

// The text of cases/regressions.json. FileError naming `file` for what is none, lists a gate twice or lacks a reason.
std::vector<RecordedValue> parse_regressions(const std::string& text, const std::string& file);

}  // namespace plumbline
