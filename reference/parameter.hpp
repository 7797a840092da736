#pragma once
// A named number with its range and unit, and the two ways in which a caller can get it wrong.
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace plumbline::reference {

/// Range: [low, high], without an end that is marked open; every value must be finite whatever the range says.
struct Parameter {
  std::string key;
  double value = 0;  // the default
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;
  std::string unit;  // "1" for a pure number
  std::string description;
};

/// A value outside its range, or one that the other values forbid.
class ParameterError : public std::invalid_argument {
 public:
  ParameterError(std::string key_, double value_, std::string allowed_);
  std::string key;
  double value;
  std::string allowed;  // for people: "(1, inf), unit 1"
};

/// A key that no parameter has.
class UnknownParameter : public std::invalid_argument {
 public:
  UnknownParameter(std::string key_, std::vector<std::string> known_);
  std::string key;
  std::vector<std::string> known;
};

/// The range and unit for people: "(0, inf) kg/m^3".
std::string allowed_text(const Parameter& parameter);

/// Throws ParameterError unless `value` is finite and within the range.
void check(const Parameter& parameter, double value);

/// All parameters with the chosen values in place of the defaults.
/// Throws UnknownParameter or ParameterError.
std::map<std::string, double> complete(const std::vector<Parameter>& parameters,
                                       const std::map<std::string, double>& chosen);

}  // namespace plumbline::reference
