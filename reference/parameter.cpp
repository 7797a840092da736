#include "reference/parameter.hpp"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <utility>

namespace plumbline::reference {
namespace {

std::string text(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(15);
  out << value;
  return out.str();
}

}  // namespace

ParameterError::ParameterError(std::string key_, double value_, std::string allowed_)
    : std::invalid_argument(key_ + " = " + text(value_) + " is not allowed: " + allowed_),
      key(std::move(key_)),
      value(value_),
      allowed(std::move(allowed_)) {}

UnknownParameter::UnknownParameter(std::string key_, std::vector<std::string> known_)
    : std::invalid_argument("there is no parameter " + key_),
      key(std::move(key_)),
      known(std::move(known_)) {}

std::string allowed_text(const Parameter& p) {
  const bool low_open = p.low_open || std::isinf(p.low), high_open = p.high_open || std::isinf(p.high);
  std::string allowed = low_open ? "(" : "[";
  allowed += text(p.low) + ", " + text(p.high) + (high_open ? ")" : "]");
  if (!p.unit.empty() && p.unit != "1") allowed += " " + p.unit;
  return allowed;
}

void check(const Parameter& p, double value) {
  const bool above = p.low_open ? value > p.low : value >= p.low;
  const bool below = p.high_open ? value < p.high : value <= p.high;
  if (!std::isfinite(value) || !above || !below) throw ParameterError(p.key, value, allowed_text(p));
}

std::map<std::string, double> complete(const std::vector<Parameter>& parameters,
                                       const std::map<std::string, double>& chosen) {
  std::map<std::string, double> settings;
  std::vector<std::string> known;
  for (const Parameter& p : parameters) {
    const auto found = chosen.find(p.key);
    settings[p.key] = found == chosen.end() ? p.value : found->second;
    known.push_back(p.key);
    check(p, settings[p.key]);
  }
  for (const auto& [key, value] : chosen) {
    if (!settings.count(key)) throw UnknownParameter(key, known);
  }
  return settings;
}

}  // namespace plumbline::reference
