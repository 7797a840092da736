// What a run measured and drew, by name.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "cases/harness/run/experiment.hpp"

namespace plumbline {

inline const Measure& measure(const RunResult& result, const std::string& name) {
  if (const Measure* found = result.find(name)) return *found;
  throw std::out_of_range("the run has no measure " + name);
}

inline const std::vector<double>& column_of(const RunResult& result, const std::string& name) {
  if (const ProfileColumn* column = result.profile.find(name)) return column->values;
  throw std::out_of_range("the profile has no column " + name);
}

}  // namespace plumbline
