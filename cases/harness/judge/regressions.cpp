#include "cases/harness/judge/regressions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "cases/harness/files/errors.hpp"
#include "cases/harness/files/json_text.hpp"

namespace plumbline {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr int regressions_format = 1;
constexpr std::string_view suffix = "/regression";

// By which factor a value may grow until it reaches `bound`, or shrink if it is the lower end; without limit past zero.
double room_above(double bound, double value) {
  if (value > 0) return bound > 0 ? bound / value : 1;
  if (value < 0) return bound < 0 ? value / bound : infinite;
  return bound > 0 ? infinite : 1;
}
double room_below(double bound, double value) { return room_above(-bound, -value); }

bool is_loose(const Range& expected, bool order, double measured) {
  if (order) {
    return (expected.low && measured - *expected.low > loose_order) ||
           (expected.high && *expected.high - measured > loose_order);
  }
  return (expected.high && room_above(*expected.high, measured) > loose_factor) ||
         (expected.low && room_below(*expected.low, measured) > loose_factor);
}

double largest_end(const Range& expected) {
  return std::max(std::abs(expected.low.value_or(0)), std::abs(expected.high.value_or(0)));
}

Range within_rounding(const Range& expected, double measured) {
  const double most = std::max(rounding_factor_recorded * std::abs(measured),
                               least_rounding * std::max(1.0, largest_end(expected)));
  const bool either_sign = measured < 0 || (expected.low && *expected.low < 0);
  return {either_sign ? -most : 0.0, most};
}

}  // namespace

bool is_order(const Gate& gate) { return gate.order || gate.quantity.find("order of") != std::string::npos; }

std::optional<Range> recorded_range(const Range& expected, Origin origin, bool order, double measured) {
  if (!std::isfinite(measured) || !is_loose(expected, order, measured)) return {};
  if (order) return Range{measured - recorded_order, measured + recorded_order};
  const double largest = largest_end(expected);
  const bool rounding = origin == Origin::identity || largest <= rounding_bound ||
                        std::abs(measured) <= std::max(least_rounding, rounding_share_recorded * largest);
  if (rounding) {
    const Range range = within_rounding(expected, measured);
    const bool closer = (expected.high && *range.high < *expected.high) || (expected.low && *range.low > *expected.low);
    return closer ? std::optional(range) : std::nullopt;
  }
  const double near = measured / recorded_factor, far = measured * recorded_factor;
  return Range{std::min(near, far), std::max(near, far)};
}

Regressions::Regressions(std::vector<RecordedValue> values) {
  for (RecordedValue& value : values) values_.emplace(value.key(), std::move(value));
}

const RecordedValue* Regressions::find(const RecordedValue::Key& key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? nullptr : &found->second;
}

std::vector<RecordedValue::Key> Regressions::of_case(const std::string& case_name, const std::string& tier) const {
  std::vector<RecordedValue::Key> keys;
  for (const auto& [key, value] : values_) {
    if (value.case_name == case_name && value.tier == tier && !value.study.starts_with("integrator/"))
      keys.push_back(key);
  }
  return keys;
}

JudgedGate judge_regression(const JudgedGate& judged, const RecordedValue& recorded) {
  JudgedGate result = judged;
  result.gate = gate(regression_of(judged.gate.id), {judged.gate.quantity, {}}, *recorded.within,
                     {Origin::regression,
                      fmt::format(
                          "recorded: {:.6g}; the gate's own bound lets pass more than {:g} times that. Where the "
                          "change is meant: `plumbline tolerances cases/tolerances.json --record`",
                          recorded.measured, loose_factor)})
                    .gate;
  result.gate.measured_on = recorded.since;
  result.measured.interval.reset();
  result.measured.reference_bound = 0;
  result.judgement = judge(result.gate, result.measured);
  return result;
}

std::string regression_of(const std::string& gate) { return gate + std::string(suffix); }

bool of_record(const JudgedGate& judged) { return judged.gate.id.ends_with(suffix); }

namespace {

RecordedValue recorded_value(const Json& json) {
  RecordedValue value;
  value.case_name = json.at("case").get<std::string>();
  value.study = json.at("study").get<std::string>();
  value.id = json.at("id").get<std::string>();
  value.tier = json.at("tier").get<std::string>();
  value.measured = json.at("measured").get<double>();
  if (json.contains("low")) value.within = Range{json.at("low").get<double>(), json.at("high").get<double>()};
  value.since = json.at("since").get<std::string>();
  if (json.contains("moved")) {
    const Json& moved = json.at("moved");
    value.moved = RecordedValue::Moved{moved.at("from").get<double>(), moved.at("date").get<std::string>(),
                                       moved.at("why").get<std::string>()};
  }
  return value;
}

}  // namespace

std::vector<RecordedValue> parse_regressions(const std::string& text, const std::string& file) {
  std::vector<RecordedValue> values;
  try {
    const Json json = parse_json(text);
    if (json.at("format").get<int>() > regressions_format) throw FileError(file, file + ": made by a newer version");
    for (const Json& item : json.at("recorded")) values.push_back(recorded_value(item));
  } catch (const Json::exception& error) {
    throw FileError(file, fmt::format("{}: no recorded values: {}", file, fault_of(error)));
  }
  std::map<RecordedValue::Key, int> seen;
  for (const RecordedValue& value : values) {
    const std::string gate = fmt::format("{} of {}, {} tier", value.id, value.case_name, value.tier);
    if (++seen[value.key()] > 1) throw FileError(file, fmt::format("{}: {} is listed twice", file, gate));
    if (value.moved && (value.moved->date.empty() || value.moved->why.empty()))
      throw FileError(file, fmt::format("{}: {} has moved without date or reason", file, gate));
  }
  return values;
}

}  // namespace plumbline
