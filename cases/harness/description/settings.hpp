// Keys with ranges, and the resolved choices of one run.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace plumbline {

// A number, a name, or not set (monostate).
using Value = std::variant<std::monostate, double, std::string>;

// A key that --set may change.
struct Key {
  std::string name;
  Value value = {};  // the default
  std::string unit = "1";
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false, integer = false;
  bool optional = false;                  // may be "none"
  std::vector<std::string> choices = {};  // of a name
  std::string description = {};
  std::vector<std::string> words = {};  // that a number may be given by: "auto"
  bool method = false;                  // a case's own choice of how it is solved, as those of schemes are

  std::string allowed() const;  // for people: "(0, inf) s", "one of linear, quadratic, cubic"
};

// The key of a positive number.
Key positive_key(std::string name, double value, std::string unit, std::string description);

using Override = std::pair<std::string, Value>;

// All keys of a run with their values. Keys keep the order in which they were declared.
class Settings {
 public:
  explicit Settings(std::vector<Key> keys) : keys_(std::move(keys)) {}

  const std::vector<Key>& keys() const { return keys_; }
  // The value as it is. The key must exist (std::out_of_range).
  const Value& operator[](std::string_view key) const { return find(key).value; }
  double number(std::string_view key) const { return std::get<double>(find(key).value); }
  int integer(std::string_view key) const { return static_cast<int>(number(key)); }
  const std::string& text(std::string_view key) const { return std::get<std::string>(find(key).value); }
  bool is_set(std::string_view key) const { return !std::holds_alternative<std::monostate>(find(key).value); }
  bool has(std::string_view key) const;

  // Sets a checked value. Throws UsageError naming key, value, range and nearest key; `owner` says whose keys they are.
  void set(const std::string& key, const Value& value, const std::string& owner);
  // The same from text as typed: "key=value".
  void set_text(const std::string& assignment, const std::string& owner);

  bool operator==(const Settings& other) const;
  // "key=value" lines of all keys in the order of their names, numbers with all their digits: what the hash is made of.
  std::string canonical() const;

 private:
  const Key& find(std::string_view key) const;
  std::vector<Key> keys_;
};

// Text of a value; numbers in the shortest form that reads back the same. "none" if not set.
std::string to_text(const Value& value);

// 12 hex digits of a 64-bit hash (FNV-1a) of the text.
std::string short_hash(std::string_view text);

}  // namespace plumbline
