#include "cases/harness/description/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "cases/harness/files/errors.hpp"

namespace plumbline {

std::string to_text(const Value& value) {
  if (const double* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  if (const std::string* name = std::get_if<std::string>(&value)) return *name;
  return "none";
}

std::string short_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return fmt::format("{:016x}", hash).substr(4);
}

Key positive_key(std::string name, double value, std::string unit, std::string description) {
  return {.name = std::move(name),
          .value = value,
          .unit = std::move(unit),
          .low = 0,
          .low_open = true,
          .description = std::move(description)};
}

std::string Key::allowed() const {
  if (!choices.empty()) return fmt::format("one of {}", fmt::join(choices, ", "));
  const std::string range = fmt::format("{}{}, {}{}", low_open || std::isinf(low) ? "(" : "[", low, high,
                                        high_open || std::isinf(high) ? ")" : "]");
  std::string others;
  for (const std::string& word : words) others += ", or " + word;
  if (optional) others += ", or none";
  return fmt::format("{}{}{}{}", integer ? "whole number in " : "", range, unit == "1" ? "" : " " + unit, others);
}

bool Settings::has(std::string_view key) const {
  return std::any_of(keys_.begin(), keys_.end(), [&](const Key& k) { return k.name == key; });
}

const Key& Settings::find(std::string_view key) const {
  const auto found = std::find_if(keys_.begin(), keys_.end(), [&](const Key& k) { return k.name == key; });
  if (found == keys_.end()) throw std::out_of_range("no key " + std::string(key));
  return *found;
}

namespace {

bool acceptable(const Key& key, const Value& value) {
  if (std::holds_alternative<std::monostate>(value)) return key.optional;
  if (const std::string* name = std::get_if<std::string>(&value)) {
    const std::vector<std::string>& taken = key.choices.empty() ? key.words : key.choices;
    return std::find(taken.begin(), taken.end(), *name) != taken.end();
  }
  const double x = std::get<double>(value);
  if (!key.choices.empty() || !std::isfinite(x)) return false;
  if (x < key.low || x > key.high || (key.low_open && x == key.low) || (key.high_open && x == key.high)) return false;
  return !key.integer || x == std::floor(x);
}

std::vector<std::string> names(const std::vector<Key>& keys) {
  std::vector<std::string> all;
  for (const Key& key : keys) all.push_back(key.name);
  return all;
}

}  // namespace

void Settings::set(const std::string& key, const Value& value, const std::string& owner) {
  const auto found = std::find_if(keys_.begin(), keys_.end(), [&](const Key& k) { return k.name == key; });
  if (found == keys_.end()) {
    UsageError error = unknown_name("key of " + owner, key, names(keys_));
    error.key = key;
    error.value = to_text(value);
    throw error;
  }
  if (!acceptable(*found, value)) {
    if (!found->choices.empty()) throw unknown_name(key, to_text(value), found->choices);
    throw UsageError(key, to_text(value), found->allowed(), {},
                     fmt::format("{} = {} is not allowed: {}", key, to_text(value), found->allowed()));
  }
  found->value = value;
}

void Settings::set_text(const std::string& assignment, const std::string& owner) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UsageError("--set", assignment, "key=value", {}, fmt::format("--set wants key=value, got '{}'", assignment));
  }
  const std::string key = assignment.substr(0, equals), text = assignment.substr(equals + 1);
  const auto found = std::find_if(keys_.begin(), keys_.end(), [&](const Key& k) { return k.name == key; });
  const bool is_choice = found != keys_.end() &&
                         std::find(found->choices.begin(), found->choices.end(), text) != found->choices.end();
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (is_choice) {  // one may be called none, or look like a number
    set(key, text, owner);
  } else if (error == std::errc() && end == text.data() + text.size()) {
    set(key, number, owner);
  } else if (text == "none") {
    set(key, std::monostate{}, owner);
  } else {
    const bool word = found != keys_.end() &&
                      std::find(found->words.begin(), found->words.end(), text) != found->words.end();
    if (found != keys_.end() && found->choices.empty() && !word) {
      throw UsageError(key, text, found->allowed(), {},
                       fmt::format("{} = '{}' is not a number: {}", key, text, found->allowed()));
    }
    set(key, text, owner);
  }
}

bool Settings::operator==(const Settings& other) const { return canonical() == other.canonical(); }

std::string Settings::canonical() const {
  std::map<std::string, std::string> sorted;
  for (const Key& key : keys_) sorted[key.name] = to_text(key.value);
  std::string text;
  for (const auto& [key, value] : sorted) text += key + "=" + value + "\n";
  return text;
}

}  // namespace plumbline
