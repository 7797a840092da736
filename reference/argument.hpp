#pragma once
// Ranges that the arguments of many references share. Each throws ParameterError with the key.
#include <string>

#include "reference/bounded.hpp"
#include "reference/parameter.hpp"

namespace plumbline::reference {

inline void check_positive(const std::string& key, double value) {
  check({key, 0, 0, rounding::infinity, true, true, "", ""}, value);
}
inline void check_not_negative(const std::string& key, double value) {
  check({key, 0, 0, rounding::infinity, false, true, "", ""}, value);
}
inline void check_finite(const std::string& key, double value) {
  check({key, 0, -rounding::infinity, rounding::infinity, true, true, "", ""}, value);
}
inline void check_within(const std::string& key, double value, double low, double high) {
  check({key, 0, low, high, false, false, "", ""}, value);
}
/// A mode is numbered from 1.
inline void check_mode(int mode) { check({"mode", 0, 1, rounding::infinity, false, true, "", ""}, mode); }

}  // namespace plumbline::reference
