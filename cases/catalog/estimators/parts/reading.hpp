// What a gate of a part measures.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "cases/harness/judge/measured_gates.hpp"

namespace plumbline {

// Of the row with this id; NaN where there is none.
inline double reading(const std::vector<MeasuredGate>& rows, const std::string& id) {
  for (const MeasuredGate& row : rows) {
    if (row.gate.id == id) return row.measure().value.value_or(NAN);
  }
  return NAN;
}

}  // namespace plumbline
