#pragma once
// Parameters and rows that the exact gas flows have in common.
#include <string>

#include "reference/registry.hpp"
#include "reference/riemann.hpp"

namespace plumbline::reference {

inline Parameter positive_parameter(const std::string& key, double value, const std::string& unit,
                                    const std::string& description) {
  return {key, value, 0, rounding::infinity, true, true, unit, description};
}
inline Parameter gamma_parameter(double value) {
  return {"gamma", value, 1, rounding::infinity, true, true, "1", "ratio of specific heats"};
}
inline Parameter dimension_parameter(double value) {
  return {"dimension", value, 1, 3, false, false, "1", "1: plane, 2: cylinder, 3: sphere"};
}
inline Parameter time_parameter(double value) {
  return {"time", value, 0, rounding::infinity, false, true, "s", "time of the rows"};
}
inline Parameter radius_abscissa() {
  return {"radius", 0, 0, rounding::infinity, false, true, "m", "distance from the plane, axis or centre"};
}
inline Parameter position_abscissa() {
  return {"position", 0, -rounding::infinity, rounding::infinity, true, true, "m", "position x"};
}

/// The whole number 1, 2 or 3. Throws ParameterError.
inline int dimension_of(const std::map<std::string, double>& settings) {
  const double value = settings.at("dimension");
  if (value != 1 && value != 2 && value != 3) throw ParameterError("dimension", value, "1, 2 or 3");
  return static_cast<int>(value);
}

inline void add_row(Answer& answer, const std::string& abscissa, double at, const Sample& s) {
  answer.at.push_back({{abscissa, at},
                       {"density", s.density.value},
                       {"velocity", s.velocity.value},
                       {"pressure", s.pressure.value},
                       {"energy", s.energy.value}});
  answer.at_bounds.push_back({{"density", s.density.bound},
                              {"velocity", s.velocity.bound},
                              {"pressure", s.pressure.bound},
                              {"energy", s.energy.bound}});
}

}  // namespace plumbline::reference
