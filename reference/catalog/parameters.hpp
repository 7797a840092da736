#pragma once
// Parameters and rows that many entries of the catalog have in common.
#include <string>
#include <utility>
#include <vector>

#include "reference/registry.hpp"

namespace plumbline::reference {

inline Parameter positive_parameter(const std::string& key, double value, const std::string& unit,
                                    const std::string& description) {
  return {key, value, 0, rounding::infinity, true, true, unit, description};
}
inline Parameter finite_parameter(const std::string& key, double value, const std::string& unit,
                                  const std::string& description) {
  return {key, value, -rounding::infinity, rounding::infinity, true, true, unit, description};
}
inline Parameter time_parameter(double value) {
  return {"time", value, 0, rounding::infinity, false, true, "s", "time of the rows"};
}
inline Parameter time_abscissa() {
  return {"time", 0, 0, rounding::infinity, false, true, "s", "time since the start"};
}
inline Parameter position_abscissa() { return finite_parameter("position", 0, "m", "position x"); }
inline Parameter mode_parameter(double value) {
  return {"mode", value, 1, 1000, false, false, "1", "number of the mode, a whole number from 1"};
}

/// The whole number that a parameter must be. Throws ParameterError.
inline int whole_number(const std::map<std::string, double>& settings, const std::string& key) {
  const double value = settings.at(key);
  if (value != static_cast<int>(value)) throw ParameterError(key, value, "a whole number");
  return static_cast<int>(value);
}

inline bool switched_on(const std::map<std::string, double>& settings, const std::string& key) {
  const double value = settings.at(key);
  if (value != 0 && value != 1) throw ParameterError(key, value, "0 or 1");
  return value == 1;
}

inline void add_row(Answer& answer, const std::string& abscissa, double at,
                    const std::vector<std::pair<std::string, Bounded>>& row) {
  Record values{{abscissa, at}}, bounds;
  for (const auto& [key, value] : row) {
    values.emplace_back(key, value.value);
    bounds.emplace_back(key, value.bound);
  }
  answer.at.push_back(std::move(values));
  answer.at_bounds.push_back(std::move(bounds));
}

}  // namespace plumbline::reference
