#pragma once
// Parameters and rows that the exact gas flows have in common.
#include <string>

#include "reference/catalog/parameters.hpp"
#include "reference/riemann.hpp"

namespace plumbline::reference {

inline Parameter gamma_parameter(double value) {
  return {"gamma", value, 1, rounding::infinity, true, true, "1", "ratio of specific heats"};
}
inline Parameter dimension_parameter(double value) {
  return {"dimension", value, 1, 3, false, false, "1", "1: plane, 2: cylinder, 3: sphere"};
}
inline Parameter radius_abscissa() {
  return {"radius", 0, 0, rounding::infinity, false, true, "m", "distance from the plane, axis or centre"};
}

/// The whole number 1, 2 or 3. Throws ParameterError.
inline int dimension_of(const std::map<std::string, double>& settings) {
  const double value = settings.at("dimension");
  if (value != 1 && value != 2 && value != 3) throw ParameterError("dimension", value, "1, 2 or 3");
  return static_cast<int>(value);
}

inline void add_row(Answer& answer, const std::string& abscissa, double at, const Sample& s) {
  add_row(answer, abscissa, at,
          {{"density", s.density}, {"velocity", s.velocity}, {"pressure", s.pressure}, {"energy", s.energy}});
}

}  // namespace plumbline::reference
