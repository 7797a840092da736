#include "cases/harness/compare/finding.hpp"
#include "cases/harness/files/json_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace plumbline {
namespace {

constexpr std::array<std::string_view, all_changes.size()> change_names{"worse",  "widened", "missing", "inconclusive",
                                                                        "better", "new",     "same"};

Json optional_number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json end(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string word(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return fmt::format("{:.5g}", value.get<double>());
  if (!value.is_object()) return value.is_null() ? "-" : json_text(value);
  return "[" + word(value.at("low")) + ", " + word(value.at("high")) + "]";
}

std::string percent(double share) { return fmt::format("{:+.3g} %", 100 * share); }

std::string size_words(const Finding& f) {
  if (!f.size) return {};
  std::string text;
  const bool order = f.kind == "order", cost = f.kind == "cost";
  if (order) text = fmt::format("{:+.3g}", *f.size);
  if (cost) text = fmt::format("x {:.3f}", *f.size);
  if (!order && !cost) text = percent(*f.size);
  if (!f.interval) return text;
  const auto [low, high] = *f.interval;
  return text + (cost ? fmt::format(" [{:.3f}, {:.3f}]", low, high) : fmt::format(" [{:+.3g}, {:+.3g}]", low, high));
}

}  // namespace

std::string_view name(Change change) { return change_names[static_cast<std::size_t>(change)]; }

Json range_json(const Range& range) {
  const auto end = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
  return {{"low", end(range.low)}, {"high", end(range.high)}};
}

Json to_json(const Finding& f) {
  Json json{{"change", name(f.change)}, {"kind", f.kind},   {"case", f.case_name},
            {"scheme", f.scheme},       {"study", f.study}, {"quantity", f.quantity},
            {"before", f.before},       {"after", f.after}, {"size", optional_number(f.size)}};
  json["interval"] = f.interval ? Json{end(f.interval->first), end(f.interval->second)} : Json(nullptr);
  json["equal"] = f.change == Change::same && f.equal;
  json["note"] = f.note;
  if (f.change == Change::widened) json["recorded"] = f.recorded.empty() ? Json(nullptr) : Json(f.recorded);
  return json;
}

std::string words(const Finding& f) {
  std::string text;
  if (!f.before.is_null() || !f.after.is_null()) text = word(f.before) + " -> " + word(f.after);
  if (const std::string size = size_words(f); !size.empty()) text += (text.empty() ? "" : ", ") + size;
  if (!f.note.empty()) text += (text.empty() ? "" : "; ") + f.note;
  if (!f.recorded.empty()) text += "; recorded: " + f.recorded;
  return text;
}

}  // namespace plumbline
