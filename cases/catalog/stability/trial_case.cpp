#include "cases/catalog/stability/trial_case.hpp"

namespace plumbline {

Number error_of(const std::string& measure) { return error_at(measure, trial_level); }
Number value_of(const std::string& measure) { return value_at(measure, trial_level); }

Measure finding(std::string name, double value, std::string unit) {
  Measure measure;
  measure.name = std::move(name);
  measure.value = value;
  measure.error = value;
  measure.scale = 1;
  measure.unit = std::move(unit);
  return measure;
}

}  // namespace plumbline
